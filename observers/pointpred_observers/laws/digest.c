/* Written by `make laws` from the laws: change those and run it again. */
extern const char digest_of_laws[];
const char digest_of_laws[] = "b8599eaed29d562eee09166e48cd1ed2acd8963e79dd189ce8627ec122803a64";
