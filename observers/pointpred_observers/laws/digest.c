/* Written by `make laws` from the laws: change those and run it again. */
extern const char digest_of_laws[];
const char digest_of_laws[] = "ecc3939afa2c71b9354bc9f0f37aab03e3a7d630ae2dbd62b3a716611ad2af1f";
