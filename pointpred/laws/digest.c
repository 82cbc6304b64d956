/* Written by `make laws` from the laws: change those and run it again. */
extern const char digest_of_laws[];
const char digest_of_laws[] = "1389292d205fb408bde020f4779a1e4b2575a34a7695ca9d795c7a46b129f85d";
