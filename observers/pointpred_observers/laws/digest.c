/* Written by `make laws` from the laws: change those and run it again. */
extern const char digest_of_laws[];
const char digest_of_laws[] = "095a90a46bbb006f850a89e819cff0225c50c350af927685779bc7bee5984101";
