/* Written by `make laws` from the laws: change those and run it again. */
extern const char digest_of_laws[];
const char digest_of_laws[] = "bd040c4a22e2fb89ac94fb1fad39bb949774adf019e2b469fe09d12773372d30";
