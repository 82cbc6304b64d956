/* Written by `make laws` from the laws: change those and run it again. */
extern const char digest_of_laws[];
const char digest_of_laws[] = "aa1cc54c37a0cb7e4db93ced9fb7865848ad2ba84ed97864e325028eb6038b0a";
