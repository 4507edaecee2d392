// Vectors, random numbers, primitives and the builder that furniture and people are assembled with.
// World frame: x, y on the floor, z up, metres. Local frames of things: x to their front, y to their left, z up.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

constexpr float kPi = 3.14159265f;

struct V3 {
  float x = 0, y = 0, z = 0;
};
inline V3 operator+(V3 a, V3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline V3 operator-(V3 a, V3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline V3 operator*(V3 a, float s) { return {a.x * s, a.y * s, a.z * s}; }
inline float dot(V3 a, V3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline V3 cross(V3 a, V3 b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
inline float length(V3 a) { return std::sqrt(dot(a, a)); }
inline V3 unit(V3 a) { return a * (1.f / std::max(length(a), 1e-9f)); }

struct M3 {  // rows
  V3 r0{1, 0, 0}, r1{0, 1, 0}, r2{0, 0, 1};
};
inline V3 operator*(const M3& m, V3 v) { return {dot(m.r0, v), dot(m.r1, v), dot(m.r2, v)}; }
inline M3 transposed(const M3& m) {
  return {{m.r0.x, m.r1.x, m.r2.x}, {m.r0.y, m.r1.y, m.r2.y}, {m.r0.z, m.r1.z, m.r2.z}};
}
inline M3 operator*(const M3& a, const M3& b) {
  const M3 t = transposed(b);
  auto row = [&](V3 r) { return V3{dot(r, t.r0), dot(r, t.r1), dot(r, t.r2)}; };
  return {row(a.r0), row(a.r1), row(a.r2)};
}
inline M3 Rx(float a) {
  float c = std::cos(a), s = std::sin(a);
  return {{1, 0, 0}, {0, c, -s}, {0, s, c}};
}
inline M3 Ry(float a) {
  float c = std::cos(a), s = std::sin(a);
  return {{c, 0, s}, {0, 1, 0}, {-s, 0, c}};
}
inline M3 Rz(float a) {
  float c = std::cos(a), s = std::sin(a);
  return {{c, -s, 0}, {s, c, 0}, {0, 0, 1}};
}

struct Pose {  // local to parent
  M3 R;
  V3 t;
  V3 operator*(V3 p) const { return R * p + t; }
  Pose operator*(const Pose& o) const { return {R * o.R, R * o.t + t}; }
};

struct Random {  // splitmix64
  uint64_t s;
  uint64_t next() {
    uint64_t z = (s += 0x9E3779B97F4A7C15ull);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
    return z ^ (z >> 31);
  }
  float u() { return (next() >> 40) * (1.f / 16777216.f); }
  float u(float a, float b) { return a + (b - a) * u(); }
  float n() {  // about normal, within +-3
    return (u() + u() + u() + u() - 2.f) * 1.7320508f;
  }
  float n(float sigma) { return n() * sigma; }
  int i(int n) { return int(next() % uint64_t(n)); }  // 0 .. n-1
  bool chance(float p) { return u() < p; }
  float sign() { return chance(.5f) ? 1.f : -1.f; }
};

// Index of the network's classes (network.py: CLASSES).
enum Class {
  kBackground,
  kPerson,
  kChair,
  kCouch,
  kBed,
  kTable,
  kWheelchair,
  kTrolley,
  kIvStand,
  kBedsideCabinet,
  kCurtain,
  kStorageRack,
  kTrashBin,
  kPlant,
  kSink,
  kToilet,
  kStretcher,
  kBench,
  kClasses
};

// Kinds and layout of primitives, shared with raycast.cu. 28 floats:
// 0 kind, 1 class, 2 instance, 3 share of lost pixels (material), 4-6 bounding sphere, 7 its squared radius,
// 8-16 matrix M (rows), 17-19 centre c (local = M (p - c)), 20-27 by kind.
enum Kind { kBox, kRoundedBox, kEllipsoid, kFrustum, kRoundCone, kAnnulus, kSheet };
constexpr int kPrimitiveFloats = 28;

struct Builder {
  Random& rnd;
  std::vector<float>& out;
  Pose pose;
  int cls = kBackground, instance = 0;
  float loss = 0;  // share of pixels the sensor loses on this material

  float* add(Kind kind, V3 centre, float radius) {
    out.resize(out.size() + kPrimitiveFloats, 0.f);
    float* p = out.data() + out.size() - kPrimitiveFloats;
    p[0] = kind, p[1] = cls, p[2] = instance, p[3] = loss;
    p[4] = centre.x, p[5] = centre.y, p[6] = centre.z, p[7] = radius * radius;
    return p;
  }
  // Rows of M are the local axes in the world, each divided by its scale.
  static void frame(float* p, const M3& R, V3 c, V3 scale) {
    const M3 t = transposed(R);
    const V3 rows[3] = {t.r0 * (1 / scale.x), t.r1 * (1 / scale.y), t.r2 * (1 / scale.z)};
    for (int k = 0; k < 3; ++k) p[8 + 3 * k] = rows[k].x, p[9 + 3 * k] = rows[k].y, p[10 + 3 * k] = rows[k].z;
    p[17] = c.x, p[18] = c.y, p[19] = c.z;
  }
  void box(V3 c, V3 half, const M3& R = M3()) {
    half = {std::max(half.x, .002f), std::max(half.y, .002f), std::max(half.z, .002f)};
    c = pose * c;
    frame(add(kBox, c, length(half)), pose.R * R, c, half);
  }
  void roundedBox(V3 c, V3 half, float r, const M3& R = M3()) {
    r = std::min(r, .95f * std::min(half.x, std::min(half.y, half.z)));
    c = pose * c;
    float* p = add(kRoundedBox, c, length(half));
    frame(p, pose.R * R, c, {1, 1, 1});
    p[20] = half.x, p[21] = half.y, p[22] = half.z, p[23] = r;
  }
  void ellipsoid(V3 c, V3 r, const M3& R = M3()) {
    c = pose * c;
    frame(add(kEllipsoid, c, std::max(r.x, std::max(r.y, r.z))), pose.R * R, c, r);
  }
  // Cut cone from a to b, squeezed along the second cross axis by `flat`; `side` tells the first one.
  void frustum(V3 a, V3 b, float ra, float rb, bool open = false, float flat = 1, V3 side = {0, 1, 0}) {
    a = pose * a, b = pose * b, side = pose.R * side;
    const V3 axis = unit(b - a);
    V3 s = side - axis * dot(side, axis);
    if (length(s) < .1f) s = cross(axis, std::fabs(axis.x) < .8f ? V3{1, 0, 0} : V3{0, 0, 1});
    s = unit(s);
    const V3 t = cross(axis, s), c = (a + b) * .5f;
    const float h = std::max(length(b - a) * .5f, 1e-3f), r = std::max(std::max(ra, rb), 1e-3f);
    float* p = add(kFrustum, c, std::sqrt(h * h + r * r));
    frame(p, transposed(M3{s, t, axis}), c, {r, r * flat, h});
    p[20] = ra / r, p[21] = rb / r, p[22] = open;
  }
  void cylinder(V3 a, V3 b, float r) { frustum(a, b, r, r); }
  void roundCone(V3 a, V3 b, float ra, float rb) {
    a = pose * a, b = pose * b;
    float* p = add(kRoundCone, (a + b) * .5f, .5f * length(b - a) + std::max(ra, rb));
    p[8] = a.x, p[9] = a.y, p[10] = a.z, p[11] = b.x, p[12] = b.y, p[13] = b.z, p[14] = ra, p[15] = rb;
  }
  void capsule(V3 a, V3 b, float r) { roundCone(a, b, r, r); }
  void annulus(V3 c, V3 normal, float inner, float outer) {
    c = pose * c, normal = unit(pose.R * normal);
    const V3 s = unit(cross(normal, std::fabs(normal.x) < .8f ? V3{1, 0, 0} : V3{0, 0, 1}));
    float* p = add(kAnnulus, c, outer);
    frame(p, transposed(M3{s, cross(normal, s), normal}), c, {1, 1, 1});
    p[20] = inner, p[21] = outer;
  }
  // Wavy sheet in the local x (width), z (height) plane: y = a sin(k x + phase) + a2 sin(k2 x).
  void sheet(V3 c, float halfWidth, float halfHeight, float a, float k, float phase, float a2, float k2,
             const M3& R = M3()) {
    c = pose * c;
    float* p = add(kSheet, c, std::sqrt(halfWidth * halfWidth + halfHeight * halfHeight + a * a + a2 * a2) + .02f);
    frame(p, pose.R * R, c, {1, 1, 1});
    p[20] = halfWidth, p[21] = halfHeight, p[22] = a, p[23] = k, p[24] = phase, p[25] = a2, p[26] = k2;
  }
  // Wheel that stands on the floor, axle along local y.
  void wheel(V3 c, float r, float width) { frustum(c - V3{0, width / 2, 0}, c + V3{0, width / 2, 0}, r, r); }
};
