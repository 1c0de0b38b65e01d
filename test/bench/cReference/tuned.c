#include "actuators.h"

#define CONTACT_STIFFNESS 100
#define CRITICAL_DAMPING 20
#define SUPPORT_STIFFNESS 100
#define SUPPORT_DAMPING 20
#define SCRUB_DAMPING 20

// Quantities at a substep's start or end, in order of computation: n, s, v_s, v_tangential and intermediate values.
typedef struct {
  vec3 normal, body_normal, surface_normal, slope, tangential;
  double distance, gravity, penetration, cos_slope, normal_speed, slide_squared;
} surface;

static void read_place(surface *to, const ship *s, const world *in) {
  double squared = dot(s->r, s->r);
  to->distance = sqrt(squared);
  to->normal = scale(s->r, 1 / to->distance);
  to->gravity = in->bodies[s->body].mu / squared;
}

static void read_penetration(surface *to, const ship *s, const world *in, const mat3 *body_axes) {
  to->body_normal = rotate_back(body_axes, to->normal);
  double ground = in->bodies[s->body].radius + in->terrain_height(in, to->body_normal);
  to->penetration = ground + s->ground_contact_offset - to->distance;
}

static double rise_along(const world *in, vec3 centre, vec3 arm) {
  double ahead = in->terrain_height(in, add(centre, arm)), behind = in->terrain_height(in, sub(centre, arm));
  return (ahead - behind) / (2 * in->ship_class.leg_radius);
}

static void read_slope(surface *to, const world *in, double radius, const mat3 *body_axes) {
  vec3 n = to->body_normal, e1, e2;
  if (n.y >= 0.9 || n.y <= -0.9) {
    double p = 1 / sqrt(n.z * n.z + n.y * n.y);
    e1 = vec(0, -n.z * p, n.y * p);
    e2 = vec(n.y * e1.z - n.z * e1.y, -n.x * e1.z, n.x * e1.y);
  } else {
    double p = 1 / sqrt(n.z * n.z + n.x * n.x);
    e1 = vec(n.z * p, 0, -n.x * p);
    e2 = vec(n.y * e1.z, n.z * e1.x - n.x * e1.z, -n.y * e1.x);
  }
  double arm = in->ship_class.leg_radius / radius, l = 1 / sqrt(1 + arm * arm), d = arm * l;
  vec3 centre = scale(n, l);
  double rise_1 = rise_along(in, centre, scale(e1, d)), rise_2 = rise_along(in, centre, scale(e2, d));
  vec3 square = sub(sub(n, scale(e1, rise_1)), scale(e2, rise_2));
  to->surface_normal = rotate(body_axes, scale(square, 1 / length(square)));
  to->cos_slope = dot(to->normal, to->surface_normal);
  to->slope = sub(to->normal, scale(to->surface_normal, to->cos_slope));
}

static void read_ground(surface *to, const ship *s, const world *in, const mat3 *body_axes) {
  const body *b = &in->bodies[s->body];
  if (in->settings.terrain_normal) {
    read_slope(to, in, b->radius, body_axes);
  } else {
    to->surface_normal = to->normal;
    to->cos_slope = 1;
    to->slope = vec(0, 0, 0);
  }
  vec3 v = sub(s->u, cross(b->angular_velocity, s->r));
  to->normal_speed = dot(v, to->surface_normal);
  to->tangential = sub(v, scale(to->surface_normal, to->normal_speed));
  to->slide_squared = dot(to->tangential, to->tangential);
}

static vec3 relative_spin(const ship *s, const body *b) { return sub(s->w, b->angular_velocity); }

static void turn_place_with_ground(ship *s, const body *b) {
  vec3 a = vec(b->turn.x, b->turn.y, b->turn.z);
  vec3 t = cross(a, s->r), c = cross(a, t);
  s->r = add(add(s->r, scale(t, 2 * b->turn.w)), scale(c, 2));
  s->u = cross(b->angular_velocity, s->r);
}

// Steps 3 to 5

static void read_load(load *l, const surface *at) {
  double pressing = l->mass * at->gravity * at->cos_slope - dot(l->thrust, at->surface_normal);
  l->pressing = pressing > 0 ? pressing : 0;
  l->depth = l->pressing / (CONTACT_STIFFNESS * l->mass);
}

static int is_nearly_at_rest(const load *l, const world *in, const surface *at) {
  double settle = in->settings.settle_linear_vel, sunk = at->penetration * at->cos_slope - l->depth;
  return at->normal_speed * at->normal_speed + CONTACT_STIFFNESS * (sunk * sunk) < settle * settle &&
         at->slide_squared < settle * settle;
}

static int is_pinned(load *l, const ship *s, const world *in, const surface *start) {
  read_load(l, start);
  vec3 level = sub(l->thrust, scale(start->surface_normal, dot(l->thrust, start->surface_normal)));
  l->along = sub(scale(start->slope, l->weight), level);
  if (s->state != TIPPED || !is_nearly_at_rest(l, in, start)) return 0;
  double most = in->settings.friction_static * l->pressing;
  return dot(l->along, l->along) <= most * most;
}

static int settles_without_bounce(const ship *s, const world *in) {
  return s->state == TIPPED || s->impact_speed <= in->settings.bounce_speed;
}

static double normal_force(const load *l, const ship *s, const world *in, const surface *start, int pinned) {
  if (pinned) return l->pressing;
  double damping = settles_without_bounce(s, in) ? CRITICAL_DAMPING : CRITICAL_DAMPING * in->settings.damping_ratio;
  double force = l->mass * (CONTACT_STIFFNESS * (start->penetration * start->cos_slope) - damping * start->normal_speed);
  return force > 0 ? force : 0;
}

static void fly(ship *s, const load *l, const world *in, const surface *start, surface *end) {
  vec3 push = scale(l->thrust, 1 / l->mass), a0 = sub(push, scale(start->normal, start->gravity));
  double half = 0.5 * l->dt;
  s->r = add(s->r, add(scale(s->u, l->dt), scale(a0, half * l->dt)));
  read_place(end, s, in);
  vec3 a1 = sub(push, scale(end->normal, end->gravity));
  s->u = add(s->u, scale(add(a0, a1), half));
}

static vec3 friction_of(const ship *s, const load *l, const world *in, const surface *start) {
  if (!(l->normal_force > 0)) return vec(0, 0, 0);
  vec3 turning = scale(cross(in->bodies[s->body].angular_velocity, s->u), 0.5 * l->mass);
  vec3 demand = sub(scale(start->tangential, l->mass / l->dt), add(l->along, turning));
  demand = sub(demand, scale(start->surface_normal, dot(demand, start->surface_normal)));
  double squared = dot(demand, demand);
  double held = in->settings.friction_static * l->normal_force, kinetic = in->settings.friction_kinetic * l->normal_force;
  int holds = start->slide_squared <= 1e-4 && squared <= held * held;
  return scale(demand, -(holds || squared <= kinetic * kinetic ? 1 : kinetic / sqrt(squared)));
}

static void move_on_ground(ship *s, const load *l, const world *in, const surface *start, int in_ground) {
  vec3 friction = friction_of(s, l, in, start);
  vec3 pressed = l->normal_force > 0 ? scale(start->surface_normal, l->normal_force) : vec(0, 0, 0);
  vec3 force = add(add(sub(pressed, scale(start->normal, l->weight)), friction), l->thrust);
  s->u = add(s->u, scale(force, l->dt / l->mass));
  if (in_ground && l->lift <= l->weight && settles_without_bounce(s, in)) {
    double rise = dot(sub(s->u, cross(in->bodies[s->body].angular_velocity, s->r)), start->surface_normal);
    double rest = (start->penetration * start->cos_slope - l->depth) / l->dt, most = rest > 0 ? rest : 0;
    if (rise > most) s->u = sub(s->u, scale(start->surface_normal, rise - most));
  }
  s->r = add(s->r, scale(s->u, l->dt));
}

// Step 6

static vec3 capped(vec3 moment, double most) {
  double squared = dot(moment, moment);
  return squared > most * most ? scale(moment, most / sqrt(squared)) : moment;
}

static void add_ground_moments(load *l, const ship *s, const world *in, const surface *start) {
  const ship_class *c = &in->ship_class;
  vec3 up = up_of(s->q), spin = relative_spin(s, &in->bodies[s->body]);
  double turning = dot(spin, start->surface_normal);
  vec3 yaw = scale(start->surface_normal, turning);
  double most = l->weight * start->cos_slope, held = l->normal_force < most ? l->normal_force : most;
  double carried = held / start->cos_slope, level = dot(start->normal, up);
  double support = c->support_inertia * l->factor, scrub = c->scrub_inertia * l->factor;
  vec3 by_legs = sub(scale(cross(start->surface_normal, up), -SUPPORT_STIFFNESS * support),
                     scale(sub(spin, yaw), SUPPORT_DAMPING * support));
  by_legs = capped(by_legs, level > 0 ? carried * c->leg_radius * level : 0);
  vec3 by_feet = scale(add(yaw, scale(up, s->state == TIPPED ? dot(spin, up) : 0)), -SCRUB_DAMPING * scrub);
  by_feet = capped(by_feet, in->settings.friction_kinetic * held * c->leg_radius);
  vec3 toppling = scale(cross(start->normal, up), carried * s->ground_contact_offset);
  l->torque = add(l->torque, rotate_back(&l->axes, add(add(toppling, by_legs), by_feet)));
}

static void turn_by_torque(ship *s, const load *l, const world *in) {
  if (l->torque.x != 0 || l->torque.y != 0 || l->torque.z != 0) {
    vec3 change = scale(rotate(&in->ship_class.inverse_inertia, l->torque), l->dt / l->factor);
    s->w = add(s->w, rotate(&l->axes, change));
  }
  s->q = turned(s->q, scale(s->w, 0.5 * l->dt));
}

// Step 8

static vec3 rest_on_side(ship *s, const world *in, vec3 normal, vec3 up, double dt) {
  double cos_tilt = dot(normal, up);
  if (!(cos_tilt < 0)) return up;
  vec3 across = cross(normal, up);
  double size = length(across);
  vec3 axis = size <= 1e-6 ? perpendicular_axis(normal) : scale(across, 1 / size);
  double spin = dot(relative_spin(s, &in->bodies[s->body]), axis);
  if (spin > 0) {
    mat3 axes = axes_of(s->q);
    vec3 j = rotate(&axes, rotate(&in->ship_class.inverse_inertia, rotate_back(&axes, axis)));
    s->w = sub(s->w, scale(j, spin / dot(j, axis)));
  }
  vec3 level = sub(up, scale(normal, cos_tilt));
  quat back = -cos_tilt > dt ? small_rotation(scale(axis, -0.5 * dt))
                             : shortest_rotation(up, scale(level, 1 / length(level)));
  s->q = product(back, s->q);
  return up_of(s->q);
}

// Step 9

static int crash(ship *s) {
  s->crashed = 1;
  s->state = FLYING;
  return EVENT_DESTROYED;
}

static int touch(ship *s, const world *in, const surface *end, vec3 up, double impact) {
  if (impact > in->settings.crash_speed) return crash(s);
  if (!(impact > 0)) return NO_EVENT;
  s->state = CONTACT;
  s->impact_speed = impact;
  if (in->settings.aligned) {
    s->w = in->bodies[s->body].angular_velocity;
    s->q = product(shortest_rotation(up, end->surface_normal), s->q);
  }
  return EVENT_CONTACT;
}

static int is_settled(const ship *s, const world *in, load *l, const surface *end, vec3 up) {
  const settings *set = &in->settings;
  vec3 spin = relative_spin(s, &in->bodies[s->body]);
  read_load(l, end);
  return dot(spin, spin) < set->settle_angular_vel * set->settle_angular_vel && is_nearly_at_rest(l, in, end) &&
         length(end->slope) <= set->friction_static * end->cos_slope &&
         s->ground_contact_offset * length(cross(end->normal, up)) <= in->ship_class.leg_radius * dot(end->normal, up);
}

static int make_transition(ship *s, const world *in, load *l, const surface *start, const surface *end, vec3 up) {
  const body *b = &in->bodies[s->body];
  int touching = end->penetration > 0;
  double falling = -end->normal_speed;
  double closing = (end->penetration - start->penetration) * end->cos_slope / l->dt;
  double impact = falling > closing ? falling : closing, cos_tilt = dot(end->surface_normal, up);
  if (s->state == FLYING) return touching ? touch(s, in, end, up, impact) : NO_EVENT;
  if (touching && impact > in->settings.crash_speed) return crash(s);
  if ((end->penetration <= 0 && end->normal_speed > 0) || end->penetration < -0.1) {
    s->state = FLYING;
    s->impact_speed = 0;
    return NO_EVENT;
  }
  if (s->state == TIPPED) {
    int rights = cos_tilt > in->settings.cos_tipped_angle && dot(relative_spin(s, b), cross(end->surface_normal, up)) < 0;
    if (!rights) return NO_EVENT;
    s->state = CONTACT;
    s->impact_speed = 0;
    return EVENT_RIGHTED;
  }
  if (!touching) return NO_EVENT;
  if (cos_tilt < in->settings.cos_tipped_angle) {
    s->state = TIPPED;
    return EVENT_TIPPED;
  }
  if (!(cos_tilt > in->settings.cos_settle_tilt && is_settled(s, in, l, end, up))) return NO_EVENT;
  s->state = LANDED;
  s->u = cross(b->angular_velocity, s->r);
  s->w = b->angular_velocity;
  return EVENT_LANDED;
}

static int stay_landed(ship *s, const body *b) {
  turn_place_with_ground(s, b);
  s->q = product(b->turn, s->q);
  s->w = b->angular_velocity;
  return NO_EVENT;
}

static int fly_substep(ship *s, const world *in, load *l, surface *start) {
  const body *b = &in->bodies[s->body];
  surface end;
  fly(s, l, in, start, &end);
  turn_by_torque(s, l, in);
  read_penetration(&end, s, in, &b->end_axes);
  if (!(end.penetration > 0)) return NO_EVENT;
  read_penetration(start, s, in, &b->axes);
  read_ground(&end, s, in, &b->end_axes);
  return make_transition(s, in, l, start, &end, up_of(s->q));
}

static int ground_substep(ship *s, const world *in, load *l, surface *start) {
  const body *b = &in->bodies[s->body];
  read_penetration(start, s, in, &b->axes);
  int in_ground = start->penetration > 0, pinned = 0;
  l->normal_force = 0;
  if (in_ground) {
    read_ground(start, s, in, &b->axes);
    pinned = is_pinned(l, s, in, start);
    l->normal_force = normal_force(l, s, in, start, pinned);
  }
  if (!pinned) move_on_ground(s, l, in, start, in_ground);
  if (in_ground) add_ground_moments(l, s, in, start);
  turn_by_torque(s, l, in);
  if (pinned) turn_place_with_ground(s, b);
  surface end;
  read_place(&end, s, in);
  read_penetration(&end, s, in, &b->end_axes);
  read_ground(&end, s, in, &b->end_axes);
  vec3 up = up_of(s->q);
  if (s->state == TIPPED) up = rest_on_side(s, in, end.surface_normal, up, l->dt);
  return make_transition(s, in, l, start, &end, up);
}

static int commands_thrust(const ship *s) {
  const double *input = s->pilot.translation_input;
  return s->pilot.thrust_level != 0 || input[0] != 0 || input[1] != 0 || input[2] != 0;
}

static int substep(ship *s, const world *in, double dt) {
  if (s->crashed) return NO_EVENT;
  const body *b = &in->bodies[s->body];
  if (s->state == LANDED && !commands_thrust(s)) return stay_landed(s, b);
  const ship_class *c = &in->ship_class;
  load l = {.dt = dt, .axes = axes_of(s->q), .mass = c->dry_mass + s->fuel};
  l.factor = c->inertia_at_dry + c->inertia_per_fuel * s->fuel;
  surface start;
  read_place(&start, s, in);
  actuate(&l, s, in, start.normal, start.distance);
  l.weight = l.mass * start.gravity;
  if ((s->state == LANDED || s->state == TIPPED) && l.lift > l.weight) {
    s->state = FLYING;
    s->impact_speed = 0;
  }
  if (s->state == LANDED) return stay_landed(s, b);
  return s->state == FLYING ? fly_substep(s, in, &l, &start) : ground_substep(s, in, &l, &start);
}

int step_world(ship *s, world *in, double dt) {
  for (int i = 0; i < in->body_count; i++) {
    body *b = &in->bodies[i];
    vec3 half_turn = scale(b->angular_velocity, 0.5 * dt);
    b->turn = small_rotation(half_turn);
    b->end_attitude = turned(b->attitude, half_turn);
    b->end_axes = axes_of(b->end_attitude);
  }
  int event = substep(s, in, dt);
  for (int i = 0; i < in->body_count; i++) {
    in->bodies[i].attitude = in->bodies[i].end_attitude;
    in->bodies[i].axes = in->bodies[i].end_axes;
  }
  return event;
}
