/* Written by `make laws` from the laws: change those and run it again. */
extern const char digest_of_laws[];
const char digest_of_laws[] = "f6d7d67b45c3c2c749cb0fcb3dc6c1ff587774ffebee2cbeb377818c7633f688";
