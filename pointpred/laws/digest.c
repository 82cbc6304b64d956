/* Written by `make laws` from the laws: change those and run it again. */
extern const char digest_of_laws[];
const char digest_of_laws[] = "f85358a44c7b357cf16fdaf1f8adbef02bdea57f70b6a0ad4c822cdb99563137";
