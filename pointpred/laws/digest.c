/* Written by `make laws` from the laws: change those and run it again. */
extern const char digest_of_laws[];
const char digest_of_laws[] = "4e693c8f2e99aadc9eaf2129cbe5b385b60ca8ff7ae6dc7f01e9213ec084ec99";
