/* Written by `make laws` from the laws: change those and run it again. */
extern const char digest_of_laws[];
const char digest_of_laws[] = "83d80fd33c49a1f4c642991bca8d2f5006abe949f4a38056f22e1da1a65abc05";
