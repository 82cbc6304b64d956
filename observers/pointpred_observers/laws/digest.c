/* Written by `make laws` from the laws: change those and run it again. */
extern const char digest_of_laws[];
const char digest_of_laws[] = "a19e9c57284f19cfcb2e32a6d987161352001d082efe7925efabc72c7d88d33f";
