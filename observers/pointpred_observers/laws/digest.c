/* Written by `make laws` from the laws: change those and run it again. */
extern const char digest_of_laws[];
const char digest_of_laws[] = "a0675cff28d0c62879057f1ebec75912500da2c17e0526c41a75f9809a43ce24";
