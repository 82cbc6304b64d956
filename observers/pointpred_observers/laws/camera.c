/* Written by `make laws` from the laws: change those and run it again. */
#include "laws.h"

static const double records_LATEST_S = 100000000000.0;
static const double camera_camera_stage_LARGEST_A = 10000.0;
static const double camera_camera_stage_LARGEST_PX = 1000000.0;
static const double camera_camera_stage_LARGEST_W = 1000.0;
static const double camera_camera_stage_SUBSTEP_S = 0.05;
static const int64_t camera_depth_AZ = 22;
static const int64_t camera_depth_BOX = 5;
static const int64_t camera_depth_CHI = 23;
static const int64_t camera_depth_FOCAL = 0;
static const int64_t camera_depth_GAP_S = 4;
static const int64_t camera_depth_HALF_SIGMA = 1;
static const int64_t camera_depth_IMAGED = 25;
static const double camera_depth_LARGEST_RATE = 1000.0;
static const int64_t camera_depth_LOST = 26;
static const int64_t camera_depth_R = 24;
static const int64_t camera_depth_STARTED = 15;
static const int64_t camera_depth_START_CHI = 2;
static const int64_t camera_depth_START_ETA = 3;
static const int64_t camera_depth_T = 16;
static const int64_t camera_depth_WX = 19;
static const int64_t camera_depth_WY = 20;
static const int64_t camera_depth_WZ = 21;
static const int64_t camera_depth_X = 17;
static const int64_t camera_depth_Y = 18;
static const double camera_kinematics_SMALL = 0.0001;
static const int64_t camera_point_filter_ACCEL = 3;
static const int64_t camera_point_filter_AX = 11;
static const int64_t camera_point_filter_AY = 12;
static const int64_t camera_point_filter_AZ = 13;
static const int64_t camera_point_filter_COLUMN = 58;
static const int64_t camera_point_filter_FOCAL = 0;
static const int64_t camera_point_filter_GAP_S = 5;
static const int64_t camera_point_filter_GYRO = 2;
static const int64_t camera_point_filter_MODE = 14;
static const double camera_point_filter_NEAREST_M = 0.0001;
static const int64_t camera_point_filter_NOISE = 1;
static const int64_t camera_point_filter_OUT_RESTARTS = 43;
static const int64_t camera_point_filter_OUT_RUNNING = 44;
static const int64_t camera_point_filter_OUT_STATE = 1;
static const int64_t camera_point_filter_RESTARTS = 15;
static const double camera_point_filter_RUNNING = 2.0;
static const int64_t camera_point_filter_SHARE = 4;
static const int64_t camera_point_filter_SPREAD = 22;
static const int64_t camera_point_filter_START = 64;
static const int64_t camera_point_filter_STARTED = 6;
static const double camera_point_filter_STARTING = 1.0;
static const int64_t camera_point_filter_STATE = 16;
static const int64_t camera_point_filter_T = 7;
static const double camera_point_filter_WAITING = 0.0;
static const int64_t camera_point_filter_WX = 8;
static const int64_t camera_point_filter_WY = 9;
static const int64_t camera_point_filter_WZ = 10;
static const int64_t camera_starting_CARRY = 0;
static const int64_t camera_starting_FACTOR = 120;
static const int64_t camera_starting_FIRST = 156;
static const int64_t camera_starting_FORCE = 36;
static const int64_t camera_starting_NOISE = 84;
static const int64_t camera_starting_NORMAL = 42;
static const int64_t camera_starting_NOW = 162;
static const int64_t camera_starting_RIGHT = 78;
static const int64_t camera_starting_ROW = 168;
static const int64_t camera_starting_SPREAD = 174;
static const int64_t camera_starting_STATES = 210;
static const int64_t camera_unknown_input_filter_DENSITY = 1;
static const int64_t camera_unknown_input_filter_DX = 7;
static const int64_t camera_unknown_input_filter_DY = 8;
static const int64_t camera_unknown_input_filter_IMAGED = 4;
static const int64_t camera_unknown_input_filter_KX = 9;
static const int64_t camera_unknown_input_filter_KY = 10;
static const int64_t camera_unknown_input_filter_NOISE = 0;
static const int64_t camera_unknown_input_filter_P00 = 11;
static const int64_t camera_unknown_input_filter_P01 = 12;
static const int64_t camera_unknown_input_filter_P11 = 13;
static const double camera_unknown_input_filter_SPREAD_START = 1.0;
static const int64_t camera_unknown_input_filter_STARTED = 2;
static const int64_t camera_unknown_input_filter_T = 3;
static const int64_t camera_unknown_input_filter_X = 5;
static const int64_t camera_unknown_input_filter_Y = 6;

/* A row of a table of samples as a tuple. */
T9d camera_camera_stage_sample_at(Table rows, int64_t i) {
  Vector r;
  r = (Vector){rows.p + i * rows.m, rows.m};
  return (T9d){r.p[0], r.p[1], r.p[2], r.p[3], r.p[4], r.p[5], r.p[6], r.p[7], r.p[8]};
}

/* Whether a sample can be used: within the bounds, after the last one and within the longest gap. */
bool camera_camera_stage_usable(camera_samples_SampleRow sample, double started, double last_t, double gap_s) {
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
  if (!(fabs(t) <= records_LATEST_S && fabs(wx) <= camera_camera_stage_LARGEST_W && fabs(wy) <= camera_camera_stage_LARGEST_W && fabs(wz) <= camera_camera_stage_LARGEST_W)) {
    return false;
  }
  if (!(fabs(ax) <= camera_camera_stage_LARGEST_A && fabs(ay) <= camera_camera_stage_LARGEST_A && fabs(az) <= camera_camera_stage_LARGEST_A)) {
    return false;
  }
  if (!((x != x && y != y) || (fabs(x) <= camera_camera_stage_LARGEST_PX && fabs(y) <= camera_camera_stage_LARGEST_PX))) {
    return false;
  }
  return started != 1.0 || (last_t < t && t <= last_t + gap_s);
}

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
void camera_depth_carry(Vector memory, camera_depth_Measured m, double dt) {
  double x0, y0, az0, wx0, wy0, wz0, dwx, dwy, h, chi, r, sum_chi, sum_r, k_chi, k_r, inner, s, share;
  int64_t steps;
  camera_depth_Measured between;
  x0 = memory.p[camera_depth_X];
  y0 = memory.p[camera_depth_Y];
  az0 = memory.p[camera_depth_AZ];
  wx0 = memory.p[camera_depth_WX];
  wy0 = memory.p[camera_depth_WY];
  wz0 = memory.p[camera_depth_WZ];
  dwx = (m.wx - wx0) / dt;
  dwy = (m.wy - wy0) / dt;
  steps = (int64_t)ceil(dt / camera_camera_stage_SUBSTEP_S);
  h = dt / steps;
  for (int64_t i = 0; i < steps; i++) {
    chi = memory.p[camera_depth_CHI];
    r = memory.p[camera_depth_R];
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
    memory.p[camera_depth_CHI] = chi + h / 6.0 * sum_chi;
    memory.p[camera_depth_R] = r + h / 6.0 * sum_r;
    if (!(fabs(memory.p[camera_depth_R]) <= camera_depth_LARGEST_RATE && fabs(memory.p[camera_depth_CHI]) <= camera_camera_stage_LARGEST_PX)) {
      memory.p[camera_depth_LOST] = 1.0;
      memory.p[camera_depth_CHI] = chi;
      memory.p[camera_depth_R] = r;
      return;
    }
  }
}

/* Whether the scheduling variables lie in the certificate's box; false without a certificate. */
bool camera_depth_inside(Vector memory, double zero, double eta) {
  T5d values;
  values = (T5d){zero, eta, memory.p[camera_depth_AZ], memory.p[camera_depth_WX], memory.p[camera_depth_WY]};
  for (int64_t i = 0; i < 5; i++) {
    if (!(memory.p[camera_depth_BOX + 2 * i] <= ((const double *)&values)[i] && ((const double *)&values)[i] <= memory.p[camera_depth_BOX + 2 * i + 1])) {
      return false;
    }
  }
  return memory.p[camera_depth_BOX] < 0.0;
}

/* One ``SampleRow``: t, chi, eta, the zero of chi, detectable, certified, whether there was an image. */
T7d camera_depth_step(Vector memory, T9d sample) {
  camera_samples_SampleRow row;
  double t, x, y, wx, wy, wz, az, flat_x, flat_y, eta, zero;
  bool image, decays, proved;
  row = camera_samples_SampleRow_of_T9d(sample);
  if (!camera_camera_stage_usable(row, memory.p[camera_depth_STARTED], memory.p[camera_depth_T], memory.p[camera_depth_GAP_S])) {
    return (T7d){NAN, NAN, NAN, NAN, 0.0, 0.0, 0.0};
  }
  t = row.t;
  x = row.x;
  y = row.y;
  wx = row.wx;
  wy = row.wy;
  wz = row.wz;
  az = row.az;
  image = x == x;
  flat_x = image ? x / memory.p[camera_depth_FOCAL] : memory.p[camera_depth_X];
  flat_y = image ? y / memory.p[camera_depth_FOCAL] : memory.p[camera_depth_Y];
  if (memory.p[camera_depth_IMAGED] == 0.0 && image) {
    memory.p[camera_depth_CHI] = memory.p[camera_depth_START_CHI];
    memory.p[camera_depth_R] = memory.p[camera_depth_START_ETA] + wy * flat_x - wx * flat_y;
    memory.p[camera_depth_IMAGED] = 1.0;
  } else if (memory.p[camera_depth_IMAGED] == 1.0 && memory.p[camera_depth_LOST] == 0.0) {
    camera_depth_carry(memory, (camera_depth_Measured){flat_x, flat_y, wx, wy, wz, az}, t - memory.p[camera_depth_T]);
  }
  memory.p[camera_depth_STARTED] = 1.0;
  memory.p[camera_depth_T] = t;
  memory.p[camera_depth_X] = flat_x;
  memory.p[camera_depth_Y] = flat_y;
  memory.p[camera_depth_WX] = wx;
  memory.p[camera_depth_WY] = wy;
  memory.p[camera_depth_WZ] = wz;
  memory.p[camera_depth_AZ] = az;
  if (memory.p[camera_depth_IMAGED] == 0.0 || memory.p[camera_depth_LOST] == 1.0) {
    return (T7d){t, NAN, NAN, NAN, 0.0, 0.0, image ? 1.0 : 0.0};
  }
  eta = memory.p[camera_depth_R] - wy * flat_x + wx * flat_y;
  zero = flat_y * wx - flat_x * wy + eta;
  decays = zero < -memory.p[camera_depth_HALF_SIGMA] && eta < -memory.p[camera_depth_HALF_SIGMA];
  proved = camera_depth_inside(memory, zero, eta);
  return (T7d){t, memory.p[camera_depth_CHI], eta, zero, decays ? 1.0 : 0.0, proved ? 1.0 : 0.0, image ? 1.0 : 0.0};
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
void camera_kinematics_carry(Vector memory, int64_t at, int64_t stride, double h, T3d turn) {
  double px, py, pz, vx, vy, vz;
  px = memory.p[at] - h * memory.p[at + 3 * stride];
  py = memory.p[at + stride] - h * memory.p[at + 4 * stride];
  pz = memory.p[at + 2 * stride] - h * memory.p[at + 5 * stride];
  T3d values_1 = camera_kinematics_back(turn, (T3d){px, py, pz});
  px = values_1.f0;
  py = values_1.f1;
  pz = values_1.f2;
  vx = memory.p[at + 3 * stride];
  vy = memory.p[at + 4 * stride];
  vz = memory.p[at + 5 * stride];
  T3d values_2 = camera_kinematics_back(turn, (T3d){vx, vy, vz});
  vx = values_2.f0;
  vy = values_2.f1;
  vz = values_2.f2;
  memory.p[at] = px;
  memory.p[at + stride] = py;
  memory.p[at + 2 * stride] = pz;
  memory.p[at + 3 * stride] = vx;
  memory.p[at + 4 * stride] = vy;
  memory.p[at + 5 * stride] = vz;
}

/* The effect on (p, v) in ``h`` s of an acceleration, linear from ``before`` to ``after`` the rotation. */
void camera_kinematics_push(Vector memory, int64_t at, double h, T3d turn, T3d before, T3d after) {
  double bx, by, bz, ax, ay, az, square_;
  T3d values_1 = camera_kinematics_back(turn, before);
  bx = values_1.f0;
  by = values_1.f1;
  bz = values_1.f2;
  ax = after.f0;
  ay = after.f1;
  az = after.f2;
  square_ = h * h;
  memory.p[at] -= square_ * (bx / 3.0 + ax / 6.0);
  memory.p[at + 1] -= square_ * (by / 3.0 + ay / 6.0);
  memory.p[at + 2] -= square_ * (bz / 3.0 + az / 6.0);
  memory.p[at + 3] += 0.5 * h * (bx + ax);
  memory.p[at + 4] += 0.5 * h * (by + ay);
  memory.p[at + 5] += 0.5 * h * (bz + az);
}

/* A 6 x 6 covariance, row by row at ``at``, after ``h`` s: Phi P Phi'. */
void camera_kinematics_turn_covariance(Vector memory, int64_t at, double h, T3d turn) {
  for (int64_t i = 0; i < 6; i++) {
    camera_kinematics_carry(memory, at + i, 6, h, turn);
  }
  for (int64_t i = 0; i < 6; i++) {
    camera_kinematics_carry(memory, at + 6 * i, 1, h, turn);
  }
}

/* Add the effect of sensor noise with variances (rad^2, m^2/s^2) on (p, v) at ``state`` to a covariance. */
void camera_kinematics_add_noise(Vector memory, int64_t at, int64_t state, double gyro, double accel) {
  int64_t i, j;
  double dot, value;
  for (int64_t block = 0; block < 2; block++) {
    for (int64_t other = 0; other < 2; other++) {
      i = state + 3 * block;
      j = state + 3 * other;
      dot = memory.p[i] * memory.p[j] + memory.p[i + 1] * memory.p[j + 1] + memory.p[i + 2] * memory.p[j + 2];
      for (int64_t row = 0; row < 3; row++) {
        for (int64_t column = 0; column < 3; column++) {
          value = (row == column ? dot : 0.0) - memory.p[j + row] * memory.p[i + column];
          memory.p[at + 6 * (3 * block + row) + 3 * other + column] += gyro * value;
        }
      }
    }
  }
  for (int64_t row = 3; row < 6; row++) {
    memory.p[at + 7 * row] += accel;
  }
}

/* One coordinate of the image, linearised at the prediction (x, y, z). */
void camera_point_filter_correct(Vector memory, double measured, int64_t axis, double x, double y, double z) {
  double side, near, far, total, expected, share;
  side = axis ? y : x;
  near = 1.0 / z;
  far = -side / (z * z);
  for (int64_t i = 0; i < 6; i++) {
    memory.p[camera_point_filter_COLUMN + i] = memory.p[camera_point_filter_SPREAD + 6 * i + axis] * near + memory.p[camera_point_filter_SPREAD + 6 * i + 2] * far;
  }
  total = memory.p[camera_point_filter_COLUMN + axis] * near + memory.p[camera_point_filter_COLUMN + 2] * far + memory.p[camera_point_filter_NOISE];
  expected = side * near + (memory.p[camera_point_filter_STATE + axis] - side) * near + (memory.p[camera_point_filter_STATE + 2] - z) * far;
  share = (measured - expected) / total;
  for (int64_t i = 0; i < 6; i++) {
    memory.p[camera_point_filter_STATE + i] += memory.p[camera_point_filter_COLUMN + i] * share;
  }
  for (int64_t i = 0; i < 6; i++) {
    for (int64_t j = 0; j < 6; j++) {
      memory.p[camera_point_filter_SPREAD + 6 * i + j] -= memory.p[camera_point_filter_COLUMN + i] * memory.p[camera_point_filter_COLUMN + j] / total;
    }
  }
}

/* Propagate over ``dt`` s: the state and its covariance, or the sums of the initialisation. */
void camera_point_filter_predict(Vector memory, double dt, T3d w, T3d a) {
  T3d turn;
  bool running;
  double gyro, accel;
  int64_t state, spread;
  turn = (T3d){0.5 * dt * (memory.p[camera_point_filter_WX] + w.f0), 0.5 * dt * (memory.p[camera_point_filter_WY] + w.f1), 0.5 * dt * (memory.p[camera_point_filter_WZ] + w.f2)};
  running = memory.p[camera_point_filter_MODE] == camera_point_filter_RUNNING;
  gyro = running ? memory.p[camera_point_filter_GYRO] * dt : 0.0;
  accel = memory.p[camera_point_filter_ACCEL] * dt;
  state = running ? camera_point_filter_STATE : camera_point_filter_START + camera_starting_FORCE;
  spread = running ? camera_point_filter_SPREAD : camera_point_filter_START + camera_starting_NOISE;
  if (!running) {
    for (int64_t i = 0; i < 6; i++) {
      camera_kinematics_carry(memory, camera_point_filter_START + camera_starting_CARRY + i, 6, dt, turn);
    }
  }
  camera_kinematics_carry(memory, state, 1, dt, turn);
  camera_kinematics_push(memory, state, dt, turn, (T3d){memory.p[camera_point_filter_AX], memory.p[camera_point_filter_AY], memory.p[camera_point_filter_AZ]}, a);
  camera_kinematics_turn_covariance(memory, spread, dt, turn);
  camera_kinematics_add_noise(memory, spread, state, gyro, accel);
}

/* Forget all images: Phi is the identity. */
void camera_starting_begin(Vector memory, int64_t at) {
  fill((Vector){memory.p + at, at + camera_starting_STATES - at}, 0.0);
  for (int64_t i = 0; i < 6; i++) {
    memory.p[at + camera_starting_CARRY + 7 * i] = 1.0;
  }
}

/* Add an image: N += Phi' Q Phi, b -= Phi' Q g, Q = H'H - 2 r e3 e3', H = (1 0 -x; 0 1 -y). */
void camera_starting_take(Vector memory, int64_t at, double x, double y, double variance) {
  double corner, g0, g1, g2, a0, a1, a2, q0, q1, q2;
  int64_t carry, force;
  corner = x * x + y * y - 2.0 * variance;
  carry = at + camera_starting_CARRY;
  force = at + camera_starting_FORCE;
  g0 = memory.p[force];
  g1 = memory.p[force + 1];
  g2 = memory.p[force + 2];
  for (int64_t i = 0; i < 6; i++) {
    a0 = memory.p[carry + i];
    a1 = memory.p[carry + 6 + i];
    a2 = memory.p[carry + 12 + i];
    q0 = a0 - x * a2;
    q1 = a1 - y * a2;
    q2 = -x * a0 - y * a1 + corner * a2;
    memory.p[at + camera_starting_RIGHT + i] -= q0 * g0 + q1 * g1 + q2 * g2;
    for (int64_t j = 0; j < 6; j++) {
      memory.p[at + camera_starting_NORMAL + 6 * i + j] += q0 * memory.p[carry + j] + q1 * memory.p[carry + 6 + j] + q2 * memory.p[carry + 12 + j];
    }
  }
}

/* Cholesky's lower factor in place; false if the matrix is not safely positive definite. */
bool camera_starting_factor(Vector memory, int64_t m) {
  double own, total;
  for (int64_t i = 0; i < 6; i++) {
    own = memory.p[m + 7 * i];
    for (int64_t j = 0, end_1 = i + 1; j < end_1; j++) {
      total = memory.p[m + 6 * i + j];
      for (int64_t k = 0; k < j; k++) {
        total -= memory.p[m + 6 * i + k] * memory.p[m + 6 * j + k];
      }
      if (i == j) {
        if (!(total > 1e-12 * own)) {
          return false;
        }
        memory.p[m + 7 * i] = sqrt(total);
      } else {
        memory.p[m + 6 * i + j] = total / memory.p[m + 7 * j];
      }
    }
  }
  return true;
}

/* Solve with Cholesky's factor at ``m``, the vector at ``v`` in place. */
void camera_starting_solve(Vector memory, int64_t m, int64_t v) {
  double total;
  for (int64_t i = 0; i < 6; i++) {
    total = memory.p[v + i];
    for (int64_t k = 0; k < i; k++) {
      total -= memory.p[m + 6 * i + k] * memory.p[v + k];
    }
    memory.p[v + i] = total / memory.p[m + 7 * i];
  }
  for (int64_t i = 5; i > (-1); i--) {
    total = memory.p[v + i];
    for (int64_t k = i + 1; k < 6; k++) {
      total -= memory.p[m + 6 * k + i] * memory.p[v + k];
    }
    memory.p[v + i] = total / memory.p[m + 7 * i];
  }
}

/* Write the current (p, v) and covariance if the relative error of the depth is at most ``share``. */
bool camera_starting_start(Vector memory, int64_t at, int64_t state, int64_t p, double variance, double share) {
  int64_t lower, first, now, row, spread;
  double z0, z, square_, total;
  lower = at + camera_starting_FACTOR;
  first = at + camera_starting_FIRST;
  now = at + camera_starting_NOW;
  row = at + camera_starting_ROW;
  spread = at + camera_starting_SPREAD;
  for (int64_t i = 0; i < 36; i++) {
    memory.p[lower + i] = memory.p[at + camera_starting_NORMAL + i];
  }
  if (!camera_starting_factor(memory, lower)) {
    return false;
  }
  for (int64_t i = 0; i < 6; i++) {
    double value_1 = memory.p[at + camera_starting_RIGHT + i];
    double value_2 = memory.p[at + camera_starting_FORCE + i];
    memory.p[first + i] = value_1;
    memory.p[now + i] = value_2;
  }
  camera_starting_solve(memory, lower, first);
  for (int64_t i = 0; i < 6; i++) {
    for (int64_t j = 0; j < 6; j++) {
      memory.p[now + i] += memory.p[at + camera_starting_CARRY + 6 * i + j] * memory.p[first + j];
    }
  }
  z0 = memory.p[first + 2];
  z = memory.p[now + 2];
  square_ = (z0 * z0 + z0 * z + z * z) / 3.0;
  if (!(z0 > 0.0 && z > 0.0)) {
    return false;
  }
  for (int64_t i = 0; i < 6; i++) {
    for (int64_t j = 0; j < 6; j++) {
      memory.p[row + j] = memory.p[at + camera_starting_CARRY + 6 * i + j];
    }
    camera_starting_solve(memory, lower, row);
    for (int64_t j = 0; j < 6; j++) {
      total = 0.0;
      for (int64_t k = 0; k < 6; k++) {
        total += memory.p[row + k] * memory.p[at + camera_starting_CARRY + 6 * j + k];
      }
      memory.p[spread + 6 * i + j] = total * variance * square_ + memory.p[at + camera_starting_NOISE + 6 * i + j];
    }
  }
  if (!(memory.p[spread + 14] < square(share * z))) {
    return false;
  }
  for (int64_t i = 0; i < 6; i++) {
    memory.p[state + i] = memory.p[now + i];
    for (int64_t j = 0; j < 6; j++) {
      memory.p[p + 6 * i + j] = 0.5 * (memory.p[spread + 6 * i + j] + memory.p[spread + 6 * j + i]);
    }
  }
  return true;
}

/* Process an image: correct the state, or initialise it. */
void camera_point_filter_look(Vector memory, double x, double y) {
  double px, py, pz;
  if (memory.p[camera_point_filter_MODE] == camera_point_filter_WAITING) {
    camera_starting_begin(memory, camera_point_filter_START);
    memory.p[camera_point_filter_MODE] = camera_point_filter_STARTING;
  }
  if (memory.p[camera_point_filter_MODE] == camera_point_filter_STARTING) {
    camera_starting_take(memory, camera_point_filter_START, x, y, memory.p[camera_point_filter_NOISE]);
    if (camera_starting_start(memory, camera_point_filter_START, camera_point_filter_STATE, camera_point_filter_SPREAD, memory.p[camera_point_filter_NOISE], memory.p[camera_point_filter_SHARE])) {
      memory.p[camera_point_filter_MODE] = camera_point_filter_RUNNING;
    }
    return;
  }
  px = memory.p[camera_point_filter_STATE];
  py = memory.p[camera_point_filter_STATE + 1];
  pz = memory.p[camera_point_filter_STATE + 2];
  if (pz > camera_point_filter_NEAREST_M) {
    camera_point_filter_correct(memory, x, 0, px, py, pz);
    camera_point_filter_correct(memory, y, 1, px, py, pz);
  }
}

/* One ``SampleRow``: t, (p, v), covariance, restarts and running into ``out``, which is NaN before. */
void camera_point_filter_step(Vector memory, Vector row, Vector out) {
  double t, x, y, wx, wy, wz, ax, ay, az;
  camera_samples_SampleRow sample;
  t = row.p[0];
  x = row.p[1];
  y = row.p[2];
  wx = row.p[3];
  wy = row.p[4];
  wz = row.p[5];
  ax = row.p[6];
  ay = row.p[7];
  az = row.p[8];
  sample = (camera_samples_SampleRow){t, x, y, wx, wy, wz, ax, ay, az};
  if (!camera_camera_stage_usable(sample, memory.p[camera_point_filter_STARTED], memory.p[camera_point_filter_T], memory.p[camera_point_filter_GAP_S])) {
    return;
  }
  if (memory.p[camera_point_filter_MODE] != camera_point_filter_WAITING) {
    camera_point_filter_predict(memory, t - memory.p[camera_point_filter_T], (T3d){wx, wy, wz}, (T3d){ax, ay, az});
  }
  if (x == x) {
    camera_point_filter_look(memory, x / memory.p[camera_point_filter_FOCAL], y / memory.p[camera_point_filter_FOCAL]);
  }
  if (memory.p[camera_point_filter_MODE] == camera_point_filter_RUNNING && !(memory.p[camera_point_filter_STATE + 2] > camera_point_filter_NEAREST_M)) {
    memory.p[camera_point_filter_MODE] = camera_point_filter_WAITING;
    memory.p[camera_point_filter_RESTARTS] += 1.0;
  }
  memory.p[camera_point_filter_STARTED] = 1.0;
  memory.p[camera_point_filter_T] = t;
  memory.p[camera_point_filter_WX] = wx;
  memory.p[camera_point_filter_WY] = wy;
  memory.p[camera_point_filter_WZ] = wz;
  memory.p[camera_point_filter_AX] = ax;
  memory.p[camera_point_filter_AY] = ay;
  memory.p[camera_point_filter_AZ] = az;
  out.p[0] = t;
  out.p[camera_point_filter_OUT_RESTARTS] = memory.p[camera_point_filter_RESTARTS];
  out.p[camera_point_filter_OUT_RUNNING] = 0.0;
  if (memory.p[camera_point_filter_MODE] == camera_point_filter_RUNNING) {
    for (int64_t i = 0; i < 42; i++) {
      out.p[camera_point_filter_OUT_STATE + i] = memory.p[camera_point_filter_STATE + i];
    }
    out.p[camera_point_filter_OUT_RUNNING] = 1.0;
  }
}

/* The known part of the image's motion: (x, y) eta + B w; the rest of (x, y)' is -d. */
T2d camera_unknown_input_filter_flow(double x, double y, double eta, double wx, double wy, double wz) {
  double flow_x, flow_y;
  flow_x = x * eta + x * y * wx - (1.0 + x * x) * wy + y * wz;
  flow_y = y * eta + (1.0 + y * y) * wx - x * y * wy - x * wz;
  return (T2d){flow_x, flow_y};
}

/* Y' = known - d over ``h`` s, the known part fed forward by Heun's rule; d' is white. */
void camera_unknown_input_filter_predict(Vector memory, double eta, double wx, double wy, double wz, double h) {
  double x, y, kx, ky, dx, dy, lx, ly, q, p01, p11;
  x = memory.p[camera_unknown_input_filter_X];
  y = memory.p[camera_unknown_input_filter_Y];
  kx = memory.p[camera_unknown_input_filter_KX];
  ky = memory.p[camera_unknown_input_filter_KY];
  dx = memory.p[camera_unknown_input_filter_DX];
  dy = memory.p[camera_unknown_input_filter_DY];
  T2d values_1 = camera_unknown_input_filter_flow(x + h * (kx - dx), y + h * (ky - dy), eta, wx, wy, wz);
  lx = values_1.f0;
  ly = values_1.f1;
  memory.p[camera_unknown_input_filter_X] = x + h * (0.5 * (kx + lx) - dx);
  memory.p[camera_unknown_input_filter_Y] = y + h * (0.5 * (ky + ly) - dy);
  q = memory.p[camera_unknown_input_filter_DENSITY];
  p01 = memory.p[camera_unknown_input_filter_P01];
  p11 = memory.p[camera_unknown_input_filter_P11];
  memory.p[camera_unknown_input_filter_P00] += -2.0 * h * p01 + h * h * p11 + q * whole_power(h, 3) / 3.0;
  memory.p[camera_unknown_input_filter_P01] += -h * p11 - q * h * h / 2.0;
  memory.p[camera_unknown_input_filter_P11] += q * h;
}

/* One ``FlowRow``: t, d_x, d_y and their standard deviation, 1/s. */
T4d camera_unknown_input_filter_step(Vector memory, T7d row) {
  double t, x, y, eta, wx, wy, wz, total, near, far, ex, ey;
  bool image;
  camera_unknown_input_filter_FlowRow values_1 = camera_unknown_input_filter_FlowRow_of_T7d(row);
  t = values_1.t;
  x = values_1.x;
  y = values_1.y;
  eta = values_1.eta;
  wx = values_1.wx;
  wy = values_1.wy;
  wz = values_1.wz;
  if (!(fabs(t) <= records_LATEST_S) || eta != eta || (memory.p[camera_unknown_input_filter_STARTED] == 1.0 && !(t > memory.p[camera_unknown_input_filter_T]))) {
    return (T4d){NAN, NAN, NAN, NAN};
  }
  image = x == x;
  if (memory.p[camera_unknown_input_filter_IMAGED] == 1.0) {
    camera_unknown_input_filter_predict(memory, eta, wx, wy, wz, t - memory.p[camera_unknown_input_filter_T]);
    if (image) {
      total = memory.p[camera_unknown_input_filter_P00] + memory.p[camera_unknown_input_filter_NOISE];
      near = memory.p[camera_unknown_input_filter_P00] / total;
      far = memory.p[camera_unknown_input_filter_P01] / total;
      ex = x - memory.p[camera_unknown_input_filter_X];
      ey = y - memory.p[camera_unknown_input_filter_Y];
      memory.p[camera_unknown_input_filter_X] += near * ex;
      memory.p[camera_unknown_input_filter_Y] += near * ey;
      memory.p[camera_unknown_input_filter_DX] += far * ex;
      memory.p[camera_unknown_input_filter_DY] += far * ey;
      memory.p[camera_unknown_input_filter_P11] -= far * memory.p[camera_unknown_input_filter_P01];
      memory.p[camera_unknown_input_filter_P01] *= 1.0 - near;
      memory.p[camera_unknown_input_filter_P00] *= 1.0 - near;
    }
  } else if (image) {
    memory.p[camera_unknown_input_filter_IMAGED] = 1.0;
    memory.p[camera_unknown_input_filter_X] = x;
    memory.p[camera_unknown_input_filter_Y] = y;
    memory.p[camera_unknown_input_filter_P00] = memory.p[camera_unknown_input_filter_NOISE];
    memory.p[camera_unknown_input_filter_P11] = square(camera_unknown_input_filter_SPREAD_START);
  }
  memory.p[camera_unknown_input_filter_STARTED] = 1.0;
  memory.p[camera_unknown_input_filter_T] = t;
  T2d values_2 = camera_unknown_input_filter_flow(memory.p[camera_unknown_input_filter_X], memory.p[camera_unknown_input_filter_Y], eta, wx, wy, wz);
  memory.p[camera_unknown_input_filter_KX] = values_2.f0;
  memory.p[camera_unknown_input_filter_KY] = values_2.f1;
  if (memory.p[camera_unknown_input_filter_IMAGED] == 0.0) {
    return (T4d){t, NAN, NAN, NAN};
  }
  return (T4d){t, memory.p[camera_unknown_input_filter_DX], memory.p[camera_unknown_input_filter_DY], sqrt(memory.p[camera_unknown_input_filter_P11])};
}

/* A row of a table as a tuple. */
T7d camera_unknown_input_filter_row_at(Table rows, int64_t i) {
  Vector r;
  r = (Vector){rows.p + i * rows.m, rows.m};
  return (T7d){r.p[0], r.p[1], r.p[2], r.p[3], r.p[4], r.p[5], r.p[6]};
}

void loop__stage_learn_nothing__camera_camera_stage_sample_at__camera_depth_step(Vector memory, int64_t first, FlagVector begin, Table rows, Table out) {
  T7d answer;
  for (int64_t i = 0; i < rows.n; i++) {
    if (begin.p[i]) {
      stage_learn_nothing(memory);
      fill((Vector){memory.p + first, memory.n - first}, 0.0);
    }
    answer = camera_depth_step(memory, camera_camera_stage_sample_at(rows, i));
    for (int64_t j = 0; j < 7; j++) {
      out.p[i * out.m + j] = ((const double *)&answer)[j];
    }
  }
}

void loop__camera_point_filter_step(Vector memory, int64_t first, FlagVector begin, Table rows, Table out) {
  for (int64_t i = 0; i < rows.n; i++) {
    if (begin.p[i]) {
      fill((Vector){memory.p + first, memory.n - first}, 0.0);
    }
    camera_point_filter_step(memory, (Vector){rows.p + i * rows.m, rows.m}, (Vector){out.p + i * out.m, out.m});
  }
}
