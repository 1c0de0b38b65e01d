// The dynamics step by step as in DYNAMICS.md. Every quantity of its table is computed at the substep's start and end, whether or not it
// is used, and every rotation uses a quaternion. Nothing is computed lazily, cached or shared between steps. The bits equal those of
// tuned.c, since both keep the order of ORDER.md.
#include "actuators.h"

#define CONTACT_STIFFNESS 100
#define CRITICAL_DAMPING 20
#define SUPPORT_STIFFNESS 100
#define SUPPORT_DAMPING 20
#define SCRUB_DAMPING 20

// Quantities of the table in DYNAMICS.md: m, N, rad/s, ICRF axes.
typedef struct {
  vec3 normal, surface_normal, slope, velocity, tangential, up, spin;
  double distance, gravity, penetration, cos_slope, cos_tilt, normal_speed, slide_squared;
  double weight, load, depth, vertical_squared;
  vec3 along;
} quantities;

static vec3 turn_out(quat q, vec3 v) {
  mat3 axes = axes_of(q);
  return rotate(&axes, v);
}

static vec3 turn_in(quat q, vec3 v) {
  mat3 axes = axes_of(q);
  return rotate_back(&axes, v);
}

static double height(const world *in, vec3 n) { return in->terrain_height(in, n); }

// Normal of the plane through the ground around the feet, body axes.
static vec3 terrain_normal(const world *in, double radius, vec3 n) {
  double leg_radius = in->ship_class.leg_radius, arm = leg_radius / radius;
  int near_pole = n.y >= 0.9 || n.y <= -0.9;
  double p = near_pole ? 1 / sqrt(n.z * n.z + n.y * n.y) : 1 / sqrt(n.z * n.z + n.x * n.x);
  vec3 e1 = near_pole ? vec(0, -n.z * p, n.y * p) : vec(n.z * p, 0, -n.x * p);
  vec3 e2 = near_pole ? vec(n.y * e1.z - n.z * e1.y, -n.x * e1.z, n.x * e1.y)
                      : vec(n.y * e1.z, n.z * e1.x - n.x * e1.z, -n.y * e1.x);
  double l = 1 / sqrt(1 + arm * arm), d = arm * l;
  vec3 centre = scale(n, l), arm_1 = scale(e1, d), arm_2 = scale(e2, d);
  double rise_1 = (height(in, add(centre, arm_1)) - height(in, sub(centre, arm_1))) / (2 * leg_radius);
  double rise_2 = (height(in, add(centre, arm_2)) - height(in, sub(centre, arm_2))) / (2 * leg_radius);
  vec3 square = sub(sub(n, scale(e1, rise_1)), scale(e2, rise_2));
  return scale(square, 1 / length(square));
}

// Only the quantities of position, which the actuators need.
static void find_place(quantities *to, const ship *s, const body *b) {
  double squared = dot(s->r, s->r);
  to->distance = sqrt(squared);
  to->normal = scale(s->r, 1 / to->distance);
  to->gravity = b->mu / squared;
}

static quantities find_quantities(const ship *s, const world *in, const load *l, quat body_attitude) {
  const body *b = &in->bodies[s->body];
  quantities to;
  find_place(&to, s, b);
  vec3 body_normal = turn_in(body_attitude, to.normal);
  to.penetration = b->radius + height(in, body_normal) + s->ground_contact_offset - to.distance;
  to.surface_normal = to.normal;
  to.cos_slope = 1;
  to.slope = vec(0, 0, 0);
  if (in->settings.terrain_normal && (s->state != FLYING || to.penetration > 0)) {
    to.surface_normal = turn_out(body_attitude, terrain_normal(in, b->radius, body_normal));
    to.cos_slope = dot(to.normal, to.surface_normal);
    to.slope = sub(to.normal, scale(to.surface_normal, to.cos_slope));
  }
  to.velocity = sub(s->u, cross(b->angular_velocity, s->r));
  to.normal_speed = dot(to.velocity, to.surface_normal);
  to.tangential = sub(to.velocity, scale(to.surface_normal, to.normal_speed));
  to.slide_squared = dot(to.tangential, to.tangential);
  to.up = up_of(s->q);
  to.cos_tilt = dot(to.surface_normal, to.up);
  to.spin = sub(s->w, b->angular_velocity);
  to.weight = l->mass * to.gravity;
  double off = dot(l->thrust, to.surface_normal), pressing = to.weight * to.cos_slope - off;
  to.load = pressing > 0 ? pressing : 0;
  to.along = sub(scale(to.slope, to.weight), sub(l->thrust, scale(to.surface_normal, off)));
  to.depth = to.load / (CONTACT_STIFFNESS * l->mass);
  double sunk = to.penetration * to.cos_slope - to.depth;
  to.vertical_squared = to.normal_speed * to.normal_speed + CONTACT_STIFFNESS * (sunk * sunk);
  return to;
}

// Rotation with the ground over dt.
static void turn_place(ship *s, const body *b) {
  vec3 a = vec(b->turn.x, b->turn.y, b->turn.z), t = cross(a, s->r);
  s->r = add(add(s->r, scale(t, 2 * b->turn.w)), scale(cross(a, t), 2));
  s->u = cross(b->angular_velocity, s->r);
}

static int stay_landed(ship *s, const body *b) {
  turn_place(s, b);
  s->q = product(b->turn, s->q);
  s->w = b->angular_velocity;
  return NO_EVENT;
}

// 3. Settling

static int is_slow(const quantities *at, const settings *set) {
  double limit = set->settle_linear_vel * set->settle_linear_vel;
  return at->vertical_squared < limit && at->slide_squared < limit;
}

static int is_pinned(const ship *s, const world *in, const quantities *start) {
  double most = in->settings.friction_static * start->load;
  return s->state == TIPPED && start->penetration > 0 && is_slow(start, &in->settings) &&
         dot(start->along, start->along) <= most * most;
}

// 4. Normal force

static int is_settling(const ship *s, const world *in) {
  return s->state == TIPPED || s->impact_speed <= in->settings.bounce_speed;
}

static double normal_force(const ship *s, const world *in, const load *l, const quantities *start, int pinned) {
  if (pinned) return start->load;
  if (!(start->penetration > 0)) return 0;
  double damping = is_settling(s, in) ? CRITICAL_DAMPING : CRITICAL_DAMPING * in->settings.damping_ratio;
  double force = l->mass * (CONTACT_STIFFNESS * (start->penetration * start->cos_slope) - damping * start->normal_speed);
  return force > 0 ? force : 0;
}

// 5. Linear

static void fly(ship *s, const body *b, const load *l, const quantities *start) {
  vec3 push = scale(l->thrust, 1 / l->mass), a0 = sub(push, scale(start->normal, start->gravity));
  s->r = add(s->r, add(scale(s->u, l->dt), scale(a0, 0.5 * l->dt * l->dt)));
  quantities moved;
  find_place(&moved, s, b);
  vec3 a1 = sub(push, scale(moved.normal, moved.gravity));
  s->u = add(s->u, scale(add(a0, a1), 0.5 * l->dt));
}

static vec3 friction(const ship *s, const world *in, const load *l, const quantities *start) {
  if (!(l->normal_force > 0)) return vec(0, 0, 0);
  vec3 turning = scale(cross(in->bodies[s->body].angular_velocity, s->u), 0.5 * l->mass);
  vec3 demand = sub(scale(start->tangential, l->mass / l->dt), add(start->along, turning));
  demand = sub(demand, scale(start->surface_normal, dot(demand, start->surface_normal)));
  double squared = dot(demand, demand);
  double held = in->settings.friction_static * l->normal_force, kinetic = in->settings.friction_kinetic * l->normal_force;
  int holds = start->slide_squared <= 1e-4 && squared <= held * held;
  return scale(demand, -(holds || squared <= kinetic * kinetic ? 1 : kinetic / sqrt(squared)));
}

static void move_on_ground(ship *s, const world *in, const load *l, const quantities *start) {
  vec3 pressed = scale(start->surface_normal, l->normal_force);
  vec3 force = add(add(sub(pressed, scale(start->normal, start->weight)), friction(s, in, l, start)), l->thrust);
  s->u = add(s->u, scale(force, l->dt / l->mass));
  if (is_settling(s, in) && l->lift <= start->weight && start->penetration > 0) {
    double rise = dot(sub(s->u, cross(in->bodies[s->body].angular_velocity, s->r)), start->surface_normal);
    double rest = (start->penetration * start->cos_slope - start->depth) / l->dt, most = rest > 0 ? rest : 0;
    if (rise > most) s->u = sub(s->u, scale(start->surface_normal, rise - most));
  }
  s->r = add(s->r, scale(s->u, l->dt));
}

// 6. Angular

static vec3 capped(vec3 moment, double most) {
  double squared = dot(moment, moment);
  return squared > most * most ? scale(moment, most / sqrt(squared)) : moment;
}

static vec3 ground_moment(const ship *s, const world *in, const load *l, const quantities *start) {
  const ship_class *c = &in->ship_class;
  double most = start->weight * start->cos_slope, held = l->normal_force < most ? l->normal_force : most;
  double carried = held / start->cos_slope, level = dot(start->normal, start->up);
  double yaw = dot(start->spin, start->surface_normal), roll = s->state == TIPPED ? dot(start->spin, start->up) : 0;
  vec3 turning = scale(start->surface_normal, yaw), tilting = sub(start->spin, turning);
  vec3 gravity = scale(cross(start->normal, start->up), carried * s->ground_contact_offset);
  double j = c->support_inertia * l->factor, j2 = c->scrub_inertia * l->factor;
  vec3 support = sub(scale(cross(start->surface_normal, start->up), -SUPPORT_STIFFNESS * j), scale(tilting, SUPPORT_DAMPING * j));
  vec3 scrub = scale(add(turning, scale(start->up, roll)), -SCRUB_DAMPING * j2);
  support = capped(support, level > 0 ? carried * c->leg_radius * level : 0);
  scrub = capped(scrub, in->settings.friction_kinetic * held * c->leg_radius);
  return add(add(gravity, support), scrub);
}

static void turn(ship *s, const world *in, const load *l, vec3 torque) {
  if (torque.x != 0 || torque.y != 0 || torque.z != 0) {
    vec3 change = scale(rotate(&in->ship_class.inverse_inertia, torque), l->dt / l->factor);
    s->w = add(s->w, turn_out(s->q, change));
  }
  s->q = turned(s->q, scale(s->w, 0.5 * l->dt));
}

// 8. Tipped

static void rest_on_side(ship *s, const world *in, const quantities *end, double dt) {
  vec3 across = cross(end->surface_normal, end->up);
  double size = length(across);
  vec3 axis = size <= 1e-6 ? perpendicular_axis(end->surface_normal) : scale(across, 1 / size);
  double spin = dot(end->spin, axis);
  if (spin > 0) {
    vec3 j = turn_out(s->q, rotate(&in->ship_class.inverse_inertia, turn_in(s->q, axis)));
    s->w = sub(s->w, scale(j, spin / dot(j, axis)));
  }
  vec3 level = sub(end->up, scale(end->surface_normal, end->cos_tilt));
  quat back = -end->cos_tilt > dt ? small_rotation(scale(axis, -0.5 * dt))
                                  : shortest_rotation(end->up, scale(level, 1 / length(level)));
  s->q = product(back, s->q);
}

// 9. Transitions

static int crash(ship *s) {
  s->crashed = 1;
  s->state = FLYING;
  return EVENT_DESTROYED;
}

static int touch(ship *s, const world *in, const quantities *end, double impact) {
  s->state = CONTACT;
  s->impact_speed = impact;
  if (in->settings.aligned) {
    s->w = in->bodies[s->body].angular_velocity;
    s->q = product(shortest_rotation(end->up, end->surface_normal), s->q);
  }
  return EVENT_CONTACT;
}

static int is_settled(const ship *s, const world *in, const quantities *end) {
  const settings *set = &in->settings;
  return end->cos_tilt > set->cos_settle_tilt &&
         dot(end->spin, end->spin) < set->settle_angular_vel * set->settle_angular_vel && is_slow(end, set) &&
         length(end->slope) <= set->friction_static * end->cos_slope &&
         s->ground_contact_offset * length(cross(end->normal, end->up)) <=
             in->ship_class.leg_radius * dot(end->normal, end->up);
}

static int make_transition(ship *s, const world *in, const quantities *start, const quantities *end, double dt) {
  const body *b = &in->bodies[s->body];
  int touching = end->penetration > 0;
  double closing = (end->penetration - start->penetration) * end->cos_slope / dt;
  double impact = -end->normal_speed > closing ? -end->normal_speed : closing;
  if (touching && impact > in->settings.crash_speed) return crash(s);
  if (s->state == FLYING) return touching && impact > 0 ? touch(s, in, end, impact) : NO_EVENT;
  if ((!touching && end->normal_speed > 0) || end->penetration < -0.1) {
    s->state = FLYING;
    s->impact_speed = 0;
    return NO_EVENT;
  }
  if (s->state == TIPPED) {
    int rights = end->cos_tilt > in->settings.cos_tipped_angle && dot(end->spin, cross(end->surface_normal, end->up)) < 0;
    if (!rights) return NO_EVENT;
    s->state = CONTACT;
    s->impact_speed = 0;
    return EVENT_RIGHTED;
  }
  if (touching && end->cos_tilt < in->settings.cos_tipped_angle) {
    s->state = TIPPED;
    return EVENT_TIPPED;
  }
  if (!(touching && is_settled(s, in, end))) return NO_EVENT;
  s->state = LANDED;
  s->u = cross(b->angular_velocity, s->r);
  s->w = b->angular_velocity;
  return EVENT_LANDED;
}

static int substep(ship *s, const world *in, double dt) {
  if (s->crashed) return NO_EVENT;  // 0
  const body *b = &in->bodies[s->body];
  const ship_class *c = &in->ship_class;
  load l = {.dt = dt, .axes = axes_of(s->q), .mass = c->dry_mass + s->fuel};
  l.factor = c->inertia_at_dry + c->inertia_per_fuel * s->fuel;
  quantities start;
  find_place(&start, s, b);
  actuate(&l, s, in, start.normal, start.distance);  // 1
  if ((s->state == LANDED || s->state == TIPPED) && l.lift > l.mass * start.gravity) {  // 2
    s->state = FLYING;
    s->impact_speed = 0;
  }
  if (s->state == LANDED) return stay_landed(s, b);
  start = find_quantities(s, in, &l, b->attitude);
  int on_ground = s->state != FLYING, pinned = is_pinned(s, in, &start);  // 3
  l.normal_force = on_ground ? normal_force(s, in, &l, &start, pinned) : 0;  // 4
  if (!on_ground) fly(s, b, &l, &start);  // 5
  else if (!pinned) move_on_ground(s, in, &l, &start);
  vec3 torque = l.torque;  // 6
  if (on_ground && start.penetration > 0) torque = add(torque, turn_in(s->q, ground_moment(s, in, &l, &start)));
  turn(s, in, &l, torque);
  if (pinned) turn_place(s, b);  // 8
  quantities end = find_quantities(s, in, &l, b->end_attitude);
  if (s->state == TIPPED && end.cos_tilt < 0) {
    rest_on_side(s, in, &end, dt);
    end = find_quantities(s, in, &l, b->end_attitude);
  }
  return make_transition(s, in, &start, &end, dt);  // 9
}

int step_world(ship *s, world *in, double dt) {
  for (int i = 0; i < in->body_count; i++) {  // 7
    body *b = &in->bodies[i];
    vec3 half_turn = scale(b->angular_velocity, 0.5 * dt);
    b->turn = small_rotation(half_turn);
    b->end_attitude = turned(b->attitude, half_turn);
  }
  int event = substep(s, in, dt);
  for (int i = 0; i < in->body_count; i++) in->bodies[i].attitude = in->bodies[i].end_attitude;
  return event;
}
