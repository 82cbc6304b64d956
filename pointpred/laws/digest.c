/* Written by `make laws` from the laws: change those and run it again. */
extern const char digest_of_laws[];
const char digest_of_laws[] = "226c42598e9158b8a8f8eb880f1b33450da51607748be9bd856fa87f02ff31d1";
