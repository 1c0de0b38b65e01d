// The dynamics of src/dynamics in scalar C: a baseline for benchmarks and a third implementation that must agree in every bit.
// straightforward.c follows the text of DYNAMICS.md; tuned.c is structured like the TypeScript. SI units; frames as in
// src/dynamics/state/layout.ts.
#ifndef CONTACT_H
#define CONTACT_H
#include "vectors.h"

enum { FLYING, CONTACT, LANDED, TIPPED };
enum { MODE_NONE, MODE_HOLD, MODE_PROGRADE, MODE_RETROGRADE, MODE_SURFACE_RETROGRADE, MODE_NORMAL, MODE_ANTINORMAL,
       MODE_RADIAL, MODE_ANTIRADIAL, MODE_UNKNOWN };
enum { NO_EVENT, EVENT_CONTACT, EVENT_LANDED, EVENT_TIPPED, EVENT_RIGHTED, EVENT_DESTROYED };

typedef struct {
  double crash_speed, bounce_speed, settle_angular_vel, settle_linear_vel;
  double damping_ratio, friction_static, friction_kinetic;
  double cos_settle_tilt, cos_tipped_angle;
  int aligned, terrain_normal;
} settings;

typedef struct {
  double dry_mass, leg_radius;
  double inertia_at_dry, inertia_per_fuel, support_inertia, scrub_inertia;
  double attitude_stiffness, attitude_damping;
  double main_engine_thrust, main_flow, rcs_flow, force_per_torque;
  double rcs_thrust[3], rcs_torque[3], wheel_torque[3], wheel_capacity[3];
  mat3 inertia, inverse_inertia;
} ship_class;

typedef struct {
  double radius, mu;
  vec3 position, velocity, angular_velocity;
  quat attitude, end_attitude, turn;
  mat3 axes, end_axes;
} body;

typedef struct {
  double thrust_level;
  double translation_input[3], rotation_input[3];
  int attitude_hold, attitude_mode;
  quat target_attitude;
} controls;

typedef struct {
  vec3 r, u;
  quat q;
  vec3 w;
  double fuel, wheel_momentum[3], impact_speed, ground_contact_offset;
  int state, body, crashed;
  controls pilot;
} ship;

typedef struct world world;
struct world {
  settings settings;
  ship_class ship_class;
  body bodies[3];
  int body_count;
  // The game's terrain call as a callback: height, m, in the unit direction n, body axes.
  double (*terrain_height)(const world *of, vec3 n);
  double terrain_base, terrain_amplitude;
  vec3 terrain_axis;
};

// Called before the first substep of a tick.
void choose_reference_body(ship *s, const world *in);
// Advances all bodies and the ship by one substep; returns the event.
int step_world(ship *s, world *in, double dt);
// Called after the last substep of a tick.
void move_bodies(world *in, double tick_seconds);
#endif
