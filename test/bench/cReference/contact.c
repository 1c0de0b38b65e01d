#include "actuators.h"

#define STIFFNESS 100
#define CRITICAL 20

typedef struct {
  vec3 normal, tangential;
  double penetration, radial_speed, slide, gravity;
} surface;

static surface surface_below(const ship *s, const world *in, const mat3 *body_axes) {
  const body *b = &in->bodies[s->body];
  surface to;
  double squared = dot(s->r, s->r), distance = sqrt(squared);
  to.normal = scale(s->r, 1 / distance);
  double height = in->terrain_height(in, rotate_back(body_axes, to.normal));
  to.penetration = b->radius + height + in->ship_class.ground_contact_offset - distance;
  vec3 v = sub(s->u, cross(b->angular_velocity, s->r));
  to.radial_speed = dot(v, to.normal);
  to.tangential = sub(v, scale(to.normal, to.radial_speed));
  to.slide = length(to.tangential);
  to.gravity = b->mu / squared;
  return to;
}

static vec3 relative_spin(const ship *s, const body *b) { return sub(s->w, b->angular_velocity); }

static void turn_place_with_ground(ship *s, const body *b) {
  vec3 a = vec(b->turn.x, b->turn.y, b->turn.z);
  vec3 t = cross(a, s->r), c = cross(a, t);
  s->r = add(add(s->r, scale(t, 2 * b->turn.w)), scale(c, 2));
  s->u = cross(b->angular_velocity, s->r);
}

// 3 to 5

static double static_depth(double net_weight, double mass) {
  return net_weight > 0 ? net_weight / (STIFFNESS * mass) : 0;
}

static double vertical_squared(const surface *at, double depth) {
  double sunk = at->penetration - depth;
  return at->radial_speed * at->radial_speed + STIFFNESS * (sunk * sunk);
}

static int is_pinned(load *l, const ship *s, const world *in, const surface *start) {
  if (s->state == FLYING) return 0;
  double net_weight = l->weight - l->lift, settle = in->settings.settle_linear_vel;
  l->depth = static_depth(net_weight, l->mass);
  if (s->state != TIPPED || !(start->penetration > 0)) return 0;
  if (!(vertical_squared(start, l->depth) < settle * settle) || !(start->slide < settle)) return 0;
  vec3 along = sub(l->thrust, scale(start->normal, l->lift));
  return length(along) <= in->settings.friction_static * (net_weight > 0 ? net_weight : 0);
}

static int settles_without_bounce(const ship *s, const world *in) {
  return s->state == TIPPED || s->impact_speed <= in->settings.bounce_speed;
}

static double normal_force(const load *l, const ship *s, const world *in, const surface *start, int pinned) {
  double force = l->weight - l->lift;
  if (!pinned) {
    if (s->state == FLYING || !(start->penetration > 0)) return 0;
    double damping = settles_without_bounce(s, in) ? CRITICAL : CRITICAL * in->settings.damping_ratio;
    force = l->mass * (STIFFNESS * start->penetration - damping * start->radial_speed);
  }
  return force > 0 ? force : 0;
}

static double friction_per_speed(const load *l, const settings *set, double slide) {
  if (!(l->normal_force > 0 && slide > 0)) return 0;
  double stop = l->mass * slide / l->dt, kinetic = set->friction_kinetic * l->normal_force;
  int holds = slide > 0.01 ? stop < kinetic : stop <= set->friction_static * l->normal_force;
  return (holds ? stop : kinetic) / slide;
}

static void move_by_forces(ship *s, const load *l, const world *in, const surface *start) {
  double friction = friction_per_speed(l, &in->settings, start->slide);
  double per_mass = l->dt / l->mass, radial = l->normal_force - l->weight;
  vec3 force = add(sub(scale(start->normal, radial), scale(start->tangential, friction)), l->thrust);
  s->u = add(s->u, scale(force, per_mass));
  if (s->state != FLYING && start->penetration > 0 && l->lift <= l->weight && settles_without_bounce(s, in)) {
    double rise = dot(sub(s->u, cross(in->bodies[s->body].angular_velocity, s->r)), start->normal);
    double rest = (start->penetration - l->depth) / l->dt, most = rest > 0 ? rest : 0;
    if (rise > most) s->u = sub(s->u, scale(start->normal, rise - most));
  }
  s->r = add(s->r, scale(s->u, l->dt));
}

// 6

static vec3 capped(vec3 moment, double most) {
  double squared = dot(moment, moment);
  return squared > most * most ? scale(moment, most / sqrt(squared)) : moment;
}

static void add_ground_torques(load *l, const ship *s, const world *in, const surface *start) {
  const ship_class *c = &in->ship_class;
  vec3 b = rotate_back(&l->axes, start->normal);
  vec3 w = rotate_back(&l->axes, relative_spin(s, &in->bodies[s->body]));
  double yaw = dot(w, b), held = l->normal_force < l->weight ? l->normal_force : l->weight;
  double toppling = held * c->ground_contact_offset, reach = held * c->leg_radius;
  vec3 support = vec(-100 * b.y - 20 * (w.x - yaw * b.x), 100 * b.x - 20 * (w.y - yaw * b.y), -20 * (w.z - yaw * b.z));
  vec3 scrub = vec(-20 * (yaw * b.x), -20 * (yaw * b.y), -20 * (yaw * b.z + (s->state == TIPPED ? w.z : 0)));
  vec3 by_legs = capped(scale(rotate(&c->inertia, support), l->ratio), b.z > 0 ? reach * b.z : 0);
  vec3 by_feet = capped(scale(rotate(&c->inertia, scrub), l->ratio), in->settings.friction_kinetic * reach);
  l->torque = vec(l->torque.x + toppling * b.y + by_legs.x + by_feet.x,
                  l->torque.y - toppling * b.x + by_legs.y + by_feet.y, l->torque.z + by_legs.z + by_feet.z);
}

static void turn_by_torques(ship *s, load *l, const world *in, const surface *start) {
  if (s->state != FLYING && start->penetration > 0) add_ground_torques(l, s, in, start);
  if (l->torque.x != 0 || l->torque.y != 0 || l->torque.z != 0) {
    vec3 change = scale(rotate(&in->ship_class.inverse_inertia, l->torque), l->dt / l->ratio);
    s->w = add(s->w, rotate(&l->axes, change));
  }
  s->q = turned(s->q, scale(s->w, 0.5 * l->dt));
}

// 8

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

// 9

static int crash(ship *s) {
  s->crashed = 1;
  s->state = FLYING;
  return EVENT_CRASHED;
}

static int touch(ship *s, const world *in, const surface *end, vec3 up, double impact) {
  if (impact > in->settings.crash_speed) return crash(s);
  if (!(impact > 0)) return NO_EVENT;
  s->state = CONTACT;
  s->impact_speed = impact;
  if (in->settings.aligned) {
    s->w = in->bodies[s->body].angular_velocity;
    s->q = product(shortest_rotation(up, end->normal), s->q);
  }
  return EVENT_CONTACT;
}

static int is_settled(const ship *s, const world *in, const load *l, const surface *end) {
  const settings *set = &in->settings;
  vec3 spin = relative_spin(s, &in->bodies[s->body]);
  double mass = in->ship_class.dry_mass + s->fuel, settle = set->settle_linear_vel;
  double depth = static_depth(mass * end->gravity - l->lift, mass);
  return dot(spin, spin) < set->settle_angular_vel * set->settle_angular_vel && end->slide < settle &&
         vertical_squared(end, depth) < settle * settle;
}

static int make_transition(ship *s, const world *in, const load *l, const surface *start, const surface *end, vec3 up) {
  const body *b = &in->bodies[s->body];
  int touching = end->penetration > 0;
  double falling = -end->radial_speed, closing = (end->penetration - start->penetration) / l->dt;
  double impact = falling > closing ? falling : closing, cos_tilt = dot(end->normal, up);
  if (s->state == FLYING) return touching ? touch(s, in, end, up, impact) : NO_EVENT;
  if (touching && impact > in->settings.crash_speed) return crash(s);
  if ((end->penetration <= 0 && end->radial_speed > 0) || end->penetration < -0.1) {
    s->state = FLYING;
    s->impact_speed = 0;
    return NO_EVENT;
  }
  if (s->state == TIPPED) {
    int rights = cos_tilt > in->settings.cos_tipped_angle && dot(relative_spin(s, b), cross(end->normal, up)) < 0;
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
  if (!(cos_tilt > in->settings.cos_settle_tilt && is_settled(s, in, l, end))) return NO_EVENT;
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

static int substep(ship *s, const world *in, double dt) {
  if (s->crashed) return NO_EVENT;
  const body *b = &in->bodies[s->body];
  load l = {.dt = dt, .axes = axes_of(s->q), .mass = in->ship_class.dry_mass + s->fuel};
  l.ratio = l.mass / in->ship_class.full_mass;
  surface start = surface_below(s, in, &b->axes);
  actuate(&l, s, in, start.normal);
  l.weight = l.mass * start.gravity;
  if ((s->state == LANDED || s->state == TIPPED) && l.lift > l.weight) {
    s->state = FLYING;
    s->impact_speed = 0;
  }
  if (s->state == LANDED) return stay_landed(s, b);
  int pinned = is_pinned(&l, s, in, &start);
  l.normal_force = normal_force(&l, s, in, &start, pinned);
  if (!pinned) move_by_forces(s, &l, in, &start);
  turn_by_torques(s, &l, in, &start);
  if (pinned) turn_place_with_ground(s, b);
  vec3 up = up_of(s->q);
  surface end = surface_below(s, in, &b->end_axes);
  if (s->state == TIPPED) up = rest_on_side(s, in, end.normal, up, dt);
  return make_transition(s, in, &l, &start, &end, up);
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

void choose_reference_body(ship *s, const world *in) {
  if (s->state != FLYING || s->crashed) return;
  const body *now = &in->bodies[s->body];
  double strongest = -1;
  int best = 0;
  for (int i = 0; i < in->body_count; i++) {
    vec3 d = add(sub(now->position, in->bodies[i].position), s->r);
    double gravity = in->bodies[i].mu / dot(d, d);
    if (gravity > strongest) strongest = gravity, best = i;
  }
  if (best == s->body) return;
  s->r = add(sub(now->position, in->bodies[best].position), s->r);
  s->u = add(sub(now->velocity, in->bodies[best].velocity), s->u);
  s->body = best;
}

void move_bodies(world *in, double tick_seconds) {
  for (int i = 0; i < in->body_count; i++) {
    body *b = &in->bodies[i];
    b->position = add(b->position, scale(b->velocity, tick_seconds));
  }
}
