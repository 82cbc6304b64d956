/* Written by `make laws` from the laws: change those and run it again. */
extern const char digest_of_laws[];
const char digest_of_laws[] = "99f3a8b10da95908ef75fffd6e7e3ee8d9a620c6ee1708fbea7519e839ac42f0";
