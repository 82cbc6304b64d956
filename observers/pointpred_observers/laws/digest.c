/* Written by `make laws` from the laws: change those and run it again. */
extern const char digest_of_laws[];
const char digest_of_laws[] = "20fefd21601b70c4e927768c5f360e9d7d431fae3a5a17b97fc32fdc011899e2";
