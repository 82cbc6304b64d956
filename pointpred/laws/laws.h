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

typedef struct { double t; double x; double y; double dx; double dy; double buttons; } records_EventRow;
typedef struct { int64_t f0; double f1; double f2; double f3; bool f4; } Tq3db;
typedef struct { double f0; double f1; double f2; double f3; double f4; double f5; double f6; double f7; double f8; double f9; } T10d;
typedef struct { double f0; double f1; } T2d;
typedef struct { T2d f0; T2d f1; } T2_T2d_;
typedef struct { int64_t f0; double f1; } Tqd;
typedef struct { double f0; double f1; double f2; } T3d;
typedef struct { double f0; double f1; double f2; double f3; } T4d;
typedef struct { double f0; double f1; double f2; double f3; double f4; } T5d;
typedef struct { double f0; double f1; double f2; double f3; double f4; double f5; } T6d;
typedef struct { double x; double y; double ux; double uy; double wide; double broad; double tail; } predictors_adaptation_destination_Heading;
typedef struct { double ahead; double wide; double broad; double tail; } predictors_adaptation_distances_Ahead;
typedef struct { predictors_adaptation_destination_Heading f0; double f1; } T_predictors_adaptation_destination_Heading_d;
typedef struct { predictors_adaptation_destination_Heading f0; predictors_adaptation_destination_Heading f1; } T2_predictors_adaptation_destination_Heading_;
typedef struct { int64_t f0; bool f1; } Tqb;
typedef struct { T6d f0; T6d f1; } T2_T6d_;
typedef struct { double f0; double f1; double f2; double f3; double f4; double f5; double f6; } T7d;
typedef struct { double mixed; double predicted; } predictors_adaptation_time_left_Estimates;
typedef struct { double done; double left; } predictors_adaptation_time_left_Way;
typedef struct { double of_peak; double slow_s; } predictors_adaptation_time_left_Pace;
typedef struct { int64_t f0; int64_t f1; int64_t f2; } T3q;
typedef struct { double t; double x; double y; double vx; double vy; double ax; double ay; double settled; double start; double counts; } records_MotionRow;
typedef struct { int64_t f0; bool f1; double f2; } Tqbd;
typedef struct { double t; double x; double y; double path; } predictors_kinematic_history_Point;
typedef struct { int64_t f0; predictors_kinematic_history_Point f1; } Tq_predictors_kinematic_history_Point_;
typedef struct { double reach; double hand; double ux; double uy; } predictors_kinematic_features_Frame;
typedef struct { double f0; double f1; double f2; double f3; double f4; double f5; double f6; double f7; double f8; double f9; double f10; double f11; } T12d;
typedef struct { int64_t f0; predictors_kinematic_features_Frame f1; } Tq_predictors_kinematic_features_Frame_;
typedef struct { int64_t f0; int64_t f1; } T2q;
typedef struct { int64_t f0; int64_t f1; int64_t f2; int64_t f3; int64_t f4; } T5q;
typedef struct { double key; double x; double y; } scene_Scene;
typedef struct { int64_t f0; double f1; double f2; } Tq2d;
typedef struct { double c0; double c1; double c2; double c3; double c4; } predictors_kep_Quartic;
typedef struct { Vector w; Vector z; Table R; } regression_least_squares_Regression;
typedef struct { double f0; double f1; double f2; double f3; double f4; double f5; double f6; double f7; double f8; double f9; double f10; double f11; double f12; double f13; double f14; double f15; double f16; double f17; double f18; double f19; double f20; double f21; } T22d;
typedef struct { bool f0; double f1; double f2; double f3; } Tb3d;
typedef struct { Vector w; Vector largest; Vector theta; Vector Y; Vector mixed; Table Phi; Vector scratch; Vector past; } regression_drem_Regression;
typedef struct { bool f0; double f1; } Tbd;
typedef struct { double x; double y; double sxx; double sxy; double syy; double tail; } targets_posterior_Law;
typedef struct { double x; double y; double trail_x; double trail_y; double ux; double uy; double log_way; double log_sweep; } targets_posterior_Situation;
typedef struct { double x; double y; double u; double v; double vx; double vy; } simulation_loop_Place;
typedef struct { double f0; double f1; double f2; double f3; double f4; double f5; double f6; double f7; double f8; double f9; double f10; double f11; double f12; double f13; } T14d;
typedef struct { double noise_x; double noise_y; double late_s; double hat_x; double hat_y; } simulation_loop_Chance;
typedef struct { Table f0; Vector f1; Table f2; Vector f3; } T_Table__Vector__Table__Vector_;
typedef struct { double x; double y; double sxx; double sxy; double syy; double tail; } targets_endpoint_Ellipse;
typedef struct { Table f0; Vector f1; Vector f2; } T_Table_2_Vector_;
typedef struct { double precision; double least_lead_s; double least_way_px; } targets_decision_Settings;
typedef struct { int64_t f0; int64_t f1; int64_t f2; int64_t f3; } T4q;
typedef struct { bool f0; bool f1; } T2b;
typedef struct { Table f0; Vector f1; } T_Table__Vector_;
typedef struct { double passed; double sure; } targets_prefetch_Expected;
typedef struct { Table f0; Vector f1; Vector f2; Vector f3; } T_Table_3_Vector_;
typedef struct { double f0; double f1; double f2; double f3; double f4; double f5; double f6; double f7; } T8d;
typedef struct { double t; double dx; double dy; double off_x; double off_y; } transfer_assistance_OffsetReport;
typedef struct { double t; double dx; double dy; double off_x; double off_y; double sxx; double sxy; double syy; } transfer_assistance_GuidedReport;
typedef struct { int64_t n; int64_t linear; double forgetting; } transfer_bands_Model;
typedef struct { double f0; } Td;
typedef struct { double t; double dx; double dy; } transfer_pixels_CountsRow;
typedef struct {
  double t;
  double u[2];
  double v[2];
  double a[2];
  double span_s;
} differentiators_difference_Differences;
typedef struct {
  double metres_per_count;
  double metres_per_px;
  double gap_s;
  double pause_s;
} differentiators_sampling_Settings;
typedef struct {
  double started;
  double t;
  double x;
  double y;
  double buttons;
  double u;
  double v;
  double samples;
  double counts;
  double since;
  double last_u;
  double last_v;
} differentiators_sampling_State;
typedef struct {
  differentiators_sampling_Settings sampling;
  double shortest_s;
} differentiators_difference_Settings;
typedef struct {
  differentiators_sampling_State sampling;
  differentiators_difference_Differences last;
} differentiators_difference_State;
typedef struct {
  differentiators_difference_Settings settings;
  differentiators_difference_State state;
} differentiators_difference_Memory;
typedef struct {
  double z[8];
} differentiators_homogeneous_Axis;
typedef struct {
  differentiators_sampling_Settings sampling;
  double order;
  double alpha;
  double step_s;
  double hold;
  double settle_s;
  double gain[8];
} differentiators_homogeneous_Settings;
typedef struct {
  differentiators_homogeneous_Axis x;
  differentiators_homogeneous_Axis y;
  double slope[2];
} differentiators_homogeneous_Estimates;
typedef struct {
  differentiators_sampling_State sampling;
  differentiators_homogeneous_Estimates estimates;
} differentiators_homogeneous_State;
typedef struct {
  differentiators_homogeneous_Settings settings;
  differentiators_homogeneous_State state;
} differentiators_homogeneous_Memory;
typedef struct {
  differentiators_sampling_Settings sampling;
  double jerk_density;
  double noise;
} differentiators_kalman_Settings;
typedef struct {
  double p00;
  double p01;
  double p02;
  double p11;
  double p12;
  double p22;
} differentiators_kalman_Covariance;
typedef struct {
  double x[3];
  double y[3];
  differentiators_kalman_Covariance covariance;
} differentiators_kalman_Plane;
typedef struct {
  differentiators_sampling_State sampling;
  differentiators_kalman_Plane plane;
} differentiators_kalman_State;
typedef struct {
  differentiators_kalman_Settings settings;
  differentiators_kalman_State state;
} differentiators_kalman_Memory;
typedef struct {
  double movements;
  double offsets[3];
} predictors_adaptation_arrival_intervals_Intervals;
typedef struct {
  double count;
  double last[12];
  double belief[7];
  double weights[12][3];
} predictors_adaptation_distances_Distances;
typedef struct {
  double count;
  double last[12];
  double median;
  double errors[5];
  double movements;
  double best;
} predictors_adaptation_durations_Durations;
typedef struct {
  double products[28];
  double residuals[7];
} predictors_adaptation_time_left_Sums;
typedef struct {
  double key;
  double x;
  double y;
  double visits;
} predictors_adaptation_places_Place;
typedef struct {
  double count;
  double ended;
  predictors_adaptation_places_Place places[64];
  double history[128];
} predictors_adaptation_places_Places;
typedef struct {
  double g00;
  double g01;
  double g11;
  double r0;
  double r1;
  double total;
  double ahead;
  double bias_paid;
  double bias_size;
  double count;
  double wide;
  double broad;
  double tempo;
  double timed;
  double tempo_paid;
  double tempo_size;
} predictors_adaptation_stages_Stage;
typedef struct {
  predictors_adaptation_stages_Stage stages[5];
} predictors_adaptation_stages_Stages;
typedef struct {
  double values[5][2];
} predictors_adaptation_levels_Offsets;
typedef struct {
  double movements;
  predictors_adaptation_levels_Offsets single;
  predictors_adaptation_levels_Offsets mixed;
} predictors_adaptation_region_widening_Radii;
typedef struct {
  double known;
  double new;
  double rules[4];
  double widths[3];
  double lags[16];
} predictors_adaptation_habits_Habits;
typedef struct {
  predictors_adaptation_stages_Stages stages;
  predictors_adaptation_distances_Distances distances;
  predictors_adaptation_durations_Durations durations;
  predictors_adaptation_region_widening_Radii regions;
  predictors_adaptation_time_left_Sums time_left;
  predictors_adaptation_arrival_intervals_Intervals intervals;
  predictors_adaptation_places_Places places;
  predictors_adaptation_habits_Habits habits;
} predictors_adaptation_correction_Person;
typedef struct {
  double t;
  double x;
  double y;
} predictors_adaptation_correction_Sample;
typedef struct {
  double present;
  double t;
  double x;
  double y;
  double ux;
  double uy;
  double along;
  double across;
  double wide;
  double broad;
  double tail;
  double left;
  double reached;
} predictors_adaptation_stages_Moment;
typedef struct {
  double count;
  double apart;
  double cursor_x;
  double cursor_y;
} predictors_adaptation_moments_Series;
typedef struct {
  double share;
  double x;
  double y;
  double sxx;
  double sxy;
  double syy;
  double tail;
} predictors_mixture_PartRow;
typedef struct {
  double count;
  predictors_mixture_PartRow rows[5];
  double offsets[2];
} predictors_adaptation_mixed_region_Mixture;
typedef struct {
  double t;
  double x;
  double y;
  double sxx;
  double sxy;
  double syy;
  double tail;
  predictors_adaptation_mixed_region_Mixture mixture;
} predictors_adaptation_region_widening_Moment;
typedef struct {
  predictors_adaptation_moments_Series series;
  predictors_adaptation_region_widening_Moment moments[48];
} predictors_adaptation_region_widening_Movement;
typedef struct {
  double t;
  double left;
  double spread;
  double terms[7];
} predictors_adaptation_time_left_Moment;
typedef struct {
  double ready;
  double weights[7];
  predictors_adaptation_moments_Series series;
  predictors_adaptation_time_left_Moment moments[32];
} predictors_adaptation_time_left_Movement;
typedef struct {
  double ready;
  double returns;
  double width;
  double counts;
  double before[64];
  double now[64];
  double elsewhere;
} predictors_adaptation_destination_Movement;
typedef struct {
  double claimed;
  double time;
  double elsewhere[6];
  predictors_adaptation_mixed_region_Mixture asked;
} predictors_adaptation_mixed_region_Movement;
typedef struct {
  double started;
  double t0;
  double x0;
  double y0;
  double t;
  double x;
  double y;
  double traced;
  double samples;
  predictors_adaptation_correction_Sample trace[96];
  predictors_adaptation_stages_Moment stages[5];
  predictors_adaptation_region_widening_Movement regions;
  predictors_adaptation_time_left_Movement time_left;
  predictors_adaptation_destination_Movement destination;
  predictors_adaptation_mixed_region_Movement now;
} predictors_adaptation_correction_Movement;
typedef struct {
  double key;
  double x;
  double y;
} predictors_adaptation_correction_Window;
typedef struct {
  double distances;
  double shortest_px;
  double places;
  double sequence;
  predictors_adaptation_correction_Window scene;
} predictors_adaptation_correction_Settings;
typedef struct {
  double adapt;
  predictors_adaptation_correction_Settings adaptation;
  predictors_adaptation_correction_Window next;
} predictors_adaptation_predictor_Settings;
typedef struct {
  double known;
  double t;
  double x;
  double y;
  double t0;
  double x0;
  double y0;
  double peak;
  double path;
} predictors_movement_State;
typedef struct {
  double count;
  double t;
  double x;
  double y;
  double path;
  double peak;
  double peak_t;
  double falling;
  double low;
  double low_t;
  double low_x;
  double low_y;
  double low_path;
} predictors_kinematic_submovements_State;
typedef struct {
  double t;
  double x;
  double y;
  double way;
  double far;
  double cursor_peak;
  double peak;
  double peak_t;
  double peak_d;
  double peak_path;
  double push;
  double push_t;
  double brake;
  predictors_kinematic_submovements_State submovement;
  double fast_t;
  double moving_t;
  double moved_t;
} predictors_kinematic_track_State;
typedef struct {
  double x;
  double y;
  double path;
} predictors_kinematic_history_Tick;
typedef struct {
  double count;
  predictors_kinematic_history_Tick last;
} predictors_kinematic_history_Head;
typedef struct {
  predictors_kinematic_track_State track;
  predictors_kinematic_history_Head head;
} predictors_kinematic_features_Before;
typedef struct {
  predictors_kinematic_history_Head head;
  predictors_kinematic_history_Tick ticks[66];
} predictors_kinematic_history_State;
typedef struct {
  predictors_movement_State movement;
  predictors_kinematic_track_State track;
  predictors_kinematic_features_Before before;
  predictors_kinematic_history_State history;
} predictors_kinematic_features_State;
typedef struct {
  predictors_adaptation_predictor_Settings settings;
  predictors_adaptation_correction_Person person;
  predictors_kinematic_features_State observation;
  predictors_adaptation_correction_Movement movement;
} predictors_adaptation_predictor_Memory;
typedef struct {
  double v;
  double a;
  double sub;
  double lag[12];
} predictors_kinematic_features_Across;
typedef struct {
  double log_reach;
  double log_time;
  double time;
  double distance;
  double straightness;
  double of_farthest;
  double cursor_peak;
  double log_peak;
  double log_speed;
  double v_along;
  double a_along;
  double speed_of_peak;
  double v_aligned;
  double since_peak;
  double peak_share;
  double peak_time;
  double peak_distance;
  double peak_path;
  double mean_of_peak;
  double push;
  double brake;
  double since_push;
  double subs;
  double since_sub;
  double sub_peak;
  double speed_of_sub;
  double since_sub_peak;
  double falling;
  double sub_along;
  double sub_path;
  double jerk_ahead;
  double sub_jerk_ahead;
  double slow_for;
  double slower_for;
  double still_for;
  double log_mean;
  double stop_time;
  double stop_way;
  double lag_along[12];
  predictors_kinematic_features_Across across;
} predictors_kinematic_features_Values;
typedef struct {
  double first;
  double second;
  double mean[65];
  double scale[65];
  double rest[];
} predictors_kinematic_network_Coefficients;
typedef struct {
  double table[10][3];
} predictors_kinematic_network_Calibration;
typedef struct {
  double along;
  double across;
  double basis[5];
  double wide;
  double broad;
  double tail;
  double left;
  double spread;
} predictors_kinematic_network_Outputs;
typedef struct {
  double slope;
  double offset;
  double fall;
} predictors_delphian_Settings;
typedef struct {
  double x;
  double y;
  double unit_x;
  double unit_y;
  double fallen;
} predictors_delphian_Peak;
typedef struct {
  predictors_movement_State movement;
  predictors_delphian_Peak peak;
} predictors_delphian_State;
typedef struct {
  predictors_delphian_Settings settings;
  predictors_delphian_State state;
} predictors_delphian_Memory;
typedef struct {
  double horizon_s;
  double jerk_density;
  double noise_px;
  double gap_s;
} predictors_kalman_Settings;
typedef struct {
  predictors_movement_State movement;
  differentiators_kalman_Plane expected;
} predictors_kalman_State;
typedef struct {
  predictors_kalman_Settings settings;
  predictors_kalman_State state;
} predictors_kalman_Memory;
typedef struct {
  double samples;
  double effective;
  double residual;
} regression_least_squares_Sums;
typedef struct {
  regression_least_squares_Sums sums;
  double numbers[35];
  double coefficients[5];
} predictors_kep_Fit;
typedef struct {
  double predicted;
  double accepted;
  double x;
  double y;
} predictors_kep_Check;
typedef struct {
  double degree;
  double reach;
  double change_most;
} predictors_kep_Settings;
typedef struct {
  predictors_movement_State movement;
  predictors_kep_Fit fit;
  predictors_kep_Check check;
} predictors_kep_State;
typedef struct {
  predictors_kep_Settings settings;
  predictors_kep_State state;
} predictors_kep_Memory;
typedef struct {
  double learned_most;
  double templates_given;
  double longest;
  double shortest_px;
  double half[22];
} predictors_ktm_Settings;
typedef struct {
  double count;
  double next;
} predictors_ktm_Learned;
typedef struct {
  predictors_ktm_Settings settings;
  double rest[];
} predictors_ktm_Memory;
typedef struct {
  double sum;
  double final;
  double score;
  double smooth[22];
} predictors_ktm_Match;
typedef struct {
  double samples;
  double distance;
  double speeds[];
} predictors_ktm_Template;
typedef struct {
  double points;
  double count;
  double x;
  double y;
  double recent[22];
} predictors_ktm_Samples;
typedef struct {
  predictors_movement_State movement;
  predictors_ktm_Samples samples;
  double rest[];
} predictors_ktm_State;
typedef struct {
  double count;
  double samples[8][3];
} predictors_linear_Past;
typedef struct {
  double horizon_s;
  double window_s;
} predictors_linear_Settings;
typedef struct {
  predictors_movement_State movement;
  predictors_linear_Past past;
} predictors_linear_State;
typedef struct {
  predictors_linear_Settings settings;
  predictors_linear_State state;
} predictors_linear_Memory;
typedef struct {
  double count;
  double newest;
  double samples[];
} regression_delay_Ring;
typedef struct {
  double started;
  double t;
  double phi;
  double excitation;
} regression_drem_State;
typedef struct {
  double peak;
  double x;
  double endpoint;
  regression_drem_State regression;
  double numbers[695];
} predictors_switched_Axis;
typedef struct {
  double threshold;
  double bound;
  double delay_s;
  double gamma;
} predictors_switched_Settings;
typedef struct {
  predictors_movement_State movement;
  predictors_switched_Axis x;
  predictors_switched_Axis y;
} predictors_switched_State;
typedef struct {
  predictors_switched_Settings settings;
  predictors_switched_State state;
} predictors_switched_Memory;
typedef struct {
  double peak;
  double peak_x;
  double peak_y;
  double valley;
  double valley_x;
  double valley_y;
  double start_x;
  double start_y;
} predictors_switched_direction_Submovement;
typedef struct {
  double vx;
  double vy;
  double x;
  double y;
  double cross;
  double square_;
} predictors_switched_direction_Hand;
typedef struct {
  double rise;
  double typical_s;
  double own;
  double turn;
  double watched;
  double stopping;
} predictors_switched_direction_Settings;
typedef struct {
  predictors_movement_State movement;
  predictors_switched_direction_Submovement submovement;
  predictors_switched_direction_Hand hand;
} predictors_switched_direction_State;
typedef struct {
  predictors_switched_direction_Settings settings;
  predictors_switched_direction_State state;
} predictors_switched_direction_Memory;
typedef struct {
  double known;
  double t;
  double x;
  double y;
  double pressed;
  double t0;
  double x0;
  double y0;
  double trail_x;
  double trail_y;
  double vx;
  double vy;
  double speed;
  double slow;
  double peak;
} targets_cursor_State;
typedef struct {
  double slow[6];
  double fast[6];
  double none[2];
  double around[2];
} targets_posterior_Weights;
typedef struct {
  targets_posterior_Weights claimed;
  targets_posterior_Weights unclaimed;
} targets_posterior_Coefficients;
typedef struct {
  double standing;
  double since;
  double ended;
  double ended_at;
  double ended_since;
  double proposed;
  double retracted;
  double entered;
} targets_ledger_State;
typedef struct {
  double one[3];
  double two[3];
} simulation_hand_Stream;
typedef struct {
  double skill;
  double base_s;
  double per_bit_s;
  double one_piece;
  double reach;
  double reach_sd;
  double turn_sd;
  double curvature;
  double skew;
  double reaction_s;
  double pause_s;
  double verify_s;
  double press_s;
  double friction;
  double rate;
  double delay_s;
  double muscle_s;
  double noise;
  double tremor_m_s;
  double aim_sd;
} simulation_person_Traits;
typedef struct {
  double share;
  double duration;
  double skew;
  double turn;
  double curve;
  double until;
  double pause;
} simulation_plan_PieceDraws;
typedef struct {
  double friction;
  double rate;
  double aim_x;
  double aim_y;
  double reaction;
  double verify;
  double press;
  double count;
  simulation_plan_PieceDraws pieces[4];
} simulation_plan_Draws;
typedef struct {
  double kind;
  double numbers[7];
} transfer_functions_Function;
typedef struct {
  double share;
  double duration_s;
  double skew;
  double turn;
  double curve;
  double until;
} simulation_loop_Piece;
typedef struct {
  double period_s;
  double substeps;
  double px_per_metre;
  double metres_per_count;
  double rho;
  double strength;
  transfer_functions_Function function;
  double b1;
  double b2;
  double rate;
  double muscle_s;
  double delay_s;
  double noise;
  double tremor;
  double target_x;
  double target_y;
  double radius;
  double aim_x;
  double aim_y;
  double reaction_s;
  double verify_s;
  double press_s;
  double patience_s;
  double count;
  simulation_loop_Piece pieces[4];
} simulation_loop_Settings;
typedef struct {
  double px[2];
} transfer_pixels_Carried;
typedef struct {
  double x;
  double y;
  double u;
  double v;
} simulation_loop_Sight;
typedef struct {
  double tick;
  double phase;
  double since;
  double number;
  double amplitude;
  double angle;
  double feedback;
  double u;
  double v;
  double vx;
  double vy;
  double ax;
  double ay;
  double wander_x;
  double wander_y;
  double x;
  double y;
  double counted_x;
  double counted_y;
  transfer_pixels_Carried carried;
  transfer_pixels_Carried pulled;
  simulation_loop_Sight ring[256];
} simulation_loop_State;
typedef struct {
  simulation_loop_Settings settings;
  simulation_loop_State state;
} simulation_loop_Memory;
typedef struct {
  simulation_hand_Stream stream;
  simulation_person_Traits traits;
  simulation_plan_Draws draws;
  simulation_loop_Memory trial;
} simulation_hand_Hand;
typedef struct {
  double t;
  double x;
  double y;
  double sxx;
  double sxy;
  double syy;
  double tail;
  double answer[10];
  targets_cursor_State cursor;
} targets_heading_Moment;
typedef struct {
  double samples;
  double elsewhere;
  double released;
  double remaining_s;
  double claimed;
  double elsewhere_law[6];
  predictors_adaptation_moments_Series series;
  targets_heading_Moment moments[32];
  predictors_adaptation_time_left_Movement time_left;
} targets_heading_Movement;
typedef struct {
  double elsewhere;
  double learn;
} targets_heading_Settings;
typedef struct {
  double count;
  double ids[64];
  double kinds[64];
  double rules[5];
  double to;
  double none;
} targets_past_Past;
typedef struct {
  double total;
  double count;
} targets_arrival_Durations;
typedef struct {
  targets_past_Past past;
  predictors_adaptation_region_widening_Radii regions;
  targets_arrival_Durations durations;
  predictors_adaptation_time_left_Sums time_left;
  predictors_adaptation_arrival_intervals_Intervals intervals;
} targets_heading_Person;
typedef struct {
  targets_heading_Settings settings;
  targets_heading_Person person;
  targets_cursor_State cursor;
  targets_heading_Movement movement;
} targets_heading_Memory;
typedef struct {
  double movements;
  double proposed;
  double right;
  double hits;
  double wasted;
  double retracted;
  double entered;
} targets_ledger_Totals;
typedef struct {
  targets_ledger_Totals totals;
  targets_ledger_State movement;
  double rows;
} targets_ledger_Account;
typedef struct {
  double predicted;
  double entered;
} targets_choice_law_State;
typedef struct {
  targets_cursor_State cursor;
  double began;
} targets_prefetch_State;
typedef struct {
  double base;
  double end;
  double near;
  double far;
  double passed;
  double sure;
} targets_prefetch_Settings;
typedef struct {
  double px_per_count;
  double metres_per_count;
  double period_s;
  double gap_s;
  transfer_functions_Function function;
} transfer_pixels_Settings;
typedef struct {
  double started;
  double t;
  double gain;
  transfer_pixels_Carried carried;
} transfer_pixels_State;
typedef struct {
  transfer_pixels_Settings settings;
  transfer_pixels_State state;
} transfer_pixels_Memory;
typedef struct {
  double rho;
  double strength;
  transfer_pixels_Memory transfer;
} transfer_assistance_Assisted;
typedef struct {
  double rho;
  double strength;
  double sideways;
  double uncertain;
  double unclaimed;
} transfer_assistance_Guard;
typedef struct {
  transfer_assistance_Guard guard;
  transfer_pixels_Memory transfer;
  transfer_pixels_Carried owed;
} transfer_assistance_Guarded;
typedef struct {
  double skipped;
  regression_least_squares_Sums sums;
  double numbers[63];
  double bands[160];
  double row[7];
} transfer_identification_Learned;
typedef struct {
  double count;
  double power;
  double metres_per_count;
  double metres_per_px;
  double window_s;
  double gap_s;
  double forgetting;
  double speed_low;
  double band_width;
} transfer_identification_Settings;
typedef struct {
  double x;
  double y;
  double path;
  double duration;
  double row_x[7];
  double row_y[7];
} transfer_identification_Window;
typedef struct {
  double started;
  double t;
  double x;
  double y;
  double waiting_x;
  double waiting_y;
  transfer_identification_Window window;
} transfer_identification_State;
typedef struct {
  transfer_identification_Settings settings;
  transfer_identification_Learned learned;
  transfer_identification_State state;
} transfer_identification_Memory;
static inline records_MotionRow records_MotionRow_of_T10d(T10d value) { return (records_MotionRow){value.f0, value.f1, value.f2, value.f3, value.f4, value.f5, value.f6, value.f7, value.f8, value.f9}; }
static inline transfer_pixels_CountsRow transfer_pixels_CountsRow_of_T3d(T3d value) { return (transfer_pixels_CountsRow){value.f0, value.f1, value.f2}; }
static inline simulation_loop_Chance simulation_loop_Chance_of_T5d(T5d value) { return (simulation_loop_Chance){value.f0, value.f1, value.f2, value.f3, value.f4}; }
static inline transfer_assistance_OffsetReport transfer_assistance_OffsetReport_of_T5d(T5d value) { return (transfer_assistance_OffsetReport){value.f0, value.f1, value.f2, value.f3, value.f4}; }
static inline records_EventRow records_EventRow_of_T6d(T6d value) { return (records_EventRow){value.f0, value.f1, value.f2, value.f3, value.f4, value.f5}; }
static inline transfer_assistance_GuidedReport transfer_assistance_GuidedReport_of_T8d(T8d value) { return (transfer_assistance_GuidedReport){value.f0, value.f1, value.f2, value.f3, value.f4, value.f5, value.f6, value.f7}; }
void differentiators_difference_advance(differentiators_difference_Differences * last, int64_t axis, double u, double dt);
static inline T10d differentiators_difference_step(differentiators_difference_Memory * memory, records_EventRow event);
double differentiators_homogeneous_advance(differentiators_homogeneous_Settings * settings, differentiators_homogeneous_Axis * axis, double before, double now, double h, int64_t steps);
double differentiators_homogeneous_chatter(differentiators_homogeneous_Memory * memory, double place, double h, int64_t steps);
void differentiators_homogeneous_fill(Vector values, differentiators_homogeneous_Settings * settings);
void differentiators_homogeneous_place_poles(differentiators_homogeneous_Settings * settings, double gain_lambda, double gain_xi);
void differentiators_homogeneous_settle(differentiators_homogeneous_Memory * memory);
double differentiators_homogeneous_settling(differentiators_homogeneous_Memory * memory, double speed, double h, int64_t steps);
static inline T10d differentiators_homogeneous_step(differentiators_homogeneous_Memory * memory, records_EventRow event);
static inline void differentiators_kalman_correct(Vector axis, differentiators_kalman_Covariance * p, double noise, double measured);
void differentiators_kalman_fill(Vector values, differentiators_kalman_Settings * settings);
void differentiators_kalman_follow(differentiators_kalman_Plane * plane, double jerk_density, double noise, double dt, T2d place);
static inline void differentiators_kalman_narrow(differentiators_kalman_Covariance * p, double noise);
static inline void differentiators_kalman_predict(Vector axis, double dt);
void differentiators_kalman_restart(differentiators_kalman_Plane * plane, double noise);
double differentiators_kalman_settle_s(differentiators_kalman_Settings * settings, differentiators_sampling_State * samples);
static inline void differentiators_kalman_spread(differentiators_kalman_Covariance * p, double jerk_density, double dt);
static inline T10d differentiators_kalman_step(differentiators_kalman_Memory * memory, records_EventRow event);
Tq3db differentiators_sampling_accept(differentiators_sampling_Settings * settings, differentiators_sampling_State * s, records_EventRow event);
void differentiators_sampling_fill(Vector values, Vector memory);
T10d differentiators_sampling_motion(differentiators_sampling_State * s, records_EventRow event, T2_T2d_ hand, double settled, bool start);
double differentiators_sampling_settled(differentiators_sampling_State * s, double samples, double settle_s);
bool follow__predictors_adaptation_predictor_step(Vector memory, T10d row, Vector shared_0);
bool follow__predictors_delphian_step(Vector memory, T10d row);
bool follow__predictors_hold_step(Vector memory, T10d row);
bool follow__predictors_kalman_step(Vector memory, T10d row);
bool follow__predictors_kep_step(Vector memory, T10d row);
bool follow__predictors_ktm_step(Vector memory, T10d row);
bool follow__predictors_linear_step(Vector memory, T10d row);
bool follow__predictors_minimum_jerk_step(Vector memory, T10d row);
bool follow__predictors_switched_direction_step(Vector memory, T10d row);
bool follow__predictors_switched_step(Vector memory, T10d row);
T10d joint__differentiators_difference_step__predictors_adaptation_predictor_step(Vector memory, Vector other, records_EventRow row, Vector shared_0);
T10d joint__differentiators_difference_step__predictors_delphian_step(Vector memory, Vector other, records_EventRow row);
T10d joint__differentiators_difference_step__predictors_hold_step(Vector memory, Vector other, records_EventRow row);
T10d joint__differentiators_difference_step__predictors_kalman_step(Vector memory, Vector other, records_EventRow row);
T10d joint__differentiators_difference_step__predictors_kep_step(Vector memory, Vector other, records_EventRow row);
T10d joint__differentiators_difference_step__predictors_kinematic_predictor_step(Vector memory, Vector other, records_EventRow row, Vector shared_0);
T10d joint__differentiators_difference_step__predictors_ktm_step(Vector memory, Vector other, records_EventRow row);
T10d joint__differentiators_difference_step__predictors_linear_step(Vector memory, Vector other, records_EventRow row);
T10d joint__differentiators_difference_step__predictors_minimum_jerk_step(Vector memory, Vector other, records_EventRow row);
T10d joint__differentiators_difference_step__predictors_switched_direction_step(Vector memory, Vector other, records_EventRow row);
T10d joint__differentiators_difference_step__predictors_switched_step(Vector memory, Vector other, records_EventRow row);
T10d joint__differentiators_homogeneous_step__predictors_adaptation_predictor_step(Vector memory, Vector other, records_EventRow row, Vector shared_0);
T10d joint__differentiators_homogeneous_step__predictors_delphian_step(Vector memory, Vector other, records_EventRow row);
T10d joint__differentiators_homogeneous_step__predictors_hold_step(Vector memory, Vector other, records_EventRow row);
T10d joint__differentiators_homogeneous_step__predictors_kalman_step(Vector memory, Vector other, records_EventRow row);
T10d joint__differentiators_homogeneous_step__predictors_kep_step(Vector memory, Vector other, records_EventRow row);
T10d joint__differentiators_homogeneous_step__predictors_kinematic_predictor_step(Vector memory, Vector other, records_EventRow row, Vector shared_0);
T10d joint__differentiators_homogeneous_step__predictors_ktm_step(Vector memory, Vector other, records_EventRow row);
T10d joint__differentiators_homogeneous_step__predictors_linear_step(Vector memory, Vector other, records_EventRow row);
T10d joint__differentiators_homogeneous_step__predictors_minimum_jerk_step(Vector memory, Vector other, records_EventRow row);
T10d joint__differentiators_homogeneous_step__predictors_switched_direction_step(Vector memory, Vector other, records_EventRow row);
T10d joint__differentiators_homogeneous_step__predictors_switched_step(Vector memory, Vector other, records_EventRow row);
T10d joint__differentiators_kalman_step__predictors_adaptation_predictor_step(Vector memory, Vector other, records_EventRow row, Vector shared_0);
T10d joint__differentiators_kalman_step__predictors_delphian_step(Vector memory, Vector other, records_EventRow row);
T10d joint__differentiators_kalman_step__predictors_hold_step(Vector memory, Vector other, records_EventRow row);
T10d joint__differentiators_kalman_step__predictors_kalman_step(Vector memory, Vector other, records_EventRow row);
T10d joint__differentiators_kalman_step__predictors_kep_step(Vector memory, Vector other, records_EventRow row);
T10d joint__differentiators_kalman_step__predictors_kinematic_predictor_step(Vector memory, Vector other, records_EventRow row, Vector shared_0);
T10d joint__differentiators_kalman_step__predictors_ktm_step(Vector memory, Vector other, records_EventRow row);
T10d joint__differentiators_kalman_step__predictors_linear_step(Vector memory, Vector other, records_EventRow row);
T10d joint__differentiators_kalman_step__predictors_minimum_jerk_step(Vector memory, Vector other, records_EventRow row);
T10d joint__differentiators_kalman_step__predictors_switched_direction_step(Vector memory, Vector other, records_EventRow row);
T10d joint__differentiators_kalman_step__predictors_switched_step(Vector memory, Vector other, records_EventRow row);
T10d last__differentiators_difference_step__follow__predictors_adaptation_predictor_step__predictors_adaptation_predictor_step(Vector memory, Vector other, Table rows, Vector shared_0);
T10d last__differentiators_difference_step__follow__predictors_delphian_step__predictors_delphian_step(Vector memory, Vector other, Table rows);
T10d last__differentiators_difference_step__follow__predictors_hold_step__predictors_hold_step(Vector memory, Vector other, Table rows);
T10d last__differentiators_difference_step__follow__predictors_kalman_step__predictors_kalman_step(Vector memory, Vector other, Table rows);
T10d last__differentiators_difference_step__follow__predictors_kep_step__predictors_kep_step(Vector memory, Vector other, Table rows);
T10d last__differentiators_difference_step__follow__predictors_ktm_step__predictors_ktm_step(Vector memory, Vector other, Table rows);
T10d last__differentiators_difference_step__follow__predictors_linear_step__predictors_linear_step(Vector memory, Vector other, Table rows);
T10d last__differentiators_difference_step__follow__predictors_minimum_jerk_step__predictors_minimum_jerk_step(Vector memory, Vector other, Table rows);
T10d last__differentiators_difference_step__follow__predictors_switched_direction_step__predictors_switched_direction_step(Vector memory, Vector other, Table rows);
T10d last__differentiators_difference_step__follow__predictors_switched_step__predictors_switched_step(Vector memory, Vector other, Table rows);
T10d last__differentiators_difference_step__predictors_kinematic_predictor_follow__predictors_kinematic_predictor_step(Vector memory, Vector other, Table rows, Vector shared_0);
T10d last__differentiators_homogeneous_step__follow__predictors_adaptation_predictor_step__predictors_adaptation_predictor_step(Vector memory, Vector other, Table rows, Vector shared_0);
T10d last__differentiators_homogeneous_step__follow__predictors_delphian_step__predictors_delphian_step(Vector memory, Vector other, Table rows);
T10d last__differentiators_homogeneous_step__follow__predictors_hold_step__predictors_hold_step(Vector memory, Vector other, Table rows);
T10d last__differentiators_homogeneous_step__follow__predictors_kalman_step__predictors_kalman_step(Vector memory, Vector other, Table rows);
T10d last__differentiators_homogeneous_step__follow__predictors_kep_step__predictors_kep_step(Vector memory, Vector other, Table rows);
T10d last__differentiators_homogeneous_step__follow__predictors_ktm_step__predictors_ktm_step(Vector memory, Vector other, Table rows);
T10d last__differentiators_homogeneous_step__follow__predictors_linear_step__predictors_linear_step(Vector memory, Vector other, Table rows);
T10d last__differentiators_homogeneous_step__follow__predictors_minimum_jerk_step__predictors_minimum_jerk_step(Vector memory, Vector other, Table rows);
T10d last__differentiators_homogeneous_step__follow__predictors_switched_direction_step__predictors_switched_direction_step(Vector memory, Vector other, Table rows);
T10d last__differentiators_homogeneous_step__follow__predictors_switched_step__predictors_switched_step(Vector memory, Vector other, Table rows);
T10d last__differentiators_homogeneous_step__predictors_kinematic_predictor_follow__predictors_kinematic_predictor_step(Vector memory, Vector other, Table rows, Vector shared_0);
T10d last__differentiators_kalman_step__follow__predictors_adaptation_predictor_step__predictors_adaptation_predictor_step(Vector memory, Vector other, Table rows, Vector shared_0);
T10d last__differentiators_kalman_step__follow__predictors_delphian_step__predictors_delphian_step(Vector memory, Vector other, Table rows);
T10d last__differentiators_kalman_step__follow__predictors_hold_step__predictors_hold_step(Vector memory, Vector other, Table rows);
T10d last__differentiators_kalman_step__follow__predictors_kalman_step__predictors_kalman_step(Vector memory, Vector other, Table rows);
T10d last__differentiators_kalman_step__follow__predictors_kep_step__predictors_kep_step(Vector memory, Vector other, Table rows);
T10d last__differentiators_kalman_step__follow__predictors_ktm_step__predictors_ktm_step(Vector memory, Vector other, Table rows);
T10d last__differentiators_kalman_step__follow__predictors_linear_step__predictors_linear_step(Vector memory, Vector other, Table rows);
T10d last__differentiators_kalman_step__follow__predictors_minimum_jerk_step__predictors_minimum_jerk_step(Vector memory, Vector other, Table rows);
T10d last__differentiators_kalman_step__follow__predictors_switched_direction_step__predictors_switched_direction_step(Vector memory, Vector other, Table rows);
T10d last__differentiators_kalman_step__follow__predictors_switched_step__predictors_switched_step(Vector memory, Vector other, Table rows);
T10d last__differentiators_kalman_step__predictors_kinematic_predictor_follow__predictors_kinematic_predictor_step(Vector memory, Vector other, Table rows, Vector shared_0);
void loop__predictors_adaptation_predictor_conclude__records_row_at__predictors_adaptation_predictor_step(Vector memory, int64_t first, FlagVector begin, Table rows, Table out, Vector shared_0);
void loop__predictors_ktm_conclude__records_row_at__predictors_ktm_step(Vector memory, int64_t first, FlagVector begin, Table rows, Table out);
void loop__stage_learn_nothing__records_event_at__differentiators_difference_step(Vector memory, int64_t first, FlagVector begin, Table rows, Table out);
void loop__stage_learn_nothing__records_event_at__differentiators_homogeneous_step(Vector memory, int64_t first, FlagVector begin, Table rows, Table out);
void loop__stage_learn_nothing__records_event_at__differentiators_kalman_step(Vector memory, int64_t first, FlagVector begin, Table rows, Table out);
void loop__stage_learn_nothing__records_row_at__predictors_delphian_step(Vector memory, int64_t first, FlagVector begin, Table rows, Table out);
void loop__stage_learn_nothing__records_row_at__predictors_hold_step(Vector memory, int64_t first, FlagVector begin, Table rows, Table out);
void loop__stage_learn_nothing__records_row_at__predictors_kalman_step(Vector memory, int64_t first, FlagVector begin, Table rows, Table out);
void loop__stage_learn_nothing__records_row_at__predictors_kep_step(Vector memory, int64_t first, FlagVector begin, Table rows, Table out);
void loop__stage_learn_nothing__records_row_at__predictors_kinematic_predictor_step(Vector memory, int64_t first, FlagVector begin, Table rows, Table out, Vector shared_0);
void loop__stage_learn_nothing__records_row_at__predictors_linear_step(Vector memory, int64_t first, FlagVector begin, Table rows, Table out);
void loop__stage_learn_nothing__records_row_at__predictors_minimum_jerk_step(Vector memory, int64_t first, FlagVector begin, Table rows, Table out);
void loop__stage_learn_nothing__records_row_at__predictors_switched_direction_step(Vector memory, int64_t first, FlagVector begin, Table rows, Table out);
void loop__stage_learn_nothing__records_row_at__predictors_switched_step(Vector memory, int64_t first, FlagVector begin, Table rows, Table out);
void loop__stage_learn_nothing__transfer_assistance_guided_report_at__transfer_assistance_guarded_step(Vector memory, int64_t first, FlagVector begin, Table rows, Table out);
void predictors_adaptation_arrival_intervals_judge(predictors_adaptation_arrival_intervals_Intervals * s, double share, double step, T2d claim, double left);
double predictors_adaptation_arrival_intervals_next_step(predictors_adaptation_arrival_intervals_Intervals * s);
double predictors_adaptation_arrival_intervals_spread(predictors_adaptation_arrival_intervals_Intervals * s, double share);
T10d predictors_adaptation_correction_adapt(predictors_adaptation_correction_Settings * settings, predictors_adaptation_correction_Person * person, predictors_adaptation_correction_Movement * movement, T10d answer, predictors_adaptation_time_left_Pace pace);
T2_predictors_adaptation_destination_Heading_ predictors_adaptation_correction_adapted_end(predictors_adaptation_correction_Settings * settings, predictors_adaptation_correction_Person * person, predictors_adaptation_correction_Movement * movement, predictors_adaptation_destination_Heading own, double share);
T2d predictors_adaptation_correction_ahead_of(predictors_adaptation_correction_Movement * movement, predictors_adaptation_destination_Heading heading);
double predictors_adaptation_correction_arrival(predictors_adaptation_correction_Movement * movement, double near);
T_predictors_adaptation_destination_Heading_d predictors_adaptation_correction_by_distances(predictors_adaptation_correction_Person * person, predictors_adaptation_correction_Movement * movement, predictors_adaptation_destination_Heading own, double share);
predictors_adaptation_destination_Heading predictors_adaptation_correction_by_places(predictors_adaptation_correction_Settings * settings, predictors_adaptation_correction_Person * person, predictors_adaptation_correction_Movement * movement, T2_predictors_adaptation_destination_Heading_ laws, T2d weights);
void predictors_adaptation_correction_conclude(predictors_adaptation_correction_Settings * settings, predictors_adaptation_correction_Person * person, predictors_adaptation_correction_Movement * movement);
double predictors_adaptation_correction_fading(double share, double since);
Tqd predictors_adaptation_correction_fault(predictors_adaptation_correction_Person * learned);
void predictors_adaptation_correction_follow(predictors_adaptation_correction_Movement * movement, T3d now, T3d start);
predictors_adaptation_destination_Heading predictors_adaptation_correction_heading_of(predictors_adaptation_correction_Movement * movement, T10d answer);
void predictors_adaptation_correction_learn(predictors_adaptation_correction_Person * person, predictors_adaptation_correction_Movement * movement, double distance, double end);
void predictors_adaptation_correction_learn_place(predictors_adaptation_correction_Settings * settings, predictors_adaptation_correction_Person * person, predictors_adaptation_correction_Movement * movement);
void predictors_adaptation_correction_prepare(predictors_adaptation_correction_Settings * settings, predictors_adaptation_correction_Person * person, predictors_adaptation_destination_Movement * going, T2d start);
int64_t predictors_adaptation_correction_stage_begun(predictors_adaptation_correction_Movement * movement, double share);
void predictors_adaptation_correction_state(predictors_adaptation_correction_Settings * settings, predictors_adaptation_correction_Person * person, predictors_adaptation_correction_Movement * movement, double share, T2_T6d_ laws);
predictors_adaptation_destination_Heading predictors_adaptation_correction_with_centre_ahead(predictors_adaptation_correction_Movement * movement, predictors_adaptation_destination_Heading heading, double along, double wide);
void predictors_adaptation_correction_write_mixture(predictors_adaptation_correction_Settings * settings, predictors_adaptation_correction_Person * person, predictors_adaptation_correction_Movement * movement, predictors_adaptation_mixed_region_Mixture * to);
int64_t predictors_adaptation_destination_candidates(predictors_adaptation_destination_Movement * s, predictors_adaptation_places_Places * held, T2d start, predictors_adaptation_destination_Heading elsewhere, Table out);
predictors_adaptation_destination_Heading predictors_adaptation_destination_combine(predictors_adaptation_destination_Movement * s, predictors_adaptation_places_Places * held, T2d start, predictors_adaptation_destination_Heading elsewhere);
void predictors_adaptation_destination_favour_near(predictors_adaptation_destination_Movement * s, predictors_adaptation_places_Places * held, T2d start, double near);
T2d predictors_adaptation_destination_geometric_median(Table rows, int64_t count);
double predictors_adaptation_destination_likelihood(predictors_adaptation_destination_Heading law_of_end, double x, double y, double distance, double spread);
void predictors_adaptation_destination_prepare(predictors_adaptation_destination_Movement * s, predictors_adaptation_places_Places * held, predictors_adaptation_habits_Habits * known, T3d scene, T2d start);
T6d predictors_adaptation_destination_scaled(predictors_adaptation_destination_Heading end, double shape, double factor, double tail);
predictors_adaptation_destination_Heading predictors_adaptation_destination_shift_law(predictors_adaptation_destination_Heading heading, double dx, double dy);
double predictors_adaptation_destination_spread_of(predictors_adaptation_destination_Movement * s, T2d start, double x, double y);
void predictors_adaptation_destination_weigh(predictors_adaptation_destination_Movement * s, predictors_adaptation_places_Places * held, T2d start, predictors_adaptation_destination_Heading law_of_end, T2d elsewhere);
double predictors_adaptation_distances_age_weight(int64_t age, int64_t count, double time);
T3d predictors_adaptation_distances_combine(predictors_adaptation_distances_Distances * s, double reached, predictors_adaptation_distances_Ahead predicted);
Tqd predictors_adaptation_distances_fault(predictors_adaptation_distances_Distances * learned);
void predictors_adaptation_distances_judge(predictors_adaptation_distances_Distances * s, double distance);
double predictors_adaptation_distances_likelihood(predictors_adaptation_distances_Distances * s, double distance);
void predictors_adaptation_distances_remember(predictors_adaptation_distances_Distances * s, double distance);
Tqd predictors_adaptation_durations_fault(predictors_adaptation_durations_Durations * learned);
void predictors_adaptation_durations_forget(predictors_adaptation_durations_Durations * s);
void predictors_adaptation_durations_judge(predictors_adaptation_durations_Durations * s, double since, double predicted, double left, double duration);
double predictors_adaptation_durations_median(predictors_adaptation_durations_Durations * s);
double predictors_adaptation_durations_mix(predictors_adaptation_durations_Durations * s, double since, double left);
double predictors_adaptation_durations_mixture(predictors_adaptation_durations_Durations * s, double share, double since, double left);
void predictors_adaptation_durations_remember(predictors_adaptation_durations_Durations * s, double duration);
double predictors_adaptation_durations_value_of_rank(predictors_adaptation_durations_Durations * s, int64_t rank);
void predictors_adaptation_habits_blend(Table out, int64_t rule, int64_t base, int64_t count, double weight);
void predictors_adaptation_habits_count_following(predictors_adaptation_places_Places * held, int64_t here, Table out);
void predictors_adaptation_habits_count_last(predictors_adaptation_habits_Habits * s, predictors_adaptation_places_Places * held, Table out);
double predictors_adaptation_habits_count_often(predictors_adaptation_places_Places * held, double key, Table out);
double predictors_adaptation_habits_density_ratio(double far2, double distance2, double width);
void predictors_adaptation_habits_learn(predictors_adaptation_habits_Habits * s, predictors_adaptation_places_Places * held, T3d scene, T4d movement, double elsewhere);
double predictors_adaptation_habits_returns(predictors_adaptation_habits_Habits * s);
double predictors_adaptation_habits_rule_weight(predictors_adaptation_habits_Habits * s, int64_t rule, double with_sequence);
void predictors_adaptation_habits_share_visit(predictors_adaptation_habits_Habits * s, Table likely, double with_sequence, double elsewhere);
bool predictors_adaptation_habits_shares(predictors_adaptation_habits_Habits * s, predictors_adaptation_places_Places * held, double key, T3d start, Table out);
double predictors_adaptation_habits_usual_width(predictors_adaptation_habits_Habits * s);
double predictors_adaptation_habits_width_weight(predictors_adaptation_habits_Habits * s, int64_t width);
static inline void predictors_adaptation_levels_learn(predictors_adaptation_levels_Offsets * s, double share, int64_t which, bool inside, double step);
static inline double predictors_adaptation_levels_offset(predictors_adaptation_levels_Offsets * s, double share, int64_t which);
static inline double predictors_adaptation_levels_step_after(double movements);
void predictors_adaptation_mixed_region_claim(predictors_adaptation_mixed_region_Movement * s, double share, T6d elsewhere);
void predictors_adaptation_mixed_region_judge(predictors_adaptation_levels_Offsets * offsets, predictors_adaptation_mixed_region_Mixture * stated, T2d end, double share, double step);
int64_t predictors_adaptation_mixed_region_likeliest(predictors_adaptation_places_Places * held, predictors_adaptation_destination_Movement * going, double below);
void predictors_adaptation_mixed_region_write(predictors_adaptation_levels_Offsets * offsets, predictors_adaptation_places_Places * held, predictors_adaptation_destination_Movement * going, predictors_adaptation_mixed_region_Movement * now, predictors_adaptation_mixed_region_Mixture * to, T2d origin, T2d start);
void predictors_adaptation_mixed_region_write_part(predictors_mixture_PartRow * part, double share, T2d centre, double spread);
static inline bool predictors_adaptation_moments_has_come(predictors_adaptation_moments_Series * s, double t, T2d span, double share);
static inline Tqb predictors_adaptation_moments_next_moment(predictors_adaptation_moments_Series * s, double last_t, T3d cursor, int64_t most);
Tqd predictors_adaptation_places_fault(predictors_adaptation_places_Places * learned);
int64_t predictors_adaptation_places_nearest(predictors_adaptation_places_Places * s, double key, T2d point, double near);
int64_t predictors_adaptation_places_new_place(predictors_adaptation_places_Places * s);
void predictors_adaptation_places_visit(predictors_adaptation_places_Places * s, double key, T2d end, double near);
int64_t predictors_adaptation_places_visited(predictors_adaptation_places_Places * s, int64_t age);
void predictors_adaptation_predictor_conclude(predictors_adaptation_predictor_Memory * memory);
void predictors_adaptation_predictor_enter_scene(predictors_adaptation_predictor_Memory * memory, scene_Scene scene);
T2d predictors_adaptation_predictor_last_end(predictors_adaptation_places_Places * held, double key);
Tq2d predictors_adaptation_predictor_list_parts(predictors_adaptation_predictor_Memory * memory, Table out);
int64_t predictors_adaptation_predictor_list_places(predictors_adaptation_predictor_Memory * memory, Table out);
predictors_adaptation_time_left_Pace predictors_adaptation_predictor_pace_of(predictors_kinematic_features_State * own, records_MotionRow m);
T3q predictors_adaptation_predictor_sizes(Vector values);
T10d predictors_adaptation_predictor_step(predictors_adaptation_predictor_Memory * memory, T10d motion, predictors_kinematic_network_Coefficients * coefficients);
bool predictors_adaptation_predictor_write_mixture(predictors_adaptation_predictor_Memory * memory);
void predictors_adaptation_region_widening_learn(predictors_adaptation_region_widening_Radii * s, predictors_adaptation_region_widening_Movement * stated, T2d place_of_end, T2d span);
static inline double predictors_adaptation_region_widening_probability_within(T6d region, double x, double y);
int64_t predictors_adaptation_region_widening_record(predictors_adaptation_region_widening_Movement * stated, T3d cursor, T6d region);
T2d predictors_adaptation_region_widening_widen(predictors_adaptation_region_widening_Radii * s, double share, double tail);
double predictors_adaptation_stages_belief(double paid, double size);
double predictors_adaptation_stages_bias(predictors_adaptation_stages_Stage * s, double total, double along);
double predictors_adaptation_stages_bounded(double value, double most);
T4d predictors_adaptation_stages_correct(predictors_adaptation_stages_Stages * known, double share, double total, double along);
void predictors_adaptation_stages_forget(predictors_adaptation_stages_Stage * s);
Tqd predictors_adaptation_stages_interpolation(double share);
Tqd predictors_adaptation_stages_interpolation_among(double share, int64_t count);
void predictors_adaptation_stages_learn(predictors_adaptation_stages_Stage * s, predictors_adaptation_stages_Moment * m, double x, double y, double t);
double predictors_adaptation_stages_scale(predictors_adaptation_stages_Stage * s, double squares, double off, double tail);
void predictors_adaptation_stages_solve(predictors_adaptation_stages_Stage * s);
double predictors_adaptation_stages_tempo(predictors_adaptation_stages_Stage * s);
double predictors_adaptation_stages_tempo_factor(predictors_adaptation_stages_Stage * s);
double predictors_adaptation_stages_width_log(predictors_adaptation_stages_Stage * s, double squares);
double predictors_adaptation_time_left_factor(predictors_adaptation_time_left_Sums * s, Vector prior, Vector out);
static inline Tqd predictors_adaptation_time_left_fault(predictors_adaptation_time_left_Sums * learned, Vector prior);
void predictors_adaptation_time_left_learn(predictors_adaptation_time_left_Sums * s, predictors_adaptation_arrival_intervals_Intervals * intervals, predictors_adaptation_time_left_Movement * movement, T2d span, double median, Vector prior);
int64_t predictors_adaptation_time_left_moment_at(predictors_adaptation_time_left_Movement * movement, int64_t k, T2d span, double share);
void predictors_adaptation_time_left_solve(predictors_adaptation_time_left_Sums * s, Vector prior, Vector weights);
T2d predictors_adaptation_time_left_stated(predictors_adaptation_time_left_Sums * s, predictors_adaptation_arrival_intervals_Intervals * intervals, predictors_adaptation_time_left_Movement * movement, T3d cursor, double since, double median, predictors_adaptation_time_left_Estimates estimates, predictors_adaptation_time_left_Way way, predictors_adaptation_time_left_Pace pace);
T7d predictors_adaptation_time_left_terms(predictors_adaptation_time_left_Estimates estimates, predictors_adaptation_time_left_Way way, predictors_adaptation_time_left_Pace pace, double since, double median);
T2d predictors_adaptation_time_left_weighed(predictors_adaptation_time_left_Sums * s, predictors_adaptation_arrival_intervals_Intervals * intervals, predictors_adaptation_time_left_Movement * movement, T3d cursor, double since, double median, double predicted, T7d known, Vector prior);
T10d predictors_delphian_step(predictors_delphian_Memory * memory, T10d motion);
T10d predictors_hold_step(predictors_movement_State * s, T10d motion);
T3d predictors_kalman_corrected(Vector axis, differentiators_kalman_Covariance * p, double noise, double measured);
void predictors_kalman_expect(differentiators_kalman_Plane * plane, double noise, double jerk_density, double dt, double x, double y);
void predictors_kalman_expect_rest(differentiators_kalman_Plane * plane, double noise, double x, double y);
T10d predictors_kalman_step(predictors_kalman_Memory * memory, T10d motion);
void predictors_kep_add(predictors_kep_Fit * fit, int64_t degree, double distance, double speed);
T2d predictors_kep_bends(predictors_kep_Quartic p, double far);
predictors_kep_Quartic predictors_kep_derivative(predictors_kep_Quartic p);
double predictors_kep_first_zero(predictors_kep_Quartic p, double far);
void predictors_kep_judge(predictors_kep_Check * check, double change_most, double length, double x, double y);
double predictors_kep_remaining(predictors_kep_Fit * fit, int64_t degree, double reach, double travelled);
T10d predictors_kep_step(predictors_kep_Memory * memory, T10d motion);
double predictors_kep_value(predictors_kep_Quartic p, double w);
double predictors_kep_zero_between(predictors_kep_Quartic p, double low, double high);
double predictors_kinematic_features_ahead(double ratio);
T2d predictors_kinematic_features_direction(double x, double y, double vx, double vy);
void predictors_kinematic_features_fill_lags(predictors_kinematic_history_State * s, predictors_kinematic_history_Point point, predictors_kinematic_features_Frame frame, predictors_kinematic_features_Values * out);
void predictors_kinematic_features_fill_pace(predictors_kinematic_track_State * s, predictors_kinematic_history_Point point, records_MotionRow m, predictors_kinematic_features_Frame frame, predictors_kinematic_features_Values * out);
void predictors_kinematic_features_fill_shape(predictors_kinematic_track_State * s, predictors_kinematic_history_Point point, predictors_kinematic_features_Frame frame, predictors_kinematic_features_Values * out);
Tq_predictors_kinematic_history_Point_ predictors_kinematic_features_follow(predictors_kinematic_features_State * s, records_MotionRow m);
predictors_kinematic_features_Frame predictors_kinematic_features_frame_of(predictors_kinematic_track_State * s, predictors_kinematic_history_Point point, records_MotionRow m);
Tq_predictors_kinematic_features_Frame_ predictors_kinematic_features_observe(predictors_kinematic_features_State * s, records_MotionRow m, predictors_kinematic_features_Values * out);
void predictors_kinematic_features_observe_all(predictors_kinematic_features_State * s, FlagVector begin, Table rows, Table out, Table frames);
void predictors_kinematic_features_rewind(predictors_kinematic_features_State * s, bool again);
void predictors_kinematic_history_begin(predictors_kinematic_history_State * s);
predictors_kinematic_history_Point predictors_kinematic_history_extend(predictors_kinematic_history_State * s, T3d last, T3d now);
T3d predictors_kinematic_history_past(predictors_kinematic_history_State * s, predictors_kinematic_history_Point now, double ago);
void predictors_kinematic_network_activate(Vector sums);
int64_t predictors_kinematic_network_evaluate(predictors_kinematic_network_Coefficients * coefficients, Vector values, Vector out);
double predictors_kinematic_network_factor(predictors_kinematic_network_Calibration * calibration, double share, int64_t which);
int64_t predictors_kinematic_network_layer(predictors_kinematic_network_Coefficients * coefficients, int64_t at, Vector inputs, Vector sums);
double predictors_kinematic_network_side(Vector values);
double predictors_kinematic_predictor_bounded_exp(double logarithm, T2d bounds);
bool predictors_kinematic_predictor_follow(predictors_kinematic_features_State * s, T10d motion, predictors_kinematic_network_Coefficients * coefficients);
T10d predictors_kinematic_predictor_step(predictors_kinematic_features_State * s, T10d motion, predictors_kinematic_network_Coefficients * coefficients);
void predictors_kinematic_submovements_divide(predictors_kinematic_submovements_State * s, predictors_kinematic_history_Point point, double speed, double movement_peak);
void predictors_kinematic_track_advance(predictors_kinematic_track_State * s, predictors_kinematic_history_Point point, records_MotionRow hand, double cursor_speed);
void predictors_ktm_conclude(predictors_ktm_Memory * memory);
double predictors_ktm_distance(predictors_movement_State * s);
void predictors_ktm_fill(Vector values, predictors_ktm_Settings * settings);
void predictors_ktm_forget(predictors_ktm_Settings * settings, predictors_ktm_State * s);
void predictors_ktm_keep(predictors_ktm_Memory * memory, predictors_ktm_State * s, double distance);
int64_t predictors_ktm_place_of_learned(predictors_ktm_Settings * settings);
int64_t predictors_ktm_place_of_template(predictors_ktm_Settings * settings, int64_t k);
void predictors_ktm_resample(predictors_ktm_Memory * memory, predictors_ktm_State * s, double since, double x_before, double y_before);
void predictors_ktm_sample(predictors_ktm_Memory * memory, predictors_ktm_State * s, double speed);
int64_t predictors_ktm_samples_of(double longest_s);
void predictors_ktm_score(predictors_ktm_Settings * settings, int64_t n, double speed, double own, predictors_ktm_Template * template, predictors_ktm_Match * match);
T3q predictors_ktm_sizes(Vector values);
T10d predictors_ktm_step(predictors_ktm_Memory * memory, T10d motion);
int64_t predictors_ktm_template_count(predictors_ktm_Memory * memory);
int64_t predictors_ktm_winner(predictors_ktm_Memory * memory, predictors_ktm_State * s, double times);
Tb3d predictors_linear_before(predictors_linear_Past * past, double window_s, double t);
void predictors_linear_remember(predictors_linear_Past * past, double window_s, double t, double x, double y);
T10d predictors_linear_step(predictors_linear_Memory * memory, T10d motion);
static inline T2d predictors_minimum_jerk_progress(double ratio);
T10d predictors_minimum_jerk_step(predictors_movement_State * s, T10d motion);
static inline double predictors_mixture_content(Table parts, int64_t count, double x, double y, int64_t points);
static inline double predictors_mixture_corrected_probability(double level, double tail, double near, double far);
static inline double predictors_mixture_corrected_radius(double level, double heavy, double offset);
T2d predictors_mixture_crossing(Table parts, int64_t count, double threshold, T3d one, T3d other);
void predictors_mixture_densities(Table parts, int64_t count, int64_t points, Table out);
double predictors_mixture_density(Table parts, int64_t count, double x, double y);
int64_t predictors_mixture_edge_of(int64_t side, int64_t i, int64_t j, int64_t columns, int64_t rows);
void predictors_mixture_follow_cells(Table heights, Table middles, int64_t columns, int64_t rows, Vector following);
static inline double predictors_mixture_heaviness(double tail);
double predictors_mixture_height(Table parts, int64_t count, double threshold, double x, double y);
int64_t predictors_mixture_lines_of(Table parts, int64_t count, double threshold, int64_t across, Vector out);
int64_t predictors_mixture_outlines(Table parts, int64_t count, double threshold, Table points, Vector ends);
double predictors_mixture_part_density(predictors_mixture_PartRow * part, double x, double y);
int64_t predictors_mixture_partner(Vector sides, int64_t side, double middle);
int64_t predictors_mixture_points_of(int64_t count);
double predictors_mixture_reach(predictors_mixture_PartRow * part, int64_t count, double threshold);
double predictors_mixture_share_above(Table parts, int64_t count, int64_t points, Table known, double threshold);
double predictors_mixture_squared_radius(double share, double tail);
static inline double predictors_mixture_squared_radius_over_tail(double level, double heavy);
double predictors_mixture_threshold_of(Table parts, int64_t count, double level, int64_t points);
int64_t predictors_movement_fault_of(predictors_movement_State * s, records_MotionRow m);
static inline Tqbd predictors_movement_follow(predictors_movement_State * s, records_MotionRow m);
static inline double predictors_movement_phase(predictors_movement_State * s, records_MotionRow m);
static inline T10d predictors_movement_refuse(predictors_movement_State * s, records_MotionRow m, int64_t fault);
double predictors_switched_advance(predictors_switched_Settings * settings, predictors_switched_Axis * axis, double t, double x, double v, double a);
double predictors_switched_direction_approach(predictors_switched_direction_Settings * settings, predictors_switched_direction_Submovement * s, double px_m, double x, double y, double speed);
void predictors_switched_direction_begin_submovement(predictors_switched_direction_Submovement * s, double x, double y);
void predictors_switched_direction_follow_submovement(predictors_switched_direction_Submovement * s, double rise, double x, double y, double speed);
double predictors_switched_direction_gain(predictors_switched_direction_Hand * hand, double dt, double away_x, double away_y, double vx, double vy);
T10d predictors_switched_direction_step(predictors_switched_direction_Memory * memory, T10d motion);
double predictors_switched_direction_time_constant(double own, double typical_s, double done, double peak);
T10d predictors_switched_step(predictors_switched_Memory * memory, T10d motion);
static inline T10d records_endpoint(double t, double x, double y, double phase);
static inline T6d records_event_at(Table table, int64_t i);
static inline int64_t records_fault_of_event(records_EventRow event);
static inline T10d records_refused(int64_t code, double value);
static inline T10d records_row_at(Table table, int64_t i);
static inline double regions_reach(double level, double tail);
int64_t regression_delay_capacity(int64_t delays);
Tbd regression_delay_delayed(regression_delay_Ring * ring, int64_t samples, double t, Vector w);
void regression_delay_push(regression_delay_Ring * ring, int64_t samples, double spacing, double t, Vector w, double y);
int64_t regression_delay_states(int64_t n, int64_t samples);
bool regression_drem_advance(regression_drem_State * s, regression_drem_Regression r, double delay_s, double gamma, double t, double y);
double regression_drem_determinant(Table a);
bool regression_drem_extend(regression_drem_Regression r, double delay_s, double t);
double regression_drem_mix(Table a, Vector y, Vector out, Vector scratch);
double regression_drem_mix3(Table a, Vector y, Vector out);
int64_t regression_drem_numbers(int64_t n);
static inline regression_drem_Regression regression_drem_parts(Vector memory, int64_t n);
double regression_drem_remember(regression_drem_State * s, regression_drem_Regression r, double delay_s, double t, double y);
double regression_gradient_descend(double theta, double mixed, double phi, double gamma, double h);
void regression_gradient_descend_along(Vector theta, Vector w, Table gain, double output, double h);
void regression_least_squares_advance(regression_least_squares_Sums * s, regression_least_squares_Regression regression, double forgetting, double output);
double regression_least_squares_excitation(Table r, int64_t j);
int64_t regression_least_squares_numbers(int64_t n);
static inline regression_least_squares_Regression regression_least_squares_parts(Vector memory, int64_t n);
bool regression_least_squares_solve(regression_least_squares_Regression regression, double least, Vector out);
void scoring_measures_endpoint_hits(Table rows, Table answers, WholeVector offsets, WholeVector arrivals, Table discs, Vector shares, Table out);
void scoring_measures_endpoint_measure(Table rows, Table answers, Vector fractions, WholeVector offsets, WholeVector arrivals, Table out, WholeVector faults);
int64_t scoring_measures_endpoint_measure_trial(Table rows, Table answers, Vector fractions, int64_t arrival, Vector out);
void scoring_measures_endpoint_moments(Table rows, int64_t first, int64_t arrival, int64_t last, Vector shares, WholeVector out);
double scoring_measures_regions_axis_score(double error, double variance, double tail);
double scoring_measures_regions_beta_fraction(double a, double b, double x);
void scoring_measures_regions_calibrate(Table rows, Table answers, WholeVector offsets, WholeVector arrivals, Table out);
double scoring_measures_regions_distribution(double z, double tail);
double scoring_measures_regions_incomplete_beta(double a, double b, double x);
void scoring_measures_regions_inside_by_time(Table rows, Table answers, WholeVector offsets, WholeVector arrivals, Vector shares, Table out);
double scoring_measures_regions_log_beta(double a, double b);
double scoring_measures_regions_ranked_score(double error, double deviation);
double scoring_measures_regions_student_score(double error, double scale, double tail);
double scoring_measures_regions_surprise(double dx, double dy, double sxx, double sxy, double syy);
void scoring_measures_time_left_inside_by_time(Table rows, Table answers, WholeVector offsets, WholeVector arrivals, Vector shares, Table out);
void scoring_measures_time_left_time_left(Table rows, Table answers, WholeVector offsets, WholeVector arrivals, double median_s, Table out);
bool scoring_measures_time_left_within(double left, double predicted, double spread, double deviations);
void scoring_summary_sums_add_trials(Table columns, WholeVector person, FlagTable inside, Table sums);
void scoring_target_choice_account(Table events, Table answers, Table table, Table shares, int64_t right, double ask, double least_s, double least_px, Vector out);
int64_t scoring_target_choice_nearest(Table table, double x, double y);
void scoring_target_choice_read(Table events, Table table, Table shares, int64_t arrival, int64_t right, Vector fractions, Table out);
void scoring_target_choice_weigh(Table events, Table answers, Table table, targets_posterior_Coefficients * coefficients, double elsewhere, Table shares);
void scoring_trials_cut(Table rows, WholeVector offsets, WholeTable out);
int64_t scoring_trials_departure(Table rows, int64_t first, int64_t stop);
void scoring_trials_divide(Table motions, WholeVector offsets, FlagVector out);
bool scoring_trials_divided(Table motions, int64_t first, int64_t stop);
T2q scoring_trials_fault(Table rows, int64_t first, int64_t stop);
void scoring_trials_judge(Table table, WholeVector offsets, FlagVector out);
int64_t scoring_trials_selection(Table rows, int64_t first, int64_t stop);
int64_t scoring_trials_settling(Table rows, int64_t onset, int64_t stop);
bool scoring_trials_straight_through(Table table, int64_t first, int64_t stop);
void simulation_hand_aim(simulation_hand_Hand * hand, double x, double y, double width);
void simulation_hand_begin(simulation_hand_Hand * hand, double seed, double skill);
void simulation_hand_draw(simulation_hand_Stream * s, simulation_person_Traits * traits, simulation_plan_Draws * draws);
double simulation_hand_normal(simulation_hand_Stream * s);
T5d simulation_hand_report(simulation_hand_Hand * hand);
void simulation_hand_sow(simulation_hand_Stream * s, double seed);
double simulation_hand_uniform(simulation_hand_Stream * s);
T2d simulation_loop_acceleration(simulation_loop_Memory * memory, double t, simulation_loop_Place place);
void simulation_loop_advance(simulation_loop_Memory * memory, double t, double h, double extra_x, double extra_y);
T2d simulation_loop_assist(simulation_loop_Memory * memory, double own_px, double hat_x, double hat_y);
T2d simulation_loop_ballistic_force(simulation_loop_Memory * memory, double t);
void simulation_loop_correct(simulation_loop_Memory * memory, double t);
double simulation_loop_count(double position_m, double metres_per_count, double counted);
double simulation_loop_cursor_distance(simulation_loop_Settings * settings, double amplitude, double duration);
T2d simulation_loop_cursor_in_mind(simulation_loop_Memory * memory, double u, double v, double speed);
T2d simulation_loop_cursor_rate(simulation_loop_Settings * settings, double vx, double vy);
void simulation_loop_decide(simulation_loop_Memory * memory, double t);
void simulation_loop_enter(simulation_loop_State * s, double phase, double t);
double simulation_loop_hand_distance(simulation_loop_Settings * settings, double distance_px, double duration);
void simulation_loop_launch(simulation_loop_Memory * memory, int64_t number, double t);
int64_t simulation_loop_play(simulation_loop_Memory * memory, Table rows, Table out);
T3d simulation_loop_profile(double u, double skew);
T2d simulation_loop_report(simulation_loop_Memory * memory, double hat_x, double hat_y);
T14d simulation_loop_step(simulation_loop_Memory * memory, T5d chance);
double simulation_person_between(double skill, double novice, double expert, double scatter);
void simulation_person_grow(simulation_person_Traits * traits, double skill, Vector normals);
void simulation_plan_plan(simulation_loop_Settings * settings, simulation_person_Traits * traits, simulation_plan_Draws * draws, double x, double y, double width);
void simulation_plan_plan_piece(simulation_loop_Settings * settings, simulation_person_Traits * traits, simulation_plan_Draws * draws, int64_t number, double first_s);
double simulation_plan_varied(double spread, double normal);
void stage_copy_values(Vector values, Vector memory);
int64_t stage_first_refused(Table answers);
static inline void stage_learn_nothing(Vector memory);
void targets_aim_conclude(targets_heading_Memory * memory, T_Table__Vector__Table__Vector_ targets, targets_posterior_Coefficients * coefficients);
Tqd targets_aim_fault(targets_heading_Person * learned);
Tq2d targets_aim_lay_parts(targets_heading_Memory * memory, T_Table__Vector__Table__Vector_ targets, Table out);
void targets_aim_learn_prediction(targets_heading_Memory * memory, T_Table__Vector__Table__Vector_ targets, targets_posterior_Coefficients * coefficients);
void targets_aim_learn_regions(predictors_adaptation_region_widening_Radii * s, targets_heading_Movement * movement, T2d end, T2d span, T_Table__Vector__Table__Vector_ targets, targets_posterior_Coefficients * coefficients);
void targets_aim_record(targets_heading_Movement * movement, targets_cursor_State * s, targets_endpoint_Ellipse region, T10d answer);
T10d targets_aim_row_of(Vector values);
double targets_aim_share_passed(double since, double left, double usual);
double targets_aim_size_of(Table rows, Vector shares);
T10d targets_aim_step(targets_heading_Memory * memory, T6d event, T10d answer, T_Table__Vector__Table__Vector_ targets, targets_posterior_Coefficients * coefficients);
void targets_aim_walk(targets_heading_Memory * memory, FlagVector begins, Table events, Table answers, T_Table__Vector__Table__Vector_ targets, targets_posterior_Coefficients * coefficients);
double targets_arrival_mean(targets_arrival_Durations * s);
void targets_arrival_remember(targets_arrival_Durations * s, double duration);
T7d targets_arrival_terms(double predicted, double since, double usual, double left_px, double size_px);
T4q targets_choice_law_changes(T2q before, T2q now);
T3q targets_choice_law_decide(targets_cursor_State * s, bool released, double remaining_s, T_Table_2_Vector_ targets, targets_decision_Settings settings, int64_t standing);
int64_t targets_choice_law_enter(Table table, Vector inside, double x, double y, bool released);
int64_t targets_choice_law_innermost(Table table, Vector inside);
void targets_choice_law_lay_places(Table places, Table table, Table keys, Vector shares);
int64_t targets_choice_law_place_of(Table keys, double key, int64_t first);
T2b targets_choice_law_replace(targets_choice_law_State * s, double t, T_Table__Vector_ before, T_Table__Vector_ now, targets_ledger_Account * account, Table rows);
void targets_choice_law_reset(targets_choice_law_State * s, Vector inside);
bool targets_choice_law_update(targets_choice_law_State * s, targets_heading_Memory * memory, T_Table_2_Vector_ targets, Table keys, targets_decision_Settings settings, targets_ledger_Account * account, Table rows, Vector out);
bool targets_cursor_begins(targets_cursor_State * s, double t, double pressed);
static inline bool targets_cursor_follow(targets_cursor_State * s, double t, double x, double y, double pressed);
double targets_cursor_until(targets_cursor_State * s, double x, double y, double width, double height);
bool targets_cursor_usable(double t, double x, double y);
static inline int64_t targets_decision_decide(targets_cursor_State * s, Table table, Vector shares, int64_t standing, double remaining_s, T4d bounds);
bool targets_decision_early(targets_cursor_State * s, Vector row, double remaining_s, double least_s);
int64_t targets_decision_likeliest(Vector shares, int64_t count);
void targets_decision_rank(Vector shares, int64_t count, Vector order);
targets_endpoint_Ellipse targets_endpoint_ellipse(Table parts, int64_t count, T2d centre, T2d way);
targets_posterior_Law targets_endpoint_elsewhere(targets_cursor_State * s, T10d answer);
T2d targets_endpoint_geometric_median(Table parts, int64_t count);
int64_t targets_endpoint_mixture(Table table, Vector shares, targets_posterior_Law predicted, double least, Table out);
void targets_endpoint_write_target(Vector row, targets_posterior_Law predicted, double share, predictors_mixture_PartRow * part);
double targets_heading_arrived(targets_heading_Movement * movement, double x, double y, double near, double end);
void targets_heading_begin(targets_heading_Memory * memory, T_Table__Vector__Table__Vector_ targets);
double targets_heading_ended(targets_heading_Memory * memory, Table rows);
void targets_heading_follow(targets_heading_Memory * memory, T6d event, T_Table__Vector__Table__Vector_ targets);
void targets_heading_learn_target(targets_heading_Memory * memory, T_Table__Vector__Table__Vector_ targets);
int64_t targets_heading_taken(Table rows, double x, double y);
void targets_heading_weigh(targets_heading_Memory * memory, T10d answer, T_Table__Vector__Table__Vector_ targets, targets_posterior_Coefficients * coefficients);
void targets_ledger_add(targets_ledger_Totals * s, T5d movement);
void targets_ledger_begin(targets_ledger_State * s, Table rows);
static inline T3d targets_ledger_close(targets_ledger_State * s, Table rows, double t, int64_t place);
void targets_ledger_drop(targets_ledger_Account * s);
static inline void targets_ledger_enter(targets_ledger_State * s, Table rows, double t, int64_t place);
T6d targets_ledger_finish(targets_ledger_Account * s, Table rows, double t, double key);
void targets_ledger_note_end(targets_ledger_Account * s, Table rows, double t, double key, bool released);
void targets_ledger_note_entry(targets_ledger_Account * s, Table rows, double t, double key);
void targets_ledger_note_proposal(targets_ledger_Account * s, Table rows, double t, double key);
static inline void targets_ledger_propose(targets_ledger_State * s, Table rows, double t, int64_t place);
int64_t targets_ledger_row_of(targets_ledger_Account * s, Table rows, double key, bool new);
static inline void targets_ledger_withdraw(targets_ledger_State * s, double t, int64_t place, bool released);
void targets_past_add_visit(targets_past_Past * s, int64_t k, Table keys, Table out);
double targets_past_elsewhere(targets_past_Past * s, double first);
void targets_past_learn(targets_past_Past * s, Vector own, Table keys, int64_t taken);
double targets_past_rule_weight(targets_past_Past * s, int64_t rule);
void targets_past_shares(targets_past_Past * s, Vector own, Table keys, Table out);
void targets_past_weigh(targets_past_Past * s, Vector own, Table keys, Table table);
T2d targets_posterior_direction(double x, double y);
T6d targets_posterior_feature(Vector row, targets_posterior_Situation now, targets_posterior_Law predicted);
void targets_posterior_features(targets_cursor_State * s, Table table, targets_posterior_Law predicted, Table out);
bool targets_posterior_lawful(targets_posterior_Law predicted);
double targets_posterior_log_mass(targets_posterior_Law predicted, double dx, double dy, double width, double height);
double targets_posterior_log_total(double mean);
void targets_posterior_normalise(Vector out);
void targets_posterior_scores(targets_cursor_State * s, Table table, T10d answer, targets_posterior_Coefficients * coefficients, double elsewhere, Vector out);
targets_posterior_Situation targets_posterior_situation(targets_cursor_State * s);
T3d targets_posterior_unclaimed(targets_cursor_State * s, double x, double y);
void targets_prefetch_begin(targets_prefetch_State * s, Table table, Vector fired);
double targets_prefetch_contact(double x, double y, double dx, double dy, Vector row);
targets_prefetch_Expected targets_prefetch_expect(double x, double y, Table table, Vector visits, Vector shares);
bool targets_prefetch_inside(double x, double y, Vector row);
double targets_prefetch_least_visit(double lowest, targets_prefetch_Expected expected, targets_prefetch_Settings * settings);
double targets_prefetch_log_odds(double p);
double targets_prefetch_score(targets_cursor_State * s, Vector row, double share, double visited, targets_prefetch_Expected expected, targets_prefetch_Settings * settings);
int64_t targets_prefetch_step(targets_prefetch_State * s, T_Table_3_Vector_ targets, Vector shares, targets_prefetch_Settings * settings);
T6d targets_prefetch_terms(targets_cursor_State * s, Vector row, double share, double visited, targets_prefetch_Expected expected);
void targets_prefetch_visit(double x, double y, Table table, Vector shares, Vector out);
void targets_rectangles_complete(Table rows);
int64_t targets_rectangles_holder(Table table, double x, double y);
void training_calibration_fill_reaches(double level, Vector tail, Vector far);
T2d transfer_assistance_add(transfer_assistance_Guard * guard, transfer_pixels_Carried * owed, double dt, T2d own, T5d way);
T3d transfer_assistance_assisted_step(transfer_assistance_Assisted * memory, T5d report);
T5d transfer_assistance_guarded_step(transfer_assistance_Guarded * memory, T8d report);
T2d transfer_assistance_guide(transfer_assistance_Guard * guard, double dt, T2d own, T5d way);
T8d transfer_assistance_guided_report_at(Table rows, int64_t i);
T5d transfer_assistance_offset_report_at(Table rows, int64_t i);
static inline double transfer_assistance_pull(double rho, double strength, double dt, double own_px, double off_x, double off_y);
double transfer_assistance_spread(double way_px, double sxx, double sxy, double syy, double unclaimed);
void transfer_bands_learn(Vector memory, transfer_bands_Model model, double band, Vector row, double output);
int64_t transfer_bands_states(int64_t n);
double transfer_functions_cursor_speed(transfer_functions_Function * f, double speed);
void transfer_functions_evaluate(transfer_functions_Function * f, Vector speeds, bool wanted_gain, Vector out);
double transfer_functions_gain(transfer_functions_Function * f, double speed);
T6d transfer_identification_event_at(Table rows, int64_t i);
void transfer_identification_gather(transfer_identification_Settings * settings, transfer_identification_Window * window, double dt, double dx, double dy);
void transfer_identification_learn(transfer_identification_Memory * memory, Vector row, double output, double speed);
void transfer_identification_learn_speeds(transfer_identification_Memory * memory, double speed, double cursor_speed);
void transfer_identification_open_window(transfer_identification_State * s);
Td transfer_identification_step(transfer_identification_Memory * memory, T6d event);
Tbd transfer_pixels_accept(transfer_pixels_Memory * memory, double t, double dx, double dy);
static inline double transfer_pixels_carry(transfer_pixels_Carried * carried, int64_t axis, double moved_px);
void transfer_pixels_lay_out(Vector memory, Vector own, T4d device, transfer_functions_Function * function);
T3d transfer_pixels_report_at(Table rows, int64_t i);
T3d transfer_pixels_step(transfer_pixels_Memory * memory, T3d report);
double transfer_pixels_turn(transfer_pixels_Memory * memory, double t, double dt, double dx, double dy);
static const int64_t differentiators_sampling_MOVED = 2;
static const int64_t differentiators_sampling_RESTARTED = 1;
static const double predictors_adaptation_levels_FURTHEST = 6.0;
static const double predictors_adaptation_levels_STEP = 6.0;
static const double predictors_adaptation_levels_STEP_LEAST = 0.2;
static const double predictors_adaptation_levels_STEP_OF = 5.0;
static const double predictors_adaptation_moments_APART_S = 0.0071;
static const int64_t predictors_adaptation_time_left_FINE = 0;
static const double predictors_adaptation_time_left_LEAST_PIVOT = 0.01;
static const int64_t predictors_adaptation_time_left_NOT_POSITIVE = 31;
static const int64_t predictors_adaptation_time_left_SUMS = 28;
static const double predictors_mixture_HEAVINESS_LEAST = 1e-06;
static const double predictors_mixture_HEAVINESS_MOST = 40.0;
static const T2d predictors_mixture_LEVELS = {0.5, 0.8};
static const double predictors_mixture_PROBABILITY_MOST = 0.999999999;
static const double predictors_movement_BALLISTIC = 1.0;
static const double predictors_movement_CORRECTIVE = 2.0;
static const double predictors_movement_CORRECTIVE_FRACTION = 0.2;
static const double predictors_movement_STILL = 0.0;
static const double predictors_movement_STILL_M_S = 0.002;
static const int64_t records_EVENT_FIELD = 2;
static const int64_t records_FINE = 0;
static const double records_LARGEST = 1000000000.0;
static const double records_LATEST_S = 100000000000.0;
static const int64_t records_MOTION_FIELD = 8;
static const int64_t records_ORDER = 1;
static const double records_ROUNDING_S = 1e-06;
static const double regions_LARGEST_LOG = 700.0;
static const double regions_NEARLY_NORMAL = 1e+16;
static const double targets_cursor_SLOWER_S = 0.06;
static const double targets_cursor_SPEED_S = 0.03;
static const double targets_cursor_TRAIL_SHARE = 0.35;
static const int64_t targets_ledger_ENTRY = 1;
static const int64_t targets_ledger_ENTRY_SINCE = 2;
static const int64_t targets_ledger_MADE = 0;
static const int64_t targets_rectangles_NOBODY = -1;

/* Whether the values make an event: all within their bounds, buttons whole, counts both or none (NaN). */
static inline int64_t records_fault_of_event(records_EventRow event) {
  double t, x, y, dx, dy, buttons;
  t = event.t;
  x = event.x;
  y = event.y;
  dx = event.dx;
  dy = event.dy;
  buttons = event.buttons;
  if (!(fabs(t) <= records_LATEST_S)) {
    return records_EVENT_FIELD;
  }
  if (!(fabs(x) <= records_LARGEST)) {
    return records_EVENT_FIELD + 1;
  }
  if (!(fabs(y) <= records_LARGEST)) {
    return records_EVENT_FIELD + 2;
  }
  if (!(dx != dx && dy != dy)) {
    if (!(fabs(dx) <= records_LARGEST)) {
      return records_EVENT_FIELD + 3;
    }
    if (!(fabs(dy) <= records_LARGEST)) {
      return records_EVENT_FIELD + 4;
    }
  }
  if (!((0.0 <= buttons && buttons <= records_LARGEST) && buttons == (int64_t)floor(buttons))) {
    return records_EVENT_FIELD + 5;
  }
  return records_FINE;
}

/* The answer of a law to a row that it refuses: NaN for a time, why, and what it was compared with. */
static inline T10d records_refused(int64_t code, double value) {
  return (T10d){NAN, (double)code, value, NAN, NAN, NAN, NAN, NAN, NAN, NAN};
}

/* One event through the differences of both axes. */
static inline T10d differentiators_difference_step(differentiators_difference_Memory * memory, records_EventRow event) {
  differentiators_difference_Settings * settings;
  differentiators_sampling_State * samples;
  differentiators_difference_Differences * last;
  int64_t verdict;
  bool start;
  double dt, settled;
  T2d velocity, acceleration;
  settings = &memory->settings;
  samples = &memory->state.sampling;
  last = &memory->state.last;
  Tq3db values_1 = differentiators_sampling_accept(&settings->sampling, samples, event);
  verdict = values_1.f0;
  start = values_1.f4;
  if (verdict < 0) {
    return records_refused(-verdict, samples->t);
  }
  if (verdict == differentiators_sampling_RESTARTED) {
    memset(last, 0, sizeof(differentiators_difference_Differences));
    last->t = samples->t;
  }
  dt = samples->t - last->t;
  if (verdict == differentiators_sampling_MOVED && dt >= settings->shortest_s) {
    differentiators_difference_advance(last, 0, samples->u, dt);
    differentiators_difference_advance(last, 1, samples->v, dt);
    last->t = samples->t;
    last->span_s = dt;
  }
  velocity = (T2d){last->v[0], last->v[1]};
  acceleration = (T2d){last->a[0], last->a[1]};
  settled = differentiators_sampling_settled(samples, 3.0, 2.0 * settings->shortest_s);
  return differentiators_sampling_motion(samples, event, (T2_T2d_){velocity, acceleration}, settled, start);
}

/* One event through the differentiator of both axes. */
static inline T10d differentiators_homogeneous_step(differentiators_homogeneous_Memory * memory, records_EventRow event) {
  differentiators_homogeneous_Settings * settings;
  differentiators_sampling_State * samples;
  differentiators_homogeneous_Estimates * z;
  int64_t verdict, steps;
  double dt, before_u, before_v, h, settled;
  bool start, second;
  T2d velocity, acceleration;
  settings = &memory->settings;
  samples = &memory->state.sampling;
  z = &memory->state.estimates;
  Tq3db values_1 = differentiators_sampling_accept(&settings->sampling, samples, event);
  verdict = values_1.f0;
  dt = values_1.f1;
  before_u = values_1.f2;
  before_v = values_1.f3;
  start = values_1.f4;
  if (verdict < 0) {
    return records_refused(-verdict, samples->t);
  }
  if (verdict == differentiators_sampling_RESTARTED) {
    memset(z, 0, sizeof(differentiators_homogeneous_Estimates));
  } else if (verdict == differentiators_sampling_MOVED) {
    steps = (int64_t)ceil(dt / settings->step_s);
    h = dt / steps;
    z->slope[0] = differentiators_homogeneous_advance(settings, &z->x, before_u, samples->u, h, steps);
    z->slope[1] = differentiators_homogeneous_advance(settings, &z->y, before_v, samples->v, h, steps);
  }
  second = settings->order == 2.0;
  velocity = (T2d){z->x.z[1], z->y.z[1]};
  acceleration = (T2d){second ? z->slope[0] : z->x.z[2], second ? z->slope[1] : z->y.z[2]};
  settled = differentiators_sampling_settled(samples, settings->order + 1.0, settings->settle_s);
  return differentiators_sampling_motion(samples, event, (T2_T2d_){velocity, acceleration}, settled, start);
}

/* One axis after ``dt`` s of constant acceleration. */
static inline void differentiators_kalman_predict(Vector axis, double dt) {
  axis.p[0] += dt * (axis.p[1] + 0.5 * dt * axis.p[2]);
  axis.p[1] += dt * axis.p[2];
}

/* Covariance after ``dt`` s: P <- F P F' + Q, Q that of white jerk integrated exactly. */
static inline void differentiators_kalman_spread(differentiators_kalman_Covariance * p, double jerk_density, double dt) {
  double half, q, f00, f01, f02, g11, g12;
  half = 0.5 * dt * dt;
  q = jerk_density * dt;
  f00 = p->p00 + dt * p->p01 + half * p->p02;
  f01 = p->p01 + dt * p->p11 + half * p->p12;
  f02 = p->p02 + dt * p->p12 + half * p->p22;
  g11 = p->p11 + dt * p->p12;
  g12 = p->p12 + dt * p->p22;
  p->p00 = f00 + dt * f01 + half * f02 + q * whole_power(dt, 4) / 20.0;
  p->p01 = f01 + dt * f02 + q * whole_power(dt, 3) / 8.0;
  p->p02 = f02 + q * dt * dt / 6.0;
  p->p11 = g11 + dt * g12 + q * dt * dt / 3.0;
  p->p12 = g12 + q * dt / 2.0;
  p->p22 = p->p22 + q;
}

/* One axis after its position was measured with variance ``noise``; the covariance stays. */
static inline void differentiators_kalman_correct(Vector axis, differentiators_kalman_Covariance * p, double noise, double measured) {
  double share;
  share = (measured - axis.p[0]) / (p->p00 + noise);
  axis.p[0] += p->p00 * share;
  axis.p[1] += p->p01 * share;
  axis.p[2] += p->p02 * share;
}

/* Covariance after a position was measured with variance ``noise``. */
static inline void differentiators_kalman_narrow(differentiators_kalman_Covariance * p, double noise) {
  double p00, p01, p02, total;
  p00 = p->p00;
  p01 = p->p01;
  p02 = p->p02;
  total = p00 + noise;
  p->p11 = max_float(p->p11 - p01 * p01 / total, 0.0);
  p->p12 -= p01 * p02 / total;
  p->p22 = max_float(p->p22 - p02 * p02 / total, 0.0);
  p->p00 = p00 * noise / total;
  p->p01 = p01 * noise / total;
  p->p02 = p02 * noise / total;
}

/* One event through the filter of both axes. */
static inline T10d differentiators_kalman_step(differentiators_kalman_Memory * memory, records_EventRow event) {
  differentiators_kalman_Settings * settings;
  differentiators_sampling_State * samples;
  differentiators_kalman_Plane * plane;
  int64_t verdict;
  double dt, settled;
  bool start;
  T2d velocity, acceleration;
  settings = &memory->settings;
  samples = &memory->state.sampling;
  plane = &memory->state.plane;
  Tq3db values_1 = differentiators_sampling_accept(&settings->sampling, samples, event);
  verdict = values_1.f0;
  dt = values_1.f1;
  start = values_1.f4;
  if (verdict < 0) {
    return records_refused(-verdict, samples->t);
  }
  if (verdict == differentiators_sampling_RESTARTED) {
    differentiators_kalman_restart(plane, settings->noise);
  } else if (verdict == differentiators_sampling_MOVED) {
    differentiators_kalman_follow(plane, settings->jerk_density, settings->noise, dt, (T2d){samples->u, samples->v});
  }
  velocity = (T2d){plane->x[1], plane->y[1]};
  acceleration = (T2d){plane->x[2], plane->y[2]};
  settled = differentiators_sampling_settled(samples, 4.0, differentiators_kalman_settle_s(settings, samples));
  return differentiators_sampling_motion(samples, event, (T2_T2d_){velocity, acceleration}, settled, start);
}

/* What is wrong with numbers that are each within their bounds, and the number that is wrong. */
static inline Tqd predictors_adaptation_time_left_fault(predictors_adaptation_time_left_Sums * learned, Vector prior) {
  double least;
  double buffer_1[28];
  least = predictors_adaptation_time_left_factor(learned, prior, (Vector){buffer_1, predictors_adaptation_time_left_SUMS});
  return least >= predictors_adaptation_time_left_LEAST_PIVOT ? (Tqd){predictors_adaptation_time_left_FINE, 0.0} : (Tqd){predictors_adaptation_time_left_NOT_POSITIVE, least};
}

/* Whether a moment at ``t`` lies before a share of the time between the start and the end in s. */
static inline bool predictors_adaptation_moments_has_come(predictors_adaptation_moments_Series * s, double t, T2d span, double share) {
  double start, end;
  start = span.f0;
  end = span.f1;
  return t - start <= share * (end - start) + records_ROUNDING_S + 0.5 * s->apart;
}

/* How much is learned from the n-th movement. */
static inline double predictors_adaptation_levels_step_after(double movements) {
  return max_float(predictors_adaptation_levels_STEP / (movements + predictors_adaptation_levels_STEP_OF), predictors_adaptation_levels_STEP_LEAST);
}

/* Share of the probability that a law, as ``record`` takes it, gives to places nearer than the end. */
static inline double predictors_adaptation_region_widening_probability_within(T6d region, double x, double y) {
  double centre_x, centre_y, sxx, sxy, syy, tail, dx, dy, determinant, far;
  centre_x = region.f0;
  centre_y = region.f1;
  sxx = region.f2;
  sxy = region.f3;
  syy = region.f4;
  tail = region.f5;
  dx = x - centre_x;
  dy = y - centre_y;
  determinant = sxx * syy - sxy * sxy;
  if (!(determinant > 0.0)) {
    return 1.0;
  }
  far = (syy * dx * dx - 2.0 * sxy * dx * dy + sxx * dy * dy) / determinant;
  return 1.0 - exp(-0.5 * tail * log(1.0 + max_float(far, 0.0) / tail));
}

/* Learn from an end inside or outside the region of a level that was stated at a share of the time. */
static inline void predictors_adaptation_levels_learn(predictors_adaptation_levels_Offsets * s, double share, int64_t which, bool inside, double step) {
  int64_t stage;
  double part, missed;
  Tqd values_1 = predictors_adaptation_stages_interpolation(share);
  stage = values_1.f0;
  part = values_1.f1;
  missed = inside ? ((const double *)&predictors_mixture_LEVELS)[which] - 1.0 : ((const double *)&predictors_mixture_LEVELS)[which];
  s->values[stage][which] = predictors_adaptation_stages_bounded(s->values[stage][which] + step * (1.0 - part) * missed, predictors_adaptation_levels_FURTHEST);
  s->values[stage + 1][which] = predictors_adaptation_stages_bounded(s->values[stage + 1][which] + step * part * missed, predictors_adaptation_levels_FURTHEST);
}

/* The probability of the places that are denser than a place: exact for a single part. */
static inline double predictors_mixture_content(Table parts, int64_t count, double x, double y, int64_t points) {
  predictors_mixture_PartRow * part;
  double own, best, power;
  Table known;
  if (count == 1) {
    part = (predictors_mixture_PartRow *)((Vector){parts.p + 0 * parts.m, parts.m}.p);
    own = predictors_mixture_part_density(part, x, y);
    best = predictors_mixture_part_density(part, part->x, part->y);
    power = part->tail == 0.0 ? 1.0 : part->tail / (part->tail + 2.0);
    return 1.0 - pow(own / best, power);
  }
  RELEASED double *buffer_1 = reserved(count * points);
  known = (Table){buffer_1, count, points};
  predictors_mixture_densities(parts, count, points, known);
  return predictors_mixture_share_above(parts, count, points, known, predictors_mixture_density(parts, count, x, y));
}

/* 2 / tail within bounds. */
static inline double predictors_mixture_heaviness(double tail) {
  return min_float(max_float(2.0 / tail, predictors_mixture_HEAVINESS_LEAST), predictors_mixture_HEAVINESS_MOST);
}

/* ``squared_radius_over_tail`` of a level with its offset. */
static inline double predictors_mixture_corrected_radius(double level, double heavy, double offset) {
  double lower;
  lower = exp(min_float(offset, 0.0));
  return exp(max_float(offset, 0.0)) * (exp(-heavy * log(1.0 - level) * lower) - 1.0);
}

/* The probability that the region of a level must have so that it holds that share of the ends. */
static inline double predictors_mixture_corrected_probability(double level, double tail, double near, double far) {
  double radius, half, most, part, heavy, own;
  radius = log(-log(1.0 - level));
  half = log(-log(1.0 - predictors_mixture_LEVELS.f0));
  most = log(-log(1.0 - predictors_mixture_LEVELS.f1));
  part = min_float(max_float((radius - half) / (most - half), 0.0), 1.0);
  heavy = predictors_mixture_heaviness(tail);
  own = predictors_mixture_corrected_radius(level, heavy, near + part * (far - near));
  if (level > predictors_mixture_LEVELS.f0) {
    own = max_float(own, predictors_mixture_corrected_radius(predictors_mixture_LEVELS.f0, heavy, near));
  }
  return min_float(1.0 - exp(-log(1.0 + own) / heavy), predictors_mixture_PROBABILITY_MOST);
}

/* The offset of a level at a share of the time: on lines between the stages. */
static inline double predictors_adaptation_levels_offset(predictors_adaptation_levels_Offsets * s, double share, int64_t which) {
  int64_t stage;
  double part, low;
  Tqd values_1 = predictors_adaptation_stages_interpolation(share);
  stage = values_1.f0;
  part = values_1.f1;
  low = s->values[stage][which];
  return low + part * (s->values[stage + 1][which] - low);
}

/* The number of the moment that a cursor (t, x, y) is written to, -1 for none; whether to thin out first. */
static inline Tqb predictors_adaptation_moments_next_moment(predictors_adaptation_moments_Series * s, double last_t, T3d cursor, int64_t most) {
  double t, x, y;
  int64_t count;
  bool full;
  t = cursor.f0;
  x = cursor.f1;
  y = cursor.f2;
  count = (int64_t)s->count;
  full = false;
  if (count == 0 || t != last_t) {
    if (count == 0) {
      s->apart = predictors_adaptation_moments_APART_S;
    } else if (t - last_t < s->apart) {
      return (Tqb){-1, false};
    }
    if (count == most) {
      if (x == s->cursor_x && y == s->cursor_y) {
        return (Tqb){-1, false};
      }
      count = floor_divided_whole(most, 2);
      full = true;
      s->apart *= 2.0;
    }
    count += 1;
    s->count = count;
  }
  s->cursor_x = x;
  s->cursor_y = y;
  return (Tqb){count - 1, full};
}

/* Squared radius of a level's region over the tail; ``heavy``: 2 / tail. */
static inline double predictors_mixture_squared_radius_over_tail(double level, double heavy) {
  return exp(-heavy * log(1.0 - level)) - 1.0;
}

/* Take one motion in: (its fault, a movement starts here, dt in s since the motion before). */
static inline Tqbd predictors_movement_follow(predictors_movement_State * s, records_MotionRow m) {
  double t, x, y, dt;
  int64_t fault;
  bool new;
  t = m.t;
  x = m.x;
  y = m.y;
  fault = predictors_movement_fault_of(s, m);
  if (fault != records_FINE) {
    return (Tqbd){fault, false, 0.0};
  }
  new = m.start == 1.0 || s->known == 0.0;
  dt = new ? 0.0 : t - s->t;
  if (new || t == s->t0) {
    s->t0 = t;
    s->x0 = x;
    s->y0 = y;
    s->path = 0.0;
  } else {
    s->path += hypot(x - s->x, y - s->y);
  }
  if (new) {
    s->peak = 0.0;
  }
  s->known = 1.0;
  s->t = t;
  s->x = x;
  s->y = y;
  s->peak = max_float(s->peak, hypot(m.vx, m.vy));
  return (Tqbd){records_FINE, new, dt};
}

/* Share of the time and of the way done, from the speed as a share of its peak, after the peak. */
static inline T2d predictors_minimum_jerk_progress(double ratio) {
  double tau;
  tau = 0.5 * (1.0 + sqrt(1.0 - sqrt(min_float(max_float(ratio, 0.0), 1.0))));
  return (T2d){tau, tau * tau * tau * (10.0 - tau * (15.0 - 6.0 * tau))};
}

/* The answer to a motion with a fault. */
static inline T10d predictors_movement_refuse(predictors_movement_State * s, records_MotionRow m, int64_t fault) {
  return records_refused(fault, fault == records_ORDER ? s->t : ((const double *)&m)[fault - records_MOTION_FIELD]);
}

/* The phase by speed alone: still, ballistic above a fifth of the peak, corrective below. */
static inline double predictors_movement_phase(predictors_movement_State * s, records_MotionRow m) {
  double speed;
  speed = hypot(m.vx, m.vy);
  if (speed < predictors_movement_STILL_M_S) {
    return predictors_movement_STILL;
  }
  return speed >= predictors_movement_CORRECTIVE_FRACTION * s->peak ? predictors_movement_BALLISTIC : predictors_movement_CORRECTIVE;
}

/* The row of a prediction that claims an endpoint and nothing else; ``x`` is NaN where it claims none. */
static inline T10d records_endpoint(double t, double x, double y, double phase) {
  return (T10d){t, x, y, NAN, NAN, NAN, NAN, phase, NAN, NAN};
}

/* The parts of ``numbers(n)`` floats. */
static inline regression_least_squares_Regression regression_least_squares_parts(Vector memory, int64_t n) {
  return (regression_least_squares_Regression){(Vector){memory.p, n}, (Vector){memory.p + n, 2 * n - n}, (Table){(Vector){memory.p + 2 * n, 2 * n + n * n - 2 * n}.p, n, n}};
}

/* A row of a table of motions or of predictions as a tuple. */
static inline T10d records_row_at(Table table, int64_t i) {
  Vector r;
  r = (Vector){table.p + i * table.m, table.m};
  return (T10d){r.p[0], r.p[1], r.p[2], r.p[3], r.p[4], r.p[5], r.p[6], r.p[7], r.p[8], r.p[9]};
}

/* The parts of ``numbers(n)`` floats. */
static inline regression_drem_Regression regression_drem_parts(Vector memory, int64_t n) {
  int64_t tables, ring;
  tables = 5 * n;
  ring = tables + 2 * n * n;
  return (regression_drem_Regression){(Vector){memory.p, n}, (Vector){memory.p + n, 2 * n - n}, (Vector){memory.p + 2 * n, 3 * n - 2 * n}, (Vector){memory.p + 3 * n, 4 * n - 3 * n}, (Vector){memory.p + 4 * n, 5 * n - 4 * n}, (Table){(Vector){memory.p + tables, tables + n * n - tables}.p, n, n}, (Vector){memory.p + (tables + n * n), ring - (tables + n * n)}, (Vector){memory.p + ring, memory.n - ring}};
}

/* A row of a table of events as a tuple. */
static inline T6d records_event_at(Table table, int64_t i) {
  Vector r;
  r = (Vector){table.p + i * table.m, table.m};
  return (T6d){r.p[0], r.p[1], r.p[2], r.p[3], r.p[4], r.p[5]};
}

/* Squared Mahalanobis distance up to which the region of a level in (0, 1) goes. */
static inline double regions_reach(double level, double tail) {
  double normal;
  normal = -2.0 * log1p(-level);
  if (!(tail < regions_NEARLY_NORMAL)) {
    return normal;
  }
  if (tail <= 0.0) {
    return NAN;
  }
  if (normal / tail > regions_LARGEST_LOG) {
    return INFINITY;
  }
  return tail * expm1(normal / tail);
}

/* Take an event in, a usable one that is not before the last; returns whether a button was released. */
static inline bool targets_cursor_follow(targets_cursor_State * s, double t, double x, double y, double pressed) {
  double dt, way, far, share;
  bool released;
  dt = t - s->t;
  released = s->pressed == 1.0 && pressed == 0.0;
  if (targets_cursor_begins(s, t, pressed) || t == s->t0) {
    s->t0 = t;
    s->x0 = x;
    s->y0 = y;
    s->trail_x = x;
    s->trail_y = y;
    s->peak = 0.0;
    s->slow = s->peak;
    s->speed = s->peak;
    s->vy = s->peak;
    s->vx = s->peak;
  } else {
    way = hypot(x - s->x, y - s->y);
    far = hypot(x - s->x0, y - s->y0);
    share = far > 0.0 ? 1.0 - exp(-way / (targets_cursor_TRAIL_SHARE * far)) : 1.0;
    s->trail_x += share * (x - s->trail_x);
    s->trail_y += share * (y - s->trail_y);
    if (dt > 0.0) {
      share = 1.0 - exp(-dt / targets_cursor_SPEED_S);
      s->vx += share * ((x - s->x) / dt - s->vx);
      s->vy += share * ((y - s->y) / dt - s->vy);
      s->speed = hypot(s->vx, s->vy);
      s->slow += (1.0 - exp(-dt / targets_cursor_SLOWER_S)) * (s->speed - s->slow);
    }
    s->peak = max_float(s->peak, s->speed);
  }
  s->known = 1.0;
  s->pressed = pressed;
  s->t = t;
  s->x = x;
  s->y = y;
  return released;
}

/* The cursor goes into a target; only the first time in a movement counts. */
static inline void targets_ledger_enter(targets_ledger_State * s, Table rows, double t, int64_t place) {
  if (place != targets_rectangles_NOBODY && rows.p[place * rows.m + targets_ledger_ENTRY] != rows.p[place * rows.m + targets_ledger_ENTRY]) {
    rows.p[place * rows.m + targets_ledger_ENTRY] = t;
    rows.p[place * rows.m + targets_ledger_ENTRY_SINCE] = s->standing == place ? s->since : NAN;
  }
}

/* The target that is proposed from now on, NOBODY for none; ``bounds``: (ask, keep, least_s, least_px). */
static inline int64_t targets_decision_decide(targets_cursor_State * s, Table table, Vector shares, int64_t standing, double remaining_s, T4d bounds) {
  double ask, keep, least_s, least_px, far;
  int64_t best;
  ask = bounds.f0;
  keep = bounds.f1;
  least_s = bounds.f2;
  least_px = bounds.f3;
  best = targets_decision_likeliest(shares, table.n);
  if (best == targets_rectangles_NOBODY) {
    return targets_rectangles_NOBODY;
  }
  if (standing != targets_rectangles_NOBODY && (best == standing || shares.p[best] < ask)) {
    return shares.p[standing] >= keep ? standing : targets_rectangles_NOBODY;
  }
  far = hypot(s->x - s->x0, s->y - s->y0);
  if (shares.p[best] >= ask && far >= least_px && targets_decision_early(s, (Vector){table.p + best * table.m, table.m}, remaining_s, least_s)) {
    return best;
  }
  if (standing != targets_rectangles_NOBODY && shares.p[standing] >= keep) {
    return standing;
  }
  return targets_rectangles_NOBODY;
}

/* The proposal that stands ends; where this target's does not stand, nothing happens. */
static inline void targets_ledger_withdraw(targets_ledger_State * s, double t, int64_t place, bool released) {
  if (place == targets_rectangles_NOBODY || s->standing != place) {
    return;
  }
  s->standing = targets_rectangles_NOBODY;
  if (released) {
    int64_t value_1 = place;
    double value_2 = t;
    double value_3 = s->since;
    s->ended = value_1;
    s->ended_at = value_2;
    s->ended_since = value_3;
  } else {
    s->retracted += 1.0;
  }
}

/* A proposal is made; it takes the place of one that stands. */
static inline void targets_ledger_propose(targets_ledger_State * s, Table rows, double t, int64_t place) {
  s->proposed += 1.0;
  s->standing = place;
  s->since = t;
  if (place != targets_rectangles_NOBODY) {
    rows.p[place * rows.m + targets_ledger_MADE] += 1.0;
  }
}

/* How often the target of the movement was proposed, and the leads before its entry and its click, s. */
static inline T3d targets_ledger_close(targets_ledger_State * s, Table rows, double t, int64_t place) {
  double entry, since;
  if (place == targets_rectangles_NOBODY) {
    return (T3d){0.0, NAN, NAN};
  }
  entry = rows.p[place * rows.m + targets_ledger_ENTRY];
  since = rows.p[place * rows.m + targets_ledger_ENTRY_SINCE];
  if (entry != entry) {
    entry = t;
    if (s->ended == place && s->ended_at == t) {
      since = s->ended_since;
    } else if (s->standing == place) {
      since = s->since;
    }
  }
  return (T3d){rows.p[place * rows.m + targets_ledger_MADE], entry - since, t - since};
}

/* The fraction of the offset (T_hat - x, T_hat_y - y) by which the cursor is pulled in ``dt`` s. */
static inline double transfer_assistance_pull(double rho, double strength, double dt, double own_px, double off_x, double off_y) {
  double length, share;
  length = hypot(off_x, off_y);
  if (!(0.0 < length && length < INFINITY)) {
    return 0.0;
  }
  share = -expm1(-rho * dt);
  return strength < INFINITY ? min_float(share, strength * own_px / length) : share;
}

/* Whole pixels of one axis, 0 or 1; the remainder is carried until the direction reverses. */
static inline double transfer_pixels_carry(transfer_pixels_Carried * carried, int64_t axis, double moved_px) {
  double rest, whole;
  rest = carried->px[axis] * moved_px >= 0.0 ? carried->px[axis] : 0.0;
  whole = (double)(int64_t)trunc(rest + moved_px);
  carried->px[axis] = rest + moved_px - whole;
  return whole;
}

/* What most stages do when a movement ends. */
static inline void stage_learn_nothing(Vector memory) {
}
#endif
