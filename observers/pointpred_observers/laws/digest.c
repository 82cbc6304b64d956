/* Written by `make laws` from the laws: change those and run it again. */
extern const char digest_of_laws[];
const char digest_of_laws[] = "462f58ed91ba8db6c3e8d36c877037e7bb43ac82d13a3c4e5125ef3f76330e82";
