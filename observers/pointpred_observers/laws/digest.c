/* Written by `make laws` from the laws: change those and run it again. */
extern const char digest_of_laws[];
const char digest_of_laws[] = "5b34e1bfaa3d4ea63bde4cb1629e8750e849fe13ae57a4e97150fc066f0aaa62";
