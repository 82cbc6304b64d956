/* Written by `make laws` from the laws: change those and run it again. */
extern const char digest_of_laws[];
const char digest_of_laws[] = "4a0ba0651a6fcf6e6403fb543ff08e02767ce9eebabd87c5b4518281799a426e";
