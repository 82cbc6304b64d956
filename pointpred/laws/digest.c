/* Written by `make laws` from the laws: change those and run it again. */
extern const char digest_of_laws[];
const char digest_of_laws[] = "563808fdfdde056d7821a07115ffd3a344e30d84ff81ec668ec65232775d45a9";
