/* Written by `make laws` from the laws: change those and run it again. */
extern const char digest_of_laws[];
const char digest_of_laws[] = "dc9d15ff680b938e919f0a4863bea78c19a8a45129f081e522340d0b4bcff592";
