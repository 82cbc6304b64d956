/* Written by `make laws` from the laws: change those and run it again. */
extern const char digest_of_laws[];
const char digest_of_laws[] = "f7d8e509fd8c03ba075e594506dd25c8733cffe682c4ab31fe1aaa00fe30810c";
