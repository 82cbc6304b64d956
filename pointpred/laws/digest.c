/* Written by `make laws` from the laws: change those and run it again. */
extern const char digest_of_laws[];
const char digest_of_laws[] = "67ce1ae7a961e053c7b0c9c924fe14ba42456a7af2cc2ca207a5e45b31c0232d";
