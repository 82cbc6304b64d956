/* Written by `make laws` from the laws: change those and run it again. */
extern const char digest_of_laws[];
const char digest_of_laws[] = "21918420b0ea390f5a0d81a8073a076d65c656b514dee334f3991a3e1941e55b";
