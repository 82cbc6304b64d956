/* Written by `make laws` from the laws: change those and run it again. */
extern const char digest_of_laws[];
const char digest_of_laws[] = "14ec953b11d322aa9180ee2a695ef1c20acdf3e5becf6b6f2a321d5504d7faed";
