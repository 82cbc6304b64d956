/* Written by `make laws` from the laws: change those and run it again. */
extern const char digest_of_laws[];
const char digest_of_laws[] = "d402c83ef6c32e135e2476486412c536c1ba17d79bff52ca9e03590700a2deb9";
