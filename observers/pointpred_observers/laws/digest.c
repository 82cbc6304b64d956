/* Written by `make laws` from the laws: change those and run it again. */
extern const char digest_of_laws[];
const char digest_of_laws[] = "1c80c3974490414d3ff2a79f5c789c07480d715f33694570392641d88fb949ed";
