/* Written by `make laws` from the laws: change those and run it again. */
extern const char digest_of_laws[];
const char digest_of_laws[] = "d3f722383adb5f9853d6e2d6eb01ac54b2e02f21be50f6a78cf16df6e44ad1db";
