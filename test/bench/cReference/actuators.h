// Step 1 of the substep: engine, thrusters, wheels, attitude control.
#ifndef ACTUATORS_H
#define ACTUATORS_H
#include "contact.h"

// Results of the actuators for the rest of the substep: kg, N, N m, m, s.
typedef struct {
  double mass, factor, weight, lift, pressing, depth, normal_force, dt;
  vec3 thrust, torque, along;
  mat3 axes;
} load;

static vec3 error_to_target(const ship *s) {
  quat t = s->pilot.target_attitude, q = s->q;
  double sign = t.w * q.w + t.x * q.x + t.y * q.y + t.z * q.z >= 0 ? 2 : -2;
  return vec(sign * (t.x * q.w - t.w * q.x - t.y * q.z + t.z * q.y),
             sign * (t.y * q.w - t.w * q.y - t.z * q.x + t.x * q.z),
             sign * (t.z * q.w - t.w * q.z - t.x * q.y + t.y * q.x));
}

// Writes the unit direction of a pointing mode, ICRF; returns 0 if it would be rounding error.
static int direction_of(vec3 *d, const ship *s, const body *b, int mode, vec3 normal, double distance) {
  if (mode == MODE_RADIAL || mode == MODE_ANTIRADIAL) {
    *d = scale(normal, mode == MODE_RADIAL ? 1 : -1);
    return 1;
  }
  if (mode == MODE_SURFACE_RETROGRADE) {
    vec3 v = sub(s->u, cross(b->angular_velocity, s->r));
    double speed = length(v);
    *d = scale(v, -1 / speed);
    return !(speed < 0.1);
  }
  double speed = length(s->u);
  if (speed < 1e-3) return 0;
  if (mode == MODE_PROGRADE || mode == MODE_RETROGRADE) {
    *d = scale(s->u, mode == MODE_PROGRADE ? 1 / speed : -1 / speed);
    return 1;
  }
  vec3 along = cross(s->r, s->u);
  double size = length(along);
  *d = scale(along, mode == MODE_NORMAL ? 1 / size : -1 / size);
  return !(size < 1e-6 * distance * speed);
}

static void steer_to_direction(vec3 *command, double stiffness, vec3 b) {
  double ex = -b.y, ey = b.x;
  if (b.z < 0) {
    double l = sqrt(ex * ex + ey * ey);
    ex = l <= 1e-6 ? 1 : ex / l;
    ey = l <= 1e-6 ? 0 : ey / l;
  }
  command->x += stiffness * ex;
  command->y += stiffness * ey;
}

// Writes the torque commanded by stick or attitude controller; returns 0 if neither is active.
static int ask_torque(double asked[3], const ship *s, const world *in, const load *l, vec3 normal, double distance) {
  const ship_class *c = &in->ship_class;
  const double *stick = s->pilot.rotation_input;
  if (stick[0] != 0 || stick[1] != 0 || stick[2] != 0) {
    for (int k = 0; k < 3; k++)
      asked[k] = stick[k] * (s->fuel > 0 ? c->wheel_torque[k] + c->rcs_torque[k] : c->wheel_torque[k]);
    return 1;
  }
  int mode = s->pilot.attitude_mode, damps = s->pilot.attitude_hold;
  int by_velocity = mode >= MODE_PROGRADE && mode <= MODE_ANTINORMAL;
  if (mode == MODE_UNKNOWN || (s->state != FLYING && by_velocity)) mode = MODE_NONE, damps = 1;
  if (mode == MODE_NONE && !damps) return 0;
  vec3 command = scale(rotate_back(&l->axes, s->w), -c->attitude_damping), d;
  if (mode == MODE_HOLD)
    command = add(command, scale(rotate_back(&l->axes, error_to_target(s)), c->attitude_stiffness));
  else if (mode != MODE_NONE && direction_of(&d, s, &in->bodies[s->body], mode, normal, distance))
    steer_to_direction(&command, c->attitude_stiffness, rotate_back(&l->axes, d));
  vec3 torque = scale(rotate(&c->inertia, command), l->factor);
  asked[0] = torque.x, asked[1] = torque.y, asked[2] = torque.z;
  return 1;
}

// Divides torque between wheels, up to saturation, and RCS. Returns the sum of RCS torque.
static double allocate_torque(double torque[3], ship *s, const ship_class *c, double dt) {
  double rcs = 0;
  for (int k = 0; k < 3; k++) {
    double asked = torque[k], size = fabs(asked), p = s->wheel_momentum[k];
    double left = (asked < 0 ? c->wheel_capacity[k] + p : c->wheel_capacity[k] - p) / dt;
    double most = left < c->wheel_torque[k] ? (left > 0 ? left : 0) : c->wheel_torque[k];
    double by_wheel = size < most ? size : most, by_rcs = 0;
    s->wheel_momentum[k] = p + (asked < 0 ? -by_wheel : by_wheel) * dt;
    if (s->fuel > 0) by_rcs = size - by_wheel < c->rcs_torque[k] ? size - by_wheel : c->rcs_torque[k];
    torque[k] = asked < 0 ? -by_wheel - by_rcs : by_wheel + by_rcs;
    rcs += by_rcs;
  }
  return rcs;
}

static void apply_thrust(load *l, ship *s, const world *in, double rcs) {
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

static void actuate(load *l, ship *s, const world *in, vec3 normal, double distance) {
  double torque[3] = {0, 0, 0}, rcs = 0;
  if (s->state != LANDED && ask_torque(torque, s, in, l, normal, distance))
    rcs = allocate_torque(torque, s, &in->ship_class, l->dt);
  l->torque = vec(torque[0], torque[1], torque[2]);
  apply_thrust(l, s, in, rcs);
  l->lift = dot(l->thrust, normal);
}
#endif
