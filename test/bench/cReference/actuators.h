// Step 1 of the substep: engine, thrusters, wheels, attitude control.
#ifndef ACTUATORS_H
#define ACTUATORS_H
#include "contact.h"

// What a substep carries from its actuators to its end: kg, N, N m, m, s.
typedef struct {
  double mass, ratio, weight, lift, depth, normal_force, dt;
  vec3 thrust, torque;
  mat3 axes;
} load;

static vec3 error_to_target(const ship *s) {
  quat t = s->pilot.target_attitude, q = s->q;
  double sign = t.w * q.w + t.x * q.x + t.y * q.y + t.z * q.z >= 0 ? 2 : -2;
  return vec(sign * (t.x * q.w - t.w * q.x - t.y * q.z + t.z * q.y),
             sign * (t.y * q.w - t.w * q.y - t.z * q.x + t.x * q.z),
             sign * (t.z * q.w - t.w * q.z - t.x * q.y + t.y * q.x));
}

static void steer_to_direction(vec3 *wish, const ship *s, int mode, vec3 normal, const mat3 *axes) {
  vec3 along = s->u;
  if (mode == MODE_NORMAL || mode == MODE_ANTINORMAL) along = cross(s->r, s->u);
  if (mode == MODE_RADIAL || mode == MODE_ANTIRADIAL) along = normal;
  double size = length(along);
  if (!(size > 0)) return;
  int reversed = mode == MODE_RETROGRADE || mode == MODE_ANTINORMAL || mode == MODE_ANTIRADIAL;
  vec3 d = rotate_back(axes, scale(along, reversed ? -1 / size : 1 / size));
  double ex = -d.y, ey = d.x;
  if (d.z < 0) {
    double l = sqrt(ex * ex + ey * ey);
    ex = l <= 1e-6 ? 1 : ex / l;
    ey = l <= 1e-6 ? 0 : ey / l;
  }
  wish->x += 4 * ex;
  wish->y += 4 * ey;
}

static void attitude_torque(double torque[3], const ship *s, const world *in, const load *l, vec3 normal) {
  const ship_class *c = &in->ship_class;
  const double *stick = s->pilot.rotation_input;
  int mode = s->pilot.attitude_mode, damps = s->pilot.attitude_hold;
  if (s->state != FLYING && mode >= MODE_PROGRADE && mode <= MODE_ANTINORMAL) mode = MODE_NONE, damps = 1;
  double available[3];
  for (int k = 0; k < 3; k++) available[k] = s->fuel > 0 ? c->wheel_torque[k] + c->rcs_torque[k] : c->wheel_torque[k];
  if (stick[0] != 0 || stick[1] != 0 || stick[2] != 0) {
    for (int k = 0; k < 3; k++) torque[k] = stick[k] * available[k];
    return;
  }
  if (mode == MODE_NONE && !damps) return;
  vec3 wish = scale(rotate_back(&l->axes, s->w), -4);
  if (mode == MODE_HOLD) wish = add(wish, scale(rotate_back(&l->axes, error_to_target(s)), 4));
  else if (mode != MODE_NONE) steer_to_direction(&wish, s, mode, normal, &l->axes);
  vec3 asked = scale(rotate(&c->inertia, wish), l->ratio);
  const double by_axis[3] = {asked.x, asked.y, asked.z};
  for (int k = 0; k < 3; k++) {
    double most = available[k];
    torque[k] = by_axis[k] > most ? most : by_axis[k] < -most ? -most : by_axis[k];
  }
}

static void push(load *l, ship *s, const world *in, double rcs) {
  const ship_class *c = &in->ship_class;
  const double *input = s->pilot.translation_input;
  l->thrust = vec(0, 0, 0);
  int commanded = s->pilot.thrust_level != 0 || input[0] != 0 || input[1] != 0 || input[2] != 0 || rcs != 0;
  if (!(s->fuel > 0) || !commanded) return;
  double engine = s->pilot.thrust_level * c->main_engine_thrust;
  double fx = input[0] * c->rcs_thrust[0], fy = input[1] * c->rcs_thrust[1], fz = input[2] * c->rcs_thrust[2];
  l->thrust = rotate(&l->axes, vec(fx, fy, fz + engine));
  double burn = fabs(fx) + fabs(fy) + fabs(fz) + rcs * c->force_per_torque;
  double left = s->fuel - (engine * c->main_flow + burn * c->rcs_flow) * l->dt;
  s->fuel = left > 0 ? left : 0;
}

static void actuate(load *l, ship *s, const world *in, vec3 normal) {
  double torque[3] = {0, 0, 0}, rcs = 0;
  if (s->state != LANDED) {
    attitude_torque(torque, s, in, l, normal);
    for (int k = 0; k < 3; k++) {
      double by_rcs = fabs(torque[k]) - in->ship_class.wheel_torque[k];
      if (by_rcs > 0) rcs += by_rcs;
    }
  }
  l->torque = vec(torque[0], torque[1], torque[2]);
  push(l, s, in, rcs);
  l->lift = dot(l->thrust, normal);
}
#endif
