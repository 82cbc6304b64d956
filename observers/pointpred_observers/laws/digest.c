/* Written by `make laws` from the laws: change those and run it again. */
extern const char digest_of_laws[];
const char digest_of_laws[] = "62da861db8541fcb3c7aaf352603553ad8cbee366381a88026b6f9044773233b";
