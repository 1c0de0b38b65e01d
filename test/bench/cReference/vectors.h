// Vectors, quaternions and matrices, each sum in the order of src/dynamics/ORDER.md.
#ifndef VECTORS_H
#define VECTORS_H
#include <math.h>

typedef struct { double x, y, z; } vec3;
typedef struct { double x, y, z, w; } quat;
// Row by row.
typedef struct { double m[9]; } mat3;

static inline vec3 vec(double x, double y, double z) { return (vec3){x, y, z}; }
static inline vec3 add(vec3 a, vec3 b) { return vec(a.x + b.x, a.y + b.y, a.z + b.z); }
static inline vec3 sub(vec3 a, vec3 b) { return vec(a.x - b.x, a.y - b.y, a.z - b.z); }
static inline vec3 scale(vec3 a, double s) { return vec(a.x * s, a.y * s, a.z * s); }
static inline double dot(vec3 a, vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static inline double length(vec3 a) { return sqrt(dot(a, a)); }
static inline vec3 cross(vec3 a, vec3 b) {
  return vec(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}

// M v: from body axes into ICRF where M is the matrix of an attitude.
static inline vec3 rotate(const mat3 *a, vec3 v) {
  const double *m = a->m;
  return vec(m[0] * v.x + m[1] * v.y + m[2] * v.z, m[3] * v.x + m[4] * v.y + m[5] * v.z,
             m[6] * v.x + m[7] * v.y + m[8] * v.z);
}

// The transpose of M times v.
static inline vec3 rotate_back(const mat3 *a, vec3 v) {
  const double *m = a->m;
  return vec(m[0] * v.x + m[3] * v.y + m[6] * v.z, m[1] * v.x + m[4] * v.y + m[7] * v.z,
             m[2] * v.x + m[5] * v.y + m[8] * v.z);
}

static inline quat normalize(double x, double y, double z, double w) {
  double p = 1 / sqrt(x * x + y * y + z * z + w * w);
  return (quat){x * p, y * p, z * p, w * p};
}

// The rotation b, then the rotation a.
static inline quat product(quat a, quat b) {
  return normalize(a.x * b.w + a.w * b.x + a.y * b.z - a.z * b.y, a.y * b.w + a.w * b.y + a.z * b.x - a.x * b.z,
                   a.z * b.w + a.w * b.z + a.x * b.y - a.y * b.x, a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z);
}

// normalize(q + (h, 0) q)
static inline quat turned(quat q, vec3 h) {
  return normalize(q.x + (h.x * q.w + h.y * q.z - h.z * q.y), q.y + (h.y * q.w + h.z * q.x - h.x * q.z),
                   q.z + (h.z * q.w + h.x * q.y - h.y * q.x), q.w - (h.x * q.x + h.y * q.y + h.z * q.z));
}

// normalize(h, 1)
static inline quat small_rotation(vec3 h) {
  double p = 1 / sqrt(h.x * h.x + h.y * h.y + h.z * h.z + 1);
  return (quat){h.x * p, h.y * p, h.z * p, p};
}

static inline mat3 axes_of(quat q) {
  double x2 = q.x + q.x, y2 = q.y + q.y, z2 = q.z + q.z;
  return (mat3){{1 - (q.y * y2 + q.z * z2), q.x * y2 - q.w * z2, q.x * z2 + q.w * y2,
                 q.x * y2 + q.w * z2, 1 - (q.x * x2 + q.z * z2), q.y * z2 - q.w * x2,
                 q.x * z2 - q.w * y2, q.y * z2 + q.w * x2, 1 - (q.x * x2 + q.y * y2)}};
}

static inline vec3 up_of(quat q) {
  double x2 = q.x + q.x, y2 = q.y + q.y, z2 = q.z + q.z;
  return vec(q.x * z2 + q.w * y2, q.y * z2 - q.w * x2, 1 - (q.x * x2 + q.y * y2));
}

// unit(a × x), x = (1, 0, 0), or (0, 1, 0) if |a.x| >= 0.9
static inline vec3 perpendicular_axis(vec3 a) {
  if (a.x >= 0.9 || a.x <= -0.9) {
    double p = 1 / sqrt(a.z * a.z + a.x * a.x);
    return vec(-a.z * p, 0, a.x * p);
  }
  double p = 1 / sqrt(a.z * a.z + a.y * a.y);
  return vec(0, a.z * p, -a.y * p);
}

// The shortest rotation from unit a to unit b; half a turn if they are opposite.
static inline quat shortest_rotation(vec3 a, vec3 b) {
  double d = dot(a, b);
  if (d < -0.999999) {
    vec3 axis = perpendicular_axis(a);
    return (quat){axis.x, axis.y, axis.z, 0};
  }
  vec3 c = cross(a, b);
  return normalize(c.x, c.y, c.z, 1 + d);
}
#endif
