/* Written by `make laws` from the laws: change those and run it again. */
extern const char digest_of_laws[];
const char digest_of_laws[] = "bf74f542fc34ce20eac10fa0dba26d92502b4ee46b01b675cc4eed0e06794438";
