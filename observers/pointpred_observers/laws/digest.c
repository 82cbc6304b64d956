/* Written by `make laws` from the laws: change those and run it again. */
extern const char digest_of_laws[];
const char digest_of_laws[] = "36c9b23f05030045912b2c492cc2370923dcc5aec37508f2a56dc43ced435e2a";
