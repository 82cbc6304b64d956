/* Written by `make laws` from the laws: change those and run it again. */
extern const char digest_of_laws[];
const char digest_of_laws[] = "31950e3adfde40a53dde27c1cdac50722408801092d577f51bcf1e965de5513e";
