/* Written by `make laws` from the laws: change those and run it again. */
extern const char digest_of_laws[];
const char digest_of_laws[] = "6f00d93bb792cf4069cff0d5aead582628ec5d6c1c2fef995002f1dfd6f790f4";
