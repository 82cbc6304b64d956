/* Written by `make laws` from the laws: change those and run it again. */
extern const char digest_of_laws[];
const char digest_of_laws[] = "fa695565028345a761b61d880b9d50c0f83c3e859364620e00249b0a23824c6c";
