/* Written by `make laws` from the laws: change those and run it again. */
extern const char digest_of_laws[];
const char digest_of_laws[] = "b5d24dddae19f9fe78194e5025a5a1bb9b70f011f95411b41f80e33c72d34c11";
