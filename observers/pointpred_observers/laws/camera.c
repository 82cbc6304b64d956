/* Written by `make laws` from the laws: change those and run it again. */
#include "laws.h"

static const double records_LATEST_S = 100000000000.0;
static const double camera_depth_LARGEST_RATE = 1000.0;
static const double camera_kinematics_SMALL = 0.0001;
static const double camera_point_filter_NEAREST_M = 0.0001;
static const double camera_point_filter_RUNNING = 2.0;
static const double camera_point_filter_STARTING = 1.0;
static const double camera_point_filter_WAITING = 0.0;
static const double camera_samples_AT_REST = 0.1;
static const double camera_samples_LARGEST_A = 10000.0;
static const double camera_samples_LARGEST_PX = 1000000.0;
static const double camera_samples_LARGEST_W = 1000.0;
static const double camera_samples_SUBSTEP_S = 0.05;
static const double camera_velocity_EVER_S = 200000000000.0;
static const double camera_velocity_SPREAD_START = 1.0;

/* (chi, r)' with r = eta + w_y x - w_x y, the last row of T x: no unknown input in it. */
T2d camera_depth_rate(double chi, double r, camera_depth_Measured m, double dwx, double dwy) {
  double x, y, wx, wy, wz, az, eta, flow_x, flow_y, driven;
  x = m.x;
  y = m.y;
  wx = m.wx;
  wy = m.wy;
  wz = m.wz;
  az = m.az;
  eta = r - wy * x + wx * y;
  flow_x = x * y * wx - (1.0 + x * x) * wy + y * wz;
  flow_y = (1.0 + y * y) * wx - x * y * wy - x * wz;
  driven = wy * flow_x - wx * flow_y + dwy * x - dwx * y;
  return (T2d){(y * wx - x * wy + eta) * chi, az * chi + eta * eta + driven};
}

/* Move (chi, r) over ``dt`` s by Runge-Kutta, with measurements linear between two samples. */
void camera_depth_carry(camera_depth_State * state, camera_depth_Measured m, double dt) {
  double x0, y0, az0, wx0, wy0, wz0, dwx, dwy, h, chi, r, sum_chi, sum_r, k_chi, k_r, inner, s, share;
  int64_t steps;
  camera_depth_Measured between;
  x0 = state->x;
  y0 = state->y;
  az0 = state->az;
  wx0 = state->wx;
  wy0 = state->wy;
  wz0 = state->wz;
  dwx = (m.wx - wx0) / dt;
  dwy = (m.wy - wy0) / dt;
  steps = (int64_t)ceil(dt / camera_samples_SUBSTEP_S);
  h = dt / steps;
  for (int64_t i = 0; i < steps; i++) {
    chi = state->chi;
    r = state->r;
    sum_chi = 0.0;
    sum_r = 0.0;
    k_chi = 0.0;
    k_r = 0.0;
    for (int64_t stage = 0; stage < 4; stage++) {
      inner = stage == 0 ? 0.0 : stage == 3 ? 1.0 : 0.5;
      s = (i + inner) / steps;
      between = (camera_depth_Measured){x0 + s * (m.x - x0), y0 + s * (m.y - y0), wx0 + s * (m.wx - wx0), wy0 + s * (m.wy - wy0), wz0 + s * (m.wz - wz0), az0 + s * (m.az - az0)};
      T2d values_1 = camera_depth_rate(chi + inner * h * k_chi, r + inner * h * k_r, between, dwx, dwy);
      k_chi = values_1.f0;
      k_r = values_1.f1;
      share = stage == 0 || stage == 3 ? 1.0 : 2.0;
      sum_chi += share * k_chi;
      sum_r += share * k_r;
    }
    state->chi = chi + h / 6.0 * sum_chi;
    state->r = r + h / 6.0 * sum_r;
    if (!(fabs(state->r) <= camera_depth_LARGEST_RATE && fabs(state->chi) <= camera_samples_LARGEST_PX)) {
      state->lost = 1.0;
      state->chi = chi;
      state->r = r;
      return;
    }
  }
}

/* Whether the scheduling variables lie in the certificate's box; false without a certificate. */
bool camera_depth_inside(camera_depth_Memory * memory, double zero, double eta) {
  camera_depth_Settings * settings;
  camera_depth_State * s;
  T5d values;
  settings = &memory->settings;
  s = &memory->state;
  values = (T5d){zero, eta, s->az, s->wx, s->wy};
  for (int64_t i = 0; i < 5; i++) {
    if (!(settings->box[i][0] <= ((const double *)&values)[i] && ((const double *)&values)[i] <= settings->box[i][1])) {
      return false;
    }
  }
  return settings->box[0][0] < 0.0;
}

/* Whether a sample can be used: within the bounds, after the last one and within the longest gap. */
bool camera_samples_usable(camera_samples_CameraSample sample, double started, double last_t, double gap_s) {
  double t, x, y, wx, wy, wz, ax, ay, az;
  t = sample.t;
  x = sample.x;
  y = sample.y;
  wx = sample.wx;
  wy = sample.wy;
  wz = sample.wz;
  ax = sample.ax;
  ay = sample.ay;
  az = sample.az;
  if (!(fabs(t) <= records_LATEST_S && fabs(wx) <= camera_samples_LARGEST_W && fabs(wy) <= camera_samples_LARGEST_W && fabs(wz) <= camera_samples_LARGEST_W)) {
    return false;
  }
  if (!(fabs(ax) <= camera_samples_LARGEST_A && fabs(ay) <= camera_samples_LARGEST_A && fabs(az) <= camera_samples_LARGEST_A)) {
    return false;
  }
  if (!((x != x && y != y) || (fabs(x) <= camera_samples_LARGEST_PX && fabs(y) <= camera_samples_LARGEST_PX))) {
    return false;
  }
  return started != 1.0 || (last_t < t && t <= last_t + gap_s);
}

/* One sample; a ``Depth`` into ``out``, which is NaN before. */
void camera_depth_step(camera_depth_Memory * memory, Vector row, Vector out) {
  camera_depth_Settings * settings;
  camera_depth_State * s;
  double t, x, y, wx, wy, wz, az, flat_x, flat_y, eta, zero;
  bool image;
  settings = &memory->settings;
  s = &memory->state;
  t = row.p[0];
  x = row.p[1];
  y = row.p[2];
  wx = row.p[3];
  wy = row.p[4];
  wz = row.p[5];
  az = row.p[8];
  if (!camera_samples_usable((camera_samples_CameraSample){t, x, y, wx, wy, wz, row.p[6], row.p[7], az}, s->started, s->t, settings->gap_s)) {
    return;
  }
  image = x == x;
  flat_x = image ? x / settings->focal_px : s->x;
  flat_y = image ? y / settings->focal_px : s->y;
  if (s->imaged == 0.0 && image) {
    s->chi = settings->start_chi;
    s->r = settings->start_eta + wy * flat_x - wx * flat_y;
    s->imaged = 1.0;
  } else if (s->imaged == 1.0 && s->lost == 0.0) {
    camera_depth_carry(s, (camera_depth_Measured){flat_x, flat_y, wx, wy, wz, az}, t - s->t);
  }
  s->started = 1.0;
  s->t = t;
  s->x = flat_x;
  s->y = flat_y;
  s->wx = wx;
  s->wy = wy;
  s->wz = wz;
  s->az = az;
  out.p[0] = t;
  out.p[4] = 0.0;
  out.p[5] = 0.0;
  out.p[6] = image ? 1.0 : 0.0;
  if (s->imaged == 0.0 || s->lost == 1.0) {
    return;
  }
  eta = s->r - wy * flat_x + wx * flat_y;
  zero = flat_y * wx - flat_x * wy + eta;
  out.p[1] = s->chi;
  out.p[2] = eta;
  out.p[3] = zero;
  out.p[4] = zero < -settings->decay && eta < -settings->decay ? 1.0 : 0.0;
  out.p[5] = camera_depth_inside(memory, zero, eta) ? 1.0 : 0.0;
}

/* A vector in the frame after a rotation in rad: exp(-[turn]) applied to it (Rodrigues). */
T3d camera_kinematics_back(T3d turn, T3d vector) {
  double rx, ry, rz, x, y, z, square_, angle, s, c, ux, uy, uz, wx, wy, wz;
  rx = turn.f0;
  ry = turn.f1;
  rz = turn.f2;
  x = vector.f0;
  y = vector.f1;
  z = vector.f2;
  square_ = rx * rx + ry * ry + rz * rz;
  angle = sqrt(square_);
  if (angle < camera_kinematics_SMALL) {
    s = 1.0 - square_ / 6.0;
    c = 0.5 - square_ / 24.0;
  } else {
    s = sin(angle) / angle;
    c = (1.0 - cos(angle)) / square_;
  }
  ux = ry * z - rz * y;
  uy = rz * x - rx * z;
  uz = rx * y - ry * x;
  wx = ry * uz - rz * uy;
  wy = rz * ux - rx * uz;
  wz = rx * uy - ry * ux;
  return (T3d){x - s * ux + c * wx, y - s * uy + c * wy, z - s * uz + c * wz};
}

/* (p, v) after ``h`` s without acceleration: p - h v and v, in the rotated frame. */
T2_T3d_ camera_kinematics_carried(T3d p, T3d v, double h, T3d turn) {
  double px, py, pz, vx, vy, vz;
  px = p.f0;
  py = p.f1;
  pz = p.f2;
  vx = v.f0;
  vy = v.f1;
  vz = v.f2;
  return (T2_T3d_){camera_kinematics_back(turn, (T3d){px - h * vx, py - h * vy, pz - h * vz}), camera_kinematics_back(turn, v)};
}

/* ``carried`` of s = (p, v). */
void camera_kinematics_carry(Vector s, double h, T3d turn) {
  T3d p, v;
  T2_T3d_ values_1 = camera_kinematics_carried((T3d){s.p[0], s.p[1], s.p[2]}, (T3d){s.p[3], s.p[4], s.p[5]}, h, turn);
  p = values_1.f0;
  v = values_1.f1;
  s.p[0] = p.f0;
  s.p[1] = p.f1;
  s.p[2] = p.f2;
  s.p[3] = v.f0;
  s.p[4] = v.f1;
  s.p[5] = v.f2;
}

/* ``carried`` of a column of a matrix. */
void camera_kinematics_carry_column(camera_kinematics_Matrix * phi, int64_t i, double h, T3d turn) {
  T3d p, v;
  p = (T3d){phi->m[0][i], phi->m[1][i], phi->m[2][i]};
  v = (T3d){phi->m[3][i], phi->m[4][i], phi->m[5][i]};
  T2_T3d_ values_1 = camera_kinematics_carried(p, v, h, turn);
  p = values_1.f0;
  v = values_1.f1;
  phi->m[0][i] = p.f0;
  phi->m[1][i] = p.f1;
  phi->m[2][i] = p.f2;
  phi->m[3][i] = v.f0;
  phi->m[4][i] = v.f1;
  phi->m[5][i] = v.f2;
}

/* The effect on (p, v) in ``h`` s of an acceleration, linear from ``before`` to ``after`` the rotation. */
void camera_kinematics_push(Vector s, double h, T3d turn, T3d before, T3d after) {
  double bx, by, bz, ax, ay, az, square_;
  T3d values_1 = camera_kinematics_back(turn, before);
  bx = values_1.f0;
  by = values_1.f1;
  bz = values_1.f2;
  ax = after.f0;
  ay = after.f1;
  az = after.f2;
  square_ = h * h;
  s.p[0] -= square_ * (bx / 3.0 + ax / 6.0);
  s.p[1] -= square_ * (by / 3.0 + ay / 6.0);
  s.p[2] -= square_ * (bz / 3.0 + az / 6.0);
  s.p[3] += 0.5 * h * (bx + ax);
  s.p[4] += 0.5 * h * (by + ay);
  s.p[5] += 0.5 * h * (bz + az);
}

/* A covariance after ``h`` s: Phi P Phi'. */
void camera_kinematics_turn_covariance(camera_kinematics_Matrix * p, double h, T3d turn) {
  for (int64_t i = 0; i < 6; i++) {
    camera_kinematics_carry_column(p, i, h, turn);
  }
  for (int64_t i = 0; i < 6; i++) {
    camera_kinematics_carry((Vector){p->m[i], 6}, h, turn);
  }
}

/* Add the effect of sensor noise with variances (rad^2, m^2/s^2) on s = (p, v) to a covariance. */
WIDE void camera_kinematics_add_noise(camera_kinematics_Matrix * p, Vector s, double gyro, double accel) {
  int64_t i, j;
  double dot, value;
  for (int64_t block = 0; block < 2; block++) {
    for (int64_t other = 0; other < 2; other++) {
      i = 3 * block;
      j = 3 * other;
      dot = s.p[i] * s.p[j] + s.p[i + 1] * s.p[j + 1] + s.p[i + 2] * s.p[j + 2];
      for (int64_t row = 0; row < 3; row++) {
        for (int64_t column = 0; column < 3; column++) {
          value = (row == column ? dot : 0.0) - s.p[j + row] * s.p[i + column];
          p->m[i + row][j + column] += gyro * value;
        }
      }
    }
  }
  for (int64_t row = 3; row < 6; row++) {
    p->m[row][row] += accel;
  }
}

/* A state (p, v) and its covariance after ``h`` s, with the acceleration ``a`` before and after. */
void camera_kinematics_propagate(Vector s, camera_kinematics_Matrix * p, double h, T3d turn, T2_T3d_ a, double gyro, double accel) {
  camera_kinematics_carry(s, h, turn);
  camera_kinematics_push(s, h, turn, a.f0, a.f1);
  camera_kinematics_turn_covariance(p, h, turn);
  camera_kinematics_add_noise(p, s, gyro, accel);
}

/* Forget all images: Phi is the identity. */
void camera_kinematics_begin_start(camera_kinematics_Start * s) {
  memset(s, 0, sizeof(camera_kinematics_Start));
  for (int64_t i = 0; i < 6; i++) {
    s->phi.m[i][i] = 1.0;
  }
}

/* Add an image: N += Phi' Q Phi, b -= Phi' Q g, Q = H'H - 2 r e3 e3', H = (1 0 -x; 0 1 -y). */
WIDE void camera_kinematics_take_image(camera_kinematics_Start * s, double x, double y, double variance) {
  double corner, g0, g1, g2, a0, a1, a2, q0, q1, q2;
  corner = x * x + y * y - 2.0 * variance;
  g0 = s->g[0];
  g1 = s->g[1];
  g2 = s->g[2];
  for (int64_t i = 0; i < 6; i++) {
    a0 = s->phi.m[0][i];
    a1 = s->phi.m[1][i];
    a2 = s->phi.m[2][i];
    q0 = a0 - x * a2;
    q1 = a1 - y * a2;
    q2 = -x * a0 - y * a1 + corner * a2;
    s->right[i] -= q0 * g0 + q1 * g1 + q2 * g2;
    for (int64_t j = 0; j < 6; j++) {
      s->normal.m[i][j] += q0 * s->phi.m[0][j] + q1 * s->phi.m[1][j] + q2 * s->phi.m[2][j];
    }
  }
}

/* Cholesky's lower factor in place; false if the matrix is not safely positive definite. */
WIDE bool camera_kinematics_factor(camera_kinematics_Matrix * lower) {
  double own, total;
  for (int64_t i = 0; i < 6; i++) {
    own = lower->m[i][i];
    for (int64_t j = 0, end_1 = i + 1; j < end_1; j++) {
      total = lower->m[i][j];
      for (int64_t k = 0; k < j; k++) {
        total -= lower->m[i][k] * lower->m[j][k];
      }
      if (i == j) {
        if (!(total > 1e-12 * own)) {
          return false;
        }
        lower->m[i][i] = sqrt(total);
      } else {
        lower->m[i][j] = total / lower->m[j][j];
      }
    }
  }
  return true;
}

/* Solve with Cholesky's factor, the vector in place. */
WIDE void camera_kinematics_solve(camera_kinematics_Matrix * lower, Vector v) {
  double total;
  for (int64_t i = 0; i < 6; i++) {
    total = v.p[i];
    for (int64_t k = 0; k < i; k++) {
      total -= lower->m[i][k] * v.p[k];
    }
    v.p[i] = total / lower->m[i][i];
  }
  for (int64_t i = 5; i > (-1); i--) {
    total = v.p[i];
    for (int64_t k = i + 1; k < 6; k++) {
      total -= lower->m[k][i] * v.p[k];
    }
    v.p[i] = total / lower->m[i][i];
  }
}

/* Write the current (p, v) and covariance if the relative error of the depth is at most ``share``. */
bool camera_kinematics_started(camera_kinematics_Start * s, Vector state, camera_kinematics_Matrix * spread, double variance, double share) {
  double z0, z, square_, total;
  for (int64_t i = 0; i < 6; i++) {
    for (int64_t j = 0; j < 6; j++) {
      s->lower.m[i][j] = s->normal.m[i][j];
    }
  }
  if (!camera_kinematics_factor(&s->lower)) {
    return false;
  }
  for (int64_t i = 0; i < 6; i++) {
    double value_1 = s->right[i];
    double value_2 = s->g[i];
    s->first[i] = value_1;
    s->now[i] = value_2;
  }
  camera_kinematics_solve(&s->lower, (Vector){s->first, 6});
  for (int64_t i = 0; i < 6; i++) {
    for (int64_t j = 0; j < 6; j++) {
      s->now[i] += s->phi.m[i][j] * s->first[j];
    }
  }
  z0 = s->first[2];
  z = s->now[2];
  square_ = (z0 * z0 + z0 * z + z * z) / 3.0;
  if (!(z0 > 0.0 && z > 0.0)) {
    return false;
  }
  for (int64_t i = 0; i < 6; i++) {
    for (int64_t j = 0; j < 6; j++) {
      s->row[j] = s->phi.m[i][j];
    }
    camera_kinematics_solve(&s->lower, (Vector){s->row, 6});
    for (int64_t j = 0; j < 6; j++) {
      total = 0.0;
      for (int64_t k = 0; k < 6; k++) {
        total += s->row[k] * s->phi.m[j][k];
      }
      s->spread.m[i][j] = total * variance * square_ + s->noise.m[i][j];
    }
  }
  if (!(s->spread.m[2][2] < square(share * z))) {
    return false;
  }
  for (int64_t i = 0; i < 6; i++) {
    state.p[i] = s->now[i];
    for (int64_t j = 0; j < 6; j++) {
      spread->m[i][j] = 0.5 * (s->spread.m[i][j] + s->spread.m[j][i]);
    }
  }
  return true;
}

/* One coordinate of the image, linearised at the prediction (x, y, z). */
WIDE void camera_point_filter_correct(camera_point_filter_State * s, double noise, double measured, int64_t axis, T3d predicted) {
  double x, y, z, side, near, far, total, expected, share;
  x = predicted.f0;
  y = predicted.f1;
  z = predicted.f2;
  side = axis ? y : x;
  near = 1.0 / z;
  far = -side / (z * z);
  for (int64_t i = 0; i < 6; i++) {
    s->column[i] = s->spread.m[i][axis] * near + s->spread.m[i][2] * far;
  }
  total = s->column[axis] * near + s->column[2] * far + noise;
  expected = side * near + (s->state[axis] - side) * near + (s->state[2] - z) * far;
  share = (measured - expected) / total;
  for (int64_t i = 0; i < 6; i++) {
    s->state[i] += s->column[i] * share;
  }
  for (int64_t i = 0; i < 6; i++) {
    for (int64_t j = 0; j < 6; j++) {
      s->spread.m[i][j] -= s->column[i] * s->column[j] / total;
    }
  }
}

/* Propagate over ``dt`` s: the state and its covariance, or the sums of the initialisation. */
void camera_point_filter_predict(camera_point_filter_Memory * memory, double dt, T3d w, T3d a) {
  camera_point_filter_Settings * settings;
  camera_point_filter_State * s;
  T3d turn, before;
  double accel;
  settings = &memory->settings;
  s = &memory->state;
  turn = (T3d){0.5 * dt * (s->wx + w.f0), 0.5 * dt * (s->wy + w.f1), 0.5 * dt * (s->wz + w.f2)};
  before = (T3d){s->ax, s->ay, s->az};
  accel = settings->accel * dt;
  if (s->mode == camera_point_filter_RUNNING) {
    camera_kinematics_propagate((Vector){s->state, 6}, &s->spread, dt, turn, (T2_T3d_){before, a}, settings->gyro * dt, accel);
    return;
  }
  for (int64_t i = 0; i < 6; i++) {
    camera_kinematics_carry_column(&s->start.phi, i, dt, turn);
  }
  camera_kinematics_propagate((Vector){s->start.g, 6}, &s->start.noise, dt, turn, (T2_T3d_){before, a}, 0.0, accel);
}

/* Process an image: correct the state, or initialise it. */
void camera_point_filter_look(camera_point_filter_Memory * memory, double x, double y) {
  camera_point_filter_Settings * settings;
  camera_point_filter_State * s;
  T3d predicted;
  settings = &memory->settings;
  s = &memory->state;
  if (s->mode == camera_point_filter_WAITING) {
    camera_kinematics_begin_start(&s->start);
    s->mode = camera_point_filter_STARTING;
  }
  if (s->mode == camera_point_filter_STARTING) {
    camera_kinematics_take_image(&s->start, x, y, settings->noise);
    if (camera_kinematics_started(&s->start, (Vector){s->state, 6}, &s->spread, settings->noise, settings->share)) {
      s->mode = camera_point_filter_RUNNING;
    }
    return;
  }
  predicted = (T3d){s->state[0], s->state[1], s->state[2]};
  if (predicted.f2 > camera_point_filter_NEAREST_M) {
    camera_point_filter_correct(s, settings->noise, x, 0, predicted);
    camera_point_filter_correct(s, settings->noise, y, 1, predicted);
  }
}

/* One ``CameraSample``: t, (p, v), covariance, restarts and running into ``out``, which is NaN before. */
void camera_point_filter_step(camera_point_filter_Memory * memory, Vector row, camera_point_filter_Answer * out) {
  double t, x, y, wx, wy, wz, ax, ay, az;
  camera_point_filter_Settings * settings;
  camera_point_filter_State * s;
  t = row.p[0];
  x = row.p[1];
  y = row.p[2];
  wx = row.p[3];
  wy = row.p[4];
  wz = row.p[5];
  ax = row.p[6];
  ay = row.p[7];
  az = row.p[8];
  settings = &memory->settings;
  s = &memory->state;
  if (!camera_samples_usable((camera_samples_CameraSample){t, x, y, wx, wy, wz, ax, ay, az}, s->started, s->t, settings->gap_s)) {
    return;
  }
  if (s->mode != camera_point_filter_WAITING) {
    camera_point_filter_predict(memory, t - s->t, (T3d){wx, wy, wz}, (T3d){ax, ay, az});
  }
  if (x == x) {
    camera_point_filter_look(memory, x / settings->focal_px, y / settings->focal_px);
  }
  if (s->mode == camera_point_filter_RUNNING && !(s->state[2] > camera_point_filter_NEAREST_M)) {
    s->mode = camera_point_filter_WAITING;
    s->restarts += 1.0;
  }
  s->started = 1.0;
  s->t = t;
  s->wx = wx;
  s->wy = wy;
  s->wz = wz;
  s->ax = ax;
  s->ay = ay;
  s->az = az;
  out->t = t;
  out->restarts = s->restarts;
  out->running = 0.0;
  if (s->mode == camera_point_filter_RUNNING) {
    for (int64_t i = 0; i < 6; i++) {
      out->state[i] = s->state[i];
      for (int64_t j = 0; j < 6; j++) {
        out->spread.m[i][j] = s->spread.m[i][j];
      }
    }
    out->running = 1.0;
  }
}

/* A sample, then up there (NaN: not given): the sample without gravity into ``out``, or nothing. */
void camera_samples_step(camera_samples_Memory * memory, Vector row, Vector out) {
  camera_samples_Settings * settings;
  camera_samples_State * s;
  double t, wx, wy, wz, ax, ay, az, ux, uy, uz, h, size;
  T3d turn;
  settings = &memory->settings;
  s = &memory->state;
  t = row.p[0];
  wx = row.p[3];
  wy = row.p[4];
  wz = row.p[5];
  ax = row.p[6];
  ay = row.p[7];
  az = row.p[8];
  if (!camera_samples_usable((camera_samples_CameraSample){t, row.p[1], row.p[2], wx, wy, wz, ax, ay, az}, s->started, s->t, settings->gap_s)) {
    return;
  }
  ux = row.p[9];
  uy = row.p[10];
  uz = row.p[11];
  if (ux != ux) {
    if (s->started == 1.0) {
      h = 0.5 * (t - s->t);
      turn = (T3d){h * (s->wx + wx), h * (s->wy + wy), h * (s->wz + wz)};
      T3d values_1 = camera_kinematics_back(turn, (T3d){s->up[0], s->up[1], s->up[2]});
      ux = values_1.f0;
      uy = values_1.f1;
      uz = values_1.f2;
    } else {
      ux = settings->up[0];
      uy = settings->up[1];
      uz = settings->up[2];
    }
  }
  if (ux == 0.0 && uy == 0.0 && uz == 0.0) {
    ux = ax;
    uy = ay;
    uz = az;
    if (!(fabs(sqrt(ax * ax + ay * ay + az * az) - settings->g) <= camera_samples_AT_REST * settings->g)) {
      return;
    }
  }
  size = sqrt(ux * ux + uy * uy + uz * uz);
  s->up[0] = ux / size;
  s->up[1] = uy / size;
  s->up[2] = uz / size;
  s->started = 1.0;
  s->t = t;
  s->wx = wx;
  s->wy = wy;
  s->wz = wz;
  for (int64_t i = 0; i < 6; i++) {
    out.p[i] = row.p[i];
  }
  for (int64_t i = 0; i < 3; i++) {
    out.p[6 + i] = row.p[6 + i] - settings->g * s->up[i];
  }
}

/* The known part of the image's motion: (x, y) eta + B w; the rest of (x, y)' is -d. */
T2d camera_velocity_flow(double x, double y, double eta, double wx, double wy, double wz) {
  double flow_x, flow_y;
  flow_x = x * eta + x * y * wx - (1.0 + x * x) * wy + y * wz;
  flow_y = y * eta + (1.0 + y * y) * wx - x * y * wy - x * wz;
  return (T2d){flow_x, flow_y};
}

/* Y' = known - d over ``h`` s, the known part fed forward by Heun's rule; d' is white. */
void camera_velocity_predict(camera_velocity_State * s, double density, double eta, double wx, double wy, double wz, double h) {
  double x, y, kx, ky, dx, dy, lx, ly, p01, p11;
  x = s->x;
  y = s->y;
  kx = s->kx;
  ky = s->ky;
  dx = s->dx;
  dy = s->dy;
  T2d values_1 = camera_velocity_flow(x + h * (kx - dx), y + h * (ky - dy), eta, wx, wy, wz);
  lx = values_1.f0;
  ly = values_1.f1;
  s->x = x + h * (0.5 * (kx + lx) - dx);
  s->y = y + h * (0.5 * (ky + ly) - dy);
  p01 = s->p01;
  p11 = s->p11;
  s->p00 += -2.0 * h * p01 + h * h * p11 + density * whole_power(h, 3) / 3.0;
  s->p01 += -h * p11 - density * h * h / 2.0;
  s->p11 += density * h;
}

/* A ``CameraSample``, then the observer's eta: t, d_x, d_y and their spread, 1/s, into ``out``. */
void camera_velocity_step(camera_velocity_Memory * memory, Vector row, Vector out) {
  camera_velocity_Settings * settings;
  camera_velocity_State * s;
  double t, wx, wy, wz, eta, x, y, total, near, far, ex, ey;
  bool image, known;
  settings = &memory->settings;
  s = &memory->state;
  t = row.p[0];
  wx = row.p[3];
  wy = row.p[4];
  wz = row.p[5];
  eta = row.p[9];
  if (!camera_samples_usable((camera_samples_CameraSample){t, row.p[1], row.p[2], wx, wy, wz, row.p[6], row.p[7], row.p[8]}, s->started, s->t, camera_velocity_EVER_S)) {
    return;
  }
  x = row.p[1] / settings->focal_px;
  y = row.p[2] / settings->focal_px;
  out.p[0] = t;
  image = x == x;
  known = eta == eta;
  if (known && s->imaged == 1.0) {
    camera_velocity_predict(s, settings->density, eta, wx, wy, wz, t - s->t);
    if (image) {
      total = s->p00 + settings->noise;
      near = s->p00 / total;
      far = s->p01 / total;
      ex = x - s->x;
      ey = y - s->y;
      s->x += near * ex;
      s->y += near * ey;
      s->dx += far * ex;
      s->dy += far * ey;
      s->p11 -= far * s->p01;
      s->p01 *= 1.0 - near;
      s->p00 *= 1.0 - near;
    }
  } else if (known && image) {
    s->imaged = 1.0;
    s->x = x;
    s->y = y;
    s->p00 = settings->noise;
    s->p11 = square(camera_velocity_SPREAD_START);
  }
  if (known) {
    s->started = 1.0;
    s->t = t;
    T2d values_1 = camera_velocity_flow(s->x, s->y, eta, wx, wy, wz);
    s->kx = values_1.f0;
    s->ky = values_1.f1;
  }
  if (s->imaged == 1.0) {
    out.p[1] = s->dx;
    out.p[2] = s->dy;
    out.p[3] = sqrt(s->p11);
  }
}

void loop__camera_samples_step(Vector memory, int64_t first, FlagVector begin, Table rows, Table out) {
  for (int64_t i = 0; i < rows.n; i++) {
    if (begin.p[i]) {
      fill((Vector){memory.p + first, memory.n - first}, 0.0);
    }
    camera_samples_step((camera_samples_Memory *)memory.p, (Vector){rows.p + i * rows.m, rows.m}, (Vector){out.p + i * out.m, out.m});
  }
}

void loop__camera_depth_step(Vector memory, int64_t first, FlagVector begin, Table rows, Table out) {
  for (int64_t i = 0; i < rows.n; i++) {
    if (begin.p[i]) {
      fill((Vector){memory.p + first, memory.n - first}, 0.0);
    }
    camera_depth_step((camera_depth_Memory *)memory.p, (Vector){rows.p + i * rows.m, rows.m}, (Vector){out.p + i * out.m, out.m});
  }
}

void loop__camera_point_filter_step(Vector memory, int64_t first, FlagVector begin, Table rows, Table out) {
  for (int64_t i = 0; i < rows.n; i++) {
    if (begin.p[i]) {
      fill((Vector){memory.p + first, memory.n - first}, 0.0);
    }
    camera_point_filter_step((camera_point_filter_Memory *)memory.p, (Vector){rows.p + i * rows.m, rows.m}, (camera_point_filter_Answer *)(Vector){out.p + i * out.m, out.m}.p);
  }
}

void loop__camera_velocity_step(Vector memory, int64_t first, FlagVector begin, Table rows, Table out) {
  for (int64_t i = 0; i < rows.n; i++) {
    if (begin.p[i]) {
      fill((Vector){memory.p + first, memory.n - first}, 0.0);
    }
    camera_velocity_step((camera_velocity_Memory *)memory.p, (Vector){rows.p + i * rows.m, rows.m}, (Vector){out.p + i * out.m, out.m});
  }
}
