/* Written by `make laws` from the laws: change those and run it again. */
extern const char digest_of_laws[];
const char digest_of_laws[] = "1711918e73d4be3079291f2912706d5573ff5a05efbd558a2374bed3c56fbfbd";
