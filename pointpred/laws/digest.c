/* Written by `make laws` from the laws: change those and run it again. */
extern const char digest_of_laws[];
const char digest_of_laws[] = "bc4347201470a6978242b1034eef9ea9fc73292b797b2d54930f55d1f01de200";
