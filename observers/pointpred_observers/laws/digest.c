/* Written by `make laws` from the laws: change those and run it again. */
extern const char digest_of_laws[];
const char digest_of_laws[] = "24419703037e80f75ccbe8ea6ba980931d7da0d680deb0af5601d15b1dda89c8";
