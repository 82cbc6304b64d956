/* Written by `make laws` from the laws: change those and run it again. */
extern const char digest_of_laws[];
const char digest_of_laws[] = "11ba46f9b5a319c493303e478646f0abde1cee5888b883137edbc19738feb48f";
