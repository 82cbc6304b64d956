/* Written by `make laws` from the laws: change those and run it again. */
extern const char digest_of_laws[];
const char digest_of_laws[] = "fe6e83b468233a2bc3d2976acbb4b231ac47d11ac834b3e6ccc621ed85d5399a";
