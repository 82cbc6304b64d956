/* Written by `make laws` from the laws: change those and run it again. */
extern const char digest_of_laws[];
const char digest_of_laws[] = "37568e823dbb7ab9d809581309973edede6daf7cbf204938a339fe9d07a97944";
