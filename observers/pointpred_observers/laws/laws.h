/* Written by `make laws` from the laws: change those and run it again. */
#ifndef POINTPRED_LAWS
#define POINTPRED_LAWS
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

typedef struct { double f0; double f1; } T2d;
typedef struct { double x; double y; double wx; double wy; double wz; double az; } camera_depth_Measured;
typedef struct { double f0; double f1; double f2; double f3; double f4; } T5d;
typedef struct { double t; double x; double y; double wx; double wy; double wz; double ax; double ay; double az; } camera_samples_CameraSample;
typedef struct { double f0; double f1; double f2; } T3d;
typedef struct { T3d f0; T3d f1; } T2_T3d_;
typedef struct { Vector codes; Table inner; Table change; Table shown; Table missing; Vector start; Vector valued; Vector first; } interconnected_persidskii_law_Matrices;
typedef struct { Vector clock; Vector both; Vector total; Vector stage; Vector change; Vector first; Vector nonlinear; Vector absent; } interconnected_persidskii_law_State;
typedef struct { interconnected_persidskii_law_Matrices f0; interconnected_persidskii_law_State f1; } T_interconnected_persidskii_law_Matrices__interconnected_persidskii_law_State_;
typedef struct { Vector start; Table gain; Vector clock; Vector theta; Vector last; Vector between; Vector stage; Vector change; Vector total; } regressors_gradient_Parts;
typedef struct { Table D; Vector y; } regressors_gradient_Sample;
typedef struct {
  double started;
  double t;
  double x;
  double y;
  double wx;
  double wy;
  double wz;
  double az;
  double chi;
  double r;
  double imaged;
  double lost;
} camera_depth_State;
typedef struct {
  double focal_px;
  double decay;
  double start_chi;
  double start_eta;
  double gap_s;
  double box[5][2];
} camera_depth_Settings;
typedef struct {
  camera_depth_Settings settings;
  camera_depth_State state;
} camera_depth_Memory;
typedef struct {
  double m[6][6];
} camera_kinematics_Matrix;
typedef struct {
  camera_kinematics_Matrix phi;
  double g[6];
  camera_kinematics_Matrix normal;
  double right[6];
  camera_kinematics_Matrix noise;
  camera_kinematics_Matrix lower;
  double first[6];
  double now[6];
  double row[6];
  camera_kinematics_Matrix spread;
} camera_kinematics_Start;
typedef struct {
  double started;
  double t;
  double wx;
  double wy;
  double wz;
  double ax;
  double ay;
  double az;
  double mode;
  double restarts;
  double state[6];
  camera_kinematics_Matrix spread;
  double column[6];
  camera_kinematics_Start start;
} camera_point_filter_State;
typedef struct {
  double focal_px;
  double noise;
  double gyro;
  double accel;
  double share;
  double gap_s;
} camera_point_filter_Settings;
typedef struct {
  camera_point_filter_Settings settings;
  camera_point_filter_State state;
} camera_point_filter_Memory;
typedef struct {
  double t;
  double state[6];
  camera_kinematics_Matrix spread;
  double restarts;
  double running;
} camera_point_filter_Answer;
typedef struct {
  double g;
  double up[3];
  double gap_s;
} camera_samples_Settings;
typedef struct {
  double started;
  double t;
  double wx;
  double wy;
  double wz;
  double up[3];
} camera_samples_State;
typedef struct {
  camera_samples_Settings settings;
  camera_samples_State state;
} camera_samples_Memory;
typedef struct {
  double started;
  double t;
  double imaged;
  double x;
  double y;
  double dx;
  double dy;
  double kx;
  double ky;
  double p00;
  double p01;
  double p11;
} camera_velocity_State;
typedef struct {
  double focal_px;
  double noise;
  double density;
} camera_velocity_Settings;
typedef struct {
  camera_velocity_Settings settings;
  camera_velocity_State state;
} camera_velocity_Memory;
typedef struct {
  double states;
  double components;
  double inputs;
  double outputs;
  double discrete;
  double step_s;
  double gap_s;
  double bridged_s;
  double rest[];
} interconnected_persidskii_law_Memory;
typedef struct {
  double count;
  double outputs;
  double width;
  double kind;
  double code;
  double steepest;
  double rest[];
} regressors_gradient_Memory;
void camera_depth_carry(camera_depth_State * state, camera_depth_Measured m, double dt);
bool camera_depth_inside(camera_depth_Memory * memory, double zero, double eta);
T2d camera_depth_rate(double chi, double r, camera_depth_Measured m, double dwx, double dwy);
void camera_depth_step(camera_depth_Memory * memory, Vector row, Vector out);
void camera_kinematics_add_noise(camera_kinematics_Matrix * p, Vector s, double gyro, double accel);
T3d camera_kinematics_back(T3d turn, T3d vector);
void camera_kinematics_begin_start(camera_kinematics_Start * s);
T2_T3d_ camera_kinematics_carried(T3d p, T3d v, double h, T3d turn);
void camera_kinematics_carry(Vector s, double h, T3d turn);
void camera_kinematics_carry_column(camera_kinematics_Matrix * phi, int64_t i, double h, T3d turn);
bool camera_kinematics_factor(camera_kinematics_Matrix * lower);
void camera_kinematics_propagate(Vector s, camera_kinematics_Matrix * p, double h, T3d turn, T2_T3d_ a, double gyro, double accel);
void camera_kinematics_push(Vector s, double h, T3d turn, T3d before, T3d after);
void camera_kinematics_solve(camera_kinematics_Matrix * lower, Vector v);
bool camera_kinematics_started(camera_kinematics_Start * s, Vector state, camera_kinematics_Matrix * spread, double variance, double share);
void camera_kinematics_take_image(camera_kinematics_Start * s, double x, double y, double variance);
void camera_kinematics_turn_covariance(camera_kinematics_Matrix * p, double h, T3d turn);
void camera_point_filter_correct(camera_point_filter_State * s, double noise, double measured, int64_t axis, T3d predicted);
void camera_point_filter_look(camera_point_filter_Memory * memory, double x, double y);
void camera_point_filter_predict(camera_point_filter_Memory * memory, double dt, T3d w, T3d a);
void camera_point_filter_step(camera_point_filter_Memory * memory, Vector row, camera_point_filter_Answer * out);
void camera_samples_step(camera_samples_Memory * memory, Vector row, Vector out);
bool camera_samples_usable(camera_samples_CameraSample sample, double started, double last_t, double gap_s);
T2d camera_velocity_flow(double x, double y, double eta, double wx, double wy, double wz);
void camera_velocity_predict(camera_velocity_State * s, double density, double eta, double wx, double wy, double wz, double h);
void camera_velocity_step(camera_velocity_Memory * memory, Vector row, Vector out);
int64_t interconnected_persidskii_law_advance(interconnected_persidskii_law_Memory * memory, interconnected_persidskii_law_Matrices m, interconnected_persidskii_law_State s, Vector row);
double interconnected_persidskii_law_along(double total, Vector row, Vector vector);
double interconnected_persidskii_law_along_all(Vector row, Vector w, Vector nonlinear, Vector inputs);
double interconnected_persidskii_law_along_both(double total, Vector row, Vector one, Vector other);
void interconnected_persidskii_law_bend(interconnected_persidskii_law_Matrices m, Vector w, Vector inputs, Vector to);
void interconnected_persidskii_law_flow(interconnected_persidskii_law_Matrices m, interconnected_persidskii_law_State s, Vector row, double length, double h, bool missing);
void interconnected_persidskii_law_measure(interconnected_persidskii_law_State s, Vector last, Vector row);
void interconnected_persidskii_law_move(interconnected_persidskii_law_Memory * memory, interconnected_persidskii_law_Matrices m, interconnected_persidskii_law_State s, Vector row, bool missing);
T_interconnected_persidskii_law_Matrices__interconnected_persidskii_law_State_ interconnected_persidskii_law_parts_of(interconnected_persidskii_law_Memory * memory);
void interconnected_persidskii_law_replace(interconnected_persidskii_law_Matrices m, Vector w, Vector inputs, Vector nonlinear, Vector absent);
void interconnected_persidskii_law_slope(interconnected_persidskii_law_Matrices m, Vector w, Vector inputs, Vector nonlinear, Vector to);
int64_t interconnected_persidskii_law_step(interconnected_persidskii_law_Memory * memory, Vector row, Vector out);
void loop__camera_depth_step(Vector memory, int64_t first, FlagVector begin, Table rows, Table out);
void loop__camera_point_filter_step(Vector memory, int64_t first, FlagVector begin, Table rows, Table out);
void loop__camera_samples_step(Vector memory, int64_t first, FlagVector begin, Table rows, Table out);
void loop__camera_velocity_step(Vector memory, int64_t first, FlagVector begin, Table rows, Table out);
bool plants_boxes_weigh(Table axes, Vector p, Vector weights);
static inline double plants_nonlinearity_value(double code, double s);
void regression_gradient_descend_along(Vector theta, Vector w, Table gain, double output, double h);
void regressors_gradient_bend(double code, regressors_gradient_Parts s, Vector new, double begin, double h, double dt);
void regressors_gradient_flow(regressors_gradient_Parts s, double h);
void regressors_gradient_jump(regressors_gradient_Parts s);
regressors_gradient_Parts regressors_gradient_parts_of(regressors_gradient_Memory * memory);
regressors_gradient_Sample regressors_gradient_sample_of(Vector numbers, int64_t n);
void regressors_gradient_slope(double code, regressors_gradient_Parts s);
double regressors_gradient_steepness(Table d, Table gain);
int64_t regressors_gradient_step(regressors_gradient_Memory * memory, Vector row, Vector out);
void unknown_input_stage_estimated(Vector block, Table ends, double s, Table space);
bool unknown_input_stage_mix(Table corners, Table axes, Vector p, Vector weights, Vector block);
void unknown_input_stage_push(Vector block, Table c, Table ends, double s, int64_t part, double h, Table space);
static const int64_t plants_nonlinearity_ATAN = 3;
static const int64_t plants_nonlinearity_CUBE = 5;
static const int64_t plants_nonlinearity_SATURATION = 4;
static const int64_t plants_nonlinearity_SIN = 1;
static const int64_t plants_nonlinearity_TANH = 2;

/* The nonlinearity with the given code at s. */
static inline double plants_nonlinearity_value(double code, double s) {
  if (code == plants_nonlinearity_SIN) {
    return sin(s);
  }
  if (code == plants_nonlinearity_TANH) {
    return tanh(s);
  }
  if (code == plants_nonlinearity_ATAN) {
    return atan(s);
  }
  if (code == plants_nonlinearity_SATURATION) {
    return min_float(max_float(s, -1.0), 1.0);
  }
  if (code == plants_nonlinearity_CUBE) {
    return s * s * s;
  }
  return s;
}
#endif
