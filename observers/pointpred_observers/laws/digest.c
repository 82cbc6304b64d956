/* Written by `make laws` from the laws: change those and run it again. */
extern const char digest_of_laws[];
const char digest_of_laws[] = "f05a5bbb830baa4300392d1e0bd3c185d9eee63e00e0c5912bba2708b8559b18";
