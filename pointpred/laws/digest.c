/* Written by `make laws` from the laws: change those and run it again. */
extern const char digest_of_laws[];
const char digest_of_laws[] = "c28ae4fd0da140bd9e6737dd168a3a0f71e5dd9df1a2fa4bed59e3c7102b8643";
