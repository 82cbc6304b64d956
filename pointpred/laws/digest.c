/* Written by `make laws` from the laws: change those and run it again. */
extern const char digest_of_laws[];
const char digest_of_laws[] = "c6d977e95656d4fb94b986571c2d173ffe545102babe2097645574b1e87f3d7d";
