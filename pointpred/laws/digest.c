/* Written by `make laws` from the laws: change those and run it again. */
extern const char digest_of_laws[];
const char digest_of_laws[] = "b2ea4e818c651b1c873ad8496768a0bcd6986bc32a6223ce388d4035fad8800e";
