/* Arrays are their first number and how many there are; a table's rows lie one behind the other. */
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* gcc compiles laws of loops in loops for the wide registers of newer processors, too, which changes no bit.
   Not zig's clang: choosing one when it is loaded links zig's runtime, whose exp and log have other last bits. */
#if defined(__x86_64__) && defined(__GLIBC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__)
#define WIDE __attribute__((target_clones("avx2", "default")))
#else
#define WIDE
#endif

typedef struct { double *p; int64_t n; } Vector;
typedef struct { double *p; int64_t n, m; } Table;
typedef struct { int64_t *p; int64_t n; } WholeVector;
typedef struct { int64_t *p; int64_t n, m; } WholeTable;
typedef struct { bool *p; int64_t n; } FlagVector;
typedef struct { bool *p; int64_t n, m; } FlagTable;

/* An array whose size is not known before: freed where its name ends. */
#define RELEASED __attribute__((cleanup(release)))
static inline void release(void *name) { free(*(void **)name); }
static inline void *reserved(int64_t count) {
  void *memory = calloc(count > 0 ? (size_t)count : 1, 8);
  if (memory == NULL) abort();
  return memory;
}
static inline void *copied(const void *memory, size_t bytes) {
  void *copy = malloc(bytes > 0 ? bytes : 1);
  if (copy == NULL) abort();
  return memcpy(copy, memory, bytes);
}
static inline void fill(Vector part, double value) {
  for (int64_t i = 0; i < part.n; i++) part.p[i] = value;
}
static inline void fill_whole(WholeVector part, int64_t value) {
  for (int64_t i = 0; i < part.n; i++) part.p[i] = value;
}
static inline void copy_into(Vector part, Vector values) { memmove(part.p, values.p, sizeof(double) * (size_t)part.n); }
static inline void copy_whole_into(WholeVector part, WholeVector values) {
  memmove(part.p, values.p, sizeof(int64_t) * (size_t)part.n);
}

/* As Python has them. */
static inline double max_float(double a, double b) { return b > a ? b : a; }
static inline double min_float(double a, double b) { return b < a ? b : a; }
static inline int64_t max_whole(int64_t a, int64_t b) { return b > a ? b : a; }
static inline int64_t min_whole(int64_t a, int64_t b) { return b < a ? b : a; }
static inline double square(double a) { return a * a; }
static inline int64_t floor_divided_whole(int64_t a, int64_t b) {
  if (b == 0) return 0;
  int64_t quotient = a / b;
  return quotient - (a % b != 0 && (a % b < 0) != (b < 0));
}
static inline int64_t remainder_whole(int64_t a, int64_t b) {
  if (b == 0) return 0;
  int64_t rest = a % b;
  return rest != 0 && (rest < 0) != (b < 0) ? rest + b : rest;
}
static inline double remainder_float(double a, double b) {
  double rest = fmod(a, b);
  if (rest == 0.0) return b != 0.0 ? copysign(0.0, b) : rest;
  return (rest < 0) != (b < 0) ? rest + b : rest;
}
static inline double floor_divided_float(double a, double b) {
  if (b == 0.0) return a / b;
  double rest = fmod(a, b), quotient = (a - rest) / b;
  if (rest != 0.0 && (b < 0) != (rest < 0)) quotient -= 1.0;
  if (quotient == 0.0) return copysign(0.0, a / b);
  double whole = floor(quotient);
  return quotient - whole > 0.5 ? whole + 1.0 : whole;
}
static inline int64_t power_of_whole(int64_t a, int64_t n) {
  int64_t result = 1;
  for (; n > 0; n >>= 1, a *= a) if (n & 1) result *= a;
  return result;
}
static inline double whole_power(double a, int64_t n) {
  int64_t rest = n < 0 ? -n : n;
  if (rest > 0x10000) return pow(a, (double)n);
  double result = 1.0;
  for (; rest != 0; rest >>= 1, a *= a) if (rest & 1) result *= a;
  return n < 0 ? 1.0 / result : result;
}
