/* Written by `make laws` from the laws: change those and run it again. */
extern const char digest_of_laws[];
const char digest_of_laws[] = "91bb7932d187f3d74a8fc44886c7ff0a751683c158ea02ad57bda80f17981487";
