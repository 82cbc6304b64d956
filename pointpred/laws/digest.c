/* Written by `make laws` from the laws: change those and run it again. */
extern const char digest_of_laws[];
const char digest_of_laws[] = "d528d4998370b8b6e71ecee5bad5bd7da5a20cc877900950ba51c055261d02cd";
