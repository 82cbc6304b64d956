/* Written by `make laws` from the laws: change those and run it again. */
extern const char digest_of_laws[];
const char digest_of_laws[] = "34080ad1a2bde3c67e5736d7b4c8766c493e3d0dd2c7cebeb7e243e271e7239b";
