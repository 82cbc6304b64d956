/* Written by `make laws` from the laws: change those and run it again. */
extern const char digest_of_laws[];
const char digest_of_laws[] = "59ff487227cfd764fdc33f690e221bd05dffd702ba12d713f0a17fda1bef0981";
