/* Written by `make laws` from the laws: change those and run it again. */
#ifndef POINTPRED_LAWS
#define POINTPRED_LAWS
/* Arrays are their first number and how many there are; a table's rows lie one behind the other. */
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

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

typedef struct { double f0; double f1; double f2; double f3; double f4; double f5; double f6; double f7; double f8; } T9d;
typedef struct { double t; double x; double y; double wx; double wy; double wz; double ax; double ay; double az; } camera_samples_SampleRow;
typedef struct { double f0; double f1; } T2d;
typedef struct { double x; double y; double wx; double wy; double wz; double az; } camera_depth_Measured;
typedef struct { double f0; double f1; double f2; double f3; double f4; } T5d;
typedef struct { double f0; double f1; double f2; double f3; double f4; double f5; double f6; } T7d;
typedef struct { double f0; double f1; double f2; } T3d;
typedef struct { double f0; double f1; double f2; double f3; } T4d;
typedef struct { double t; double x; double y; double eta; double wx; double wy; double wz; } camera_unknown_input_filter_FlowRow;
typedef struct { int64_t f0; int64_t f1; int64_t f2; } T3q;
static inline camera_unknown_input_filter_FlowRow camera_unknown_input_filter_FlowRow_of_T7d(T7d value) { return (camera_unknown_input_filter_FlowRow){value.f0, value.f1, value.f2, value.f3, value.f4, value.f5, value.f6}; }
static inline camera_samples_SampleRow camera_samples_SampleRow_of_T9d(T9d value) { return (camera_samples_SampleRow){value.f0, value.f1, value.f2, value.f3, value.f4, value.f5, value.f6, value.f7, value.f8}; }
T9d camera_camera_stage_sample_at(Table rows, int64_t i);
bool camera_camera_stage_usable(camera_samples_SampleRow sample, double started, double last_t, double gap_s);
void camera_depth_carry(Vector memory, camera_depth_Measured m, double dt);
bool camera_depth_inside(Vector memory, double zero, double eta);
T2d camera_depth_rate(double chi, double r, camera_depth_Measured m, double dwx, double dwy);
T7d camera_depth_step(Vector memory, T9d sample);
void camera_kinematics_add_noise(Vector memory, int64_t at, int64_t state, double gyro, double accel);
T3d camera_kinematics_back(T3d turn, T3d vector);
void camera_kinematics_carry(Vector memory, int64_t at, int64_t stride, double h, T3d turn);
void camera_kinematics_push(Vector memory, int64_t at, double h, T3d turn, T3d before, T3d after);
void camera_kinematics_turn_covariance(Vector memory, int64_t at, double h, T3d turn);
void camera_point_filter_correct(Vector memory, double measured, int64_t axis, double x, double y, double z);
void camera_point_filter_look(Vector memory, double x, double y);
void camera_point_filter_predict(Vector memory, double dt, T3d w, T3d a);
void camera_point_filter_step(Vector memory, Vector row, Vector out);
void camera_starting_begin(Vector memory, int64_t at);
bool camera_starting_factor(Vector memory, int64_t m);
void camera_starting_solve(Vector memory, int64_t m, int64_t v);
bool camera_starting_start(Vector memory, int64_t at, int64_t state, int64_t p, double variance, double share);
void camera_starting_take(Vector memory, int64_t at, double x, double y, double variance);
T2d camera_unknown_input_filter_flow(double x, double y, double eta, double wx, double wy, double wz);
void camera_unknown_input_filter_predict(Vector memory, double eta, double wx, double wy, double wz, double h);
T7d camera_unknown_input_filter_row_at(Table rows, int64_t i);
T4d camera_unknown_input_filter_step(Vector memory, T7d row);
int64_t interconnected_persidskii_law_advance(Vector memory, Vector row);
void interconnected_persidskii_law_bridge(Vector memory, int64_t w, Vector row, double length, double h, int64_t absent);
int64_t interconnected_persidskii_law_floats(int64_t q, int64_t k, int64_t inputs);
void interconnected_persidskii_law_flow(Vector memory, int64_t w, Vector row, double begin, double h);
int64_t interconnected_persidskii_law_injected_at(int64_t q, int64_t k, int64_t inputs, int64_t outputs);
void interconnected_persidskii_law_move(Vector memory, Vector row, int64_t w, int64_t absent, bool missing);
double interconnected_persidskii_law_onward(Vector memory, int64_t j, int64_t w, int64_t inputs, int64_t nonlinear);
void interconnected_persidskii_law_read(Vector memory, Vector out);
void interconnected_persidskii_law_replace(Vector memory, int64_t w, int64_t inputs, int64_t nonlinear, int64_t absent);
int64_t interconnected_persidskii_law_replaced_at(int64_t q, int64_t k, int64_t inputs, int64_t outputs);
int64_t interconnected_persidskii_law_room(int64_t q, int64_t k, int64_t inputs);
void interconnected_persidskii_law_slope(Vector memory, int64_t w, int64_t inputs, int64_t nonlinear, int64_t to);
int64_t interconnected_persidskii_law_start_at(int64_t q, int64_t k, int64_t inputs, int64_t outputs);
int64_t interconnected_persidskii_law_state_at(int64_t q, int64_t k, int64_t inputs, int64_t outputs);
int64_t interconnected_persidskii_law_step(Vector memory, Vector row, Vector out);
void loop__camera_point_filter_step(Vector memory, int64_t first, FlagVector begin, Table rows, Table out);
void loop__stage_learn_nothing__camera_camera_stage_sample_at__camera_depth_step(Vector memory, int64_t first, FlagVector begin, Table rows, Table out);
double nonlinearity_value(double code, double s);
void regression_gradient_descend_along(Vector memory, T3q at, int64_t n, double output, double h);
bool regressors_gradient_finite(Vector row);
void regressors_gradient_flow(Vector memory, int64_t n, int64_t p, int64_t sample, double h);
void regressors_gradient_jump(Vector memory, int64_t n, int64_t p, int64_t sample, double share);
int64_t regressors_gradient_state_at(int64_t n);
int64_t regressors_gradient_states(int64_t n, int64_t p);
double regressors_gradient_steepness(Vector memory, Vector row, int64_t n, int64_t p);
int64_t regressors_gradient_step(Vector memory, Vector row, Vector out);
int64_t regressors_gradient_width(int64_t n, int64_t p);
void regressors_nonlinear_regression_flow(Vector memory, Vector row, double begin, double h, double dt);
double regressors_nonlinear_regression_pace(Vector sample, int64_t at, int64_t n, int64_t r);
void regressors_nonlinear_regression_slope(Vector memory, int64_t theta, int64_t sample, int64_t to);
int64_t regressors_nonlinear_regression_states(int64_t n, int64_t r);
int64_t regressors_nonlinear_regression_step(Vector memory, Vector row, Vector out);
int64_t regressors_nonlinear_regression_width(int64_t n, int64_t r);
void stage_learn_nothing(Vector memory);
double triangular_interlaced_observer_drive(Vector memory, int64_t i, int64_t k, double passed, double share, Vector row);
void triangular_interlaced_observer_follow(Vector memory, int64_t matrix, double h, int64_t steps, Vector row, bool driven);
int64_t triangular_interlaced_observer_settings(int64_t q, int64_t p);
int64_t triangular_interlaced_observer_states(int64_t q, int64_t p);
int64_t triangular_interlaced_observer_step(Vector memory, Vector row, Vector out);
double triangular_program_apply(int64_t code, double a, double b);
void triangular_program_execute(Vector memory, int64_t first, int64_t count);
#endif
