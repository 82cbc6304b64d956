/* Written by `make laws` from the laws: change those and run it again. */
extern const char digest_of_laws[];
const char digest_of_laws[] = "485b66d182108bb82524d03a1d7fb4116ed9d9169d4eda2e3afa6db286ec2680";
