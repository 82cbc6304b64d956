/* Written by `make laws` from the laws: change those and run it again. */
extern const char digest_of_laws[];
const char digest_of_laws[] = "89c61d577f83964fd61220e295746431a4e0c70bf74b45021b6160eb83d32f29";
