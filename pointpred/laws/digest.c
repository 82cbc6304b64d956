/* Written by `make laws` from the laws: change those and run it again. */
extern const char digest_of_laws[];
const char digest_of_laws[] = "74bf23749bc1d9adff78400318a0a0f888936eda4da66a0a847da7ec90ac6e47";
