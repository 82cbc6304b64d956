/* Written by `make laws` from the laws: change those and run it again. */
extern const char digest_of_laws[];
const char digest_of_laws[] = "6e7f47e005fdb3635131c9c8d8bc81057ace65087d796b103cdcb4701e4abb78";
