/* Written by `make laws` from the laws: change those and run it again. */
extern const char digest_of_laws[];
const char digest_of_laws[] = "673d66c24a1a308261aff517c52758f99bbf692c1e30f4a8395b4e76a38e9d73";
