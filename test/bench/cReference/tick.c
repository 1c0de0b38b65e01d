// Once per tick: reference bodies and positions of bodies.
#include "contact.h"

void choose_reference_body(ship *s, const world *in) {
  if (s->state != FLYING || s->crashed) return;
  const body *now = &in->bodies[s->body];
  double nearest = INFINITY;
  int best = 0;
  for (int i = 0; i < in->body_count; i++) {
    vec3 d = add(sub(now->position, in->bodies[i].position), s->r);
    double measure = dot(d, d) / (in->bodies[i].radius * in->bodies[i].radius);
    if (measure < nearest) nearest = measure, best = i;
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
