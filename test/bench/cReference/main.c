// contact replay < CASES            one line per case: number of substeps and FNV-1a hash of all its rows, as in src/dynamics/state/hash.ts
// contact time ROUNDS TIMES < CASE  one line per round: ns per substep; the case restarts every 50 substeps
// Cases are doubles in the order of landing.ts.
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include "contact.h"

#define MAX_INPUTS 64
#define RUN 50

typedef struct {
  int tick, substep;
  controls pilot;
} input;

typedef struct {
  int ticks, substeps, input_count;
  double dt, tick_seconds;
  world world;
  ship ship;
  input inputs[MAX_INPUTS];
} landing;

static double bowl(const world *of, vec3 n) {
  double along = dot(n, of->terrain_axis);
  return of->terrain_base + of->terrain_amplitude * (along * along);
}

static double flat(const world *of, vec3 n) {
  (void)of, (void)n;
  return 0;
}

static int number(double *to) { return fread(to, sizeof *to, 1, stdin) == 1; }

static double next(void) {
  double value;
  if (!number(&value)) {
    fputs("the case ends too early\n", stderr);
    exit(1);
  }
  return value;
}

static void triple(double to[3]) {
  for (int k = 0; k < 3; k++) to[k] = next();
}

static vec3 vector(void) {
  double v[3];
  triple(v);
  return vec(v[0], v[1], v[2]);
}

static quat quaternion(void) {
  vec3 v = vector();
  return (quat){v.x, v.y, v.z, next()};
}

static mat3 matrix(void) {
  mat3 to;
  for (int k = 0; k < 9; k++) to.m[k] = next();
  return to;
}

static controls pilot(void) {
  controls c = {.thrust_level = next()};
  triple(c.translation_input);
  triple(c.rotation_input);
  c.attitude_hold = (int)next();
  c.attitude_mode = (int)next();
  c.target_attitude = quaternion();
  return c;
}

static settings read_settings(void) {
  settings s;
  s.crash_speed = next(), s.bounce_speed = next(), s.settle_angular_vel = next(), s.settle_linear_vel = next();
  s.damping_ratio = next(), s.friction_static = next(), s.friction_kinetic = next();
  s.cos_settle_tilt = next(), s.cos_tipped_angle = next(), s.aligned = (int)next();
  s.terrain_normal = (int)next();
  return s;
}

static ship_class read_class(void) {
  ship_class c;
  c.dry_mass = next(), c.leg_radius = next();
  c.inertia_at_dry = next(), c.inertia_per_fuel = next(), c.support_inertia = next(), c.scrub_inertia = next();
  c.attitude_stiffness = next(), c.attitude_damping = next();
  c.main_engine_thrust = next(), c.main_flow = next(), c.rcs_flow = next(), c.force_per_torque = next();
  triple(c.rcs_thrust), triple(c.rcs_torque), triple(c.wheel_torque), triple(c.wheel_capacity);
  c.inertia = matrix(), c.inverse_inertia = matrix();
  return c;
}

static body read_body(void) {
  body b;
  b.radius = next(), b.mu = next();
  b.position = vector(), b.velocity = vector(), b.angular_velocity = vector();
  b.attitude = quaternion();
  b.axes = axes_of(b.attitude);
  return b;
}

static ship read_ship(void) {
  ship s;
  s.r = vector(), s.u = vector(), s.q = quaternion(), s.w = vector();
  s.fuel = next(), triple(s.wheel_momentum), s.impact_speed = next();
  s.state = (int)next(), s.body = (int)next(), s.crashed = (int)next();
  next();  // class index, always 0
  s.ground_contact_offset = next();
  s.pilot = pilot();
  return s;
}

// Returns 0 at the end of the input.
static int read_landing(landing *to) {
  double ticks;
  if (!number(&ticks)) return 0;
  to->ticks = (int)ticks, to->substeps = (int)next(), to->dt = next(), to->tick_seconds = next();
  world *w = &to->world;
  w->body_count = (int)next(), to->input_count = (int)next();
  if (w->body_count > 3 || to->input_count > MAX_INPUTS) {
    fputs("more bodies or inputs than there is room for\n", stderr);
    exit(1);
  }
  w->terrain_base = next(), w->terrain_amplitude = next(), w->terrain_axis = vector();
  w->terrain_height = w->terrain_base == 0 && w->terrain_amplitude == 0 ? flat : bowl;
  w->settings = read_settings(), w->ship_class = read_class();
  for (int i = 0; i < w->body_count; i++) w->bodies[i] = read_body();
  to->ship = read_ship();
  for (int i = 0; i < to->input_count; i++) {
    input *in = &to->inputs[i];
    in->tick = (int)next(), in->substep = (int)next(), in->pilot = pilot();
  }
  return 1;
}

static uint32_t hash_doubles(uint32_t hash, const double *from, int count) {
  const unsigned char *bytes = (const unsigned char *)from;
  for (size_t i = 0; i < count * sizeof *from; i++) hash = (hash ^ bytes[i]) * 0x01000193u;
  return hash;
}

// Columns of src/dynamics/state/layout.ts, then the event.
static uint32_t hash_ship(uint32_t hash, const ship *s, int event) {
  const controls *c = &s->pilot;
  const double row[37] = {
      s->r.x, s->r.y, s->r.z, s->u.x, s->u.y, s->u.z, s->q.x, s->q.y, s->q.z, s->q.w, s->w.x, s->w.y, s->w.z,
      s->fuel, s->wheel_momentum[0], s->wheel_momentum[1], s->wheel_momentum[2], s->impact_speed, s->state, s->body,
      s->crashed, 0, s->ground_contact_offset, c->thrust_level,
      c->translation_input[0], c->translation_input[1], c->translation_input[2],
      c->rotation_input[0], c->rotation_input[1], c->rotation_input[2], c->attitude_hold, c->attitude_mode,
      c->target_attitude.x, c->target_attitude.y, c->target_attitude.z, c->target_attitude.w, event};
  return hash_doubles(hash, row, 37);
}

static uint32_t hash_body(uint32_t hash, const body *b) {
  const double row[10] = {b->position.x, b->position.y, b->position.z, b->velocity.x, b->velocity.y,
                          b->velocity.z, b->attitude.x, b->attitude.y, b->attitude.z, b->attitude.w};
  return hash_doubles(hash, row, 10);
}

static uint32_t replay(landing *of) {
  uint32_t hash = 0x811c9dc5u;
  const input *due = of->inputs, *end = of->inputs + of->input_count;
  for (int tick = 0; tick < of->ticks; tick++) {
    choose_reference_body(&of->ship, &of->world);
    for (int s = 0; s < of->substeps; s++) {
      for (; due < end && (due->tick < tick || (due->tick == tick && due->substep <= s)); due++) of->ship.pilot = due->pilot;
      hash = hash_ship(hash, &of->ship, step_world(&of->ship, &of->world, of->dt));
    }
    move_bodies(&of->world, of->tick_seconds);
    for (int i = 0; i < of->world.body_count; i++) hash = hash_body(hash, &of->world.bodies[i]);
  }
  return hash;
}

static double now(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return t.tv_sec * 1e9 + t.tv_nsec;
}

static void run(landing *of, const landing *first, long times) {
  int left = RUN;
  for (long i = 0; i < times; i++, left--) {
    if (left == 0) {
      of->ship = first->ship;
      of->world.bodies[0] = first->world.bodies[0];
      left = RUN;
    }
    step_world(&of->ship, &of->world, of->dt);
  }
}

static void time_rounds(const landing *first, int rounds, long times) {
  landing of = *first;
  for (double until = now() + 3e8; now() < until;) run(&of, first, times);
  for (int i = 0; i < rounds; i++) {
    of.ship = first->ship;
    of.world.bodies[0] = first->world.bodies[0];
    double from = now();
    run(&of, first, times);
    printf("%.3f\n", (now() - from) / times);
  }
  if (of.ship.state != first->ship.state) {
    fputs("left its state while it was timed\n", stderr);
    exit(1);
  }
}

int main(int count, char **words) {
  static landing given;
  if (count == 2 && strcmp(words[1], "replay") == 0) {
    while (read_landing(&given)) printf("%d %08x\n", given.ticks * given.substeps, replay(&given));
    return 0;
  }
  if (count == 4 && strcmp(words[1], "time") == 0 && read_landing(&given)) {
    time_rounds(&given, atoi(words[2]), atol(words[3]));
    return 0;
  }
  fputs("usage: contact replay < CASES, contact time ROUNDS TIMES < CASE\n", stderr);
  return 2;
}
