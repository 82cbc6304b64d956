/* Written by `make laws` from the laws: change those and run it again. */
extern const char digest_of_laws[];
const char digest_of_laws[] = "b95e02904a9f2a4a25024258eff1279865d0f3eb4b93c89b31e86d8846b16db9";
