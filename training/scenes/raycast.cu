// Ray caster: one thread a pixel, a loop over the scene's primitives; depth, class, instance and material come out.
// The same file is compiled by nvcc (GPU) and, as C++, by g++ (to look at pictures without one).
#include <cmath>
#include <cstdint>

#ifdef __CUDACC__
#define DEVICE __device__ __forceinline__
#else
#define DEVICE static inline
#endif

enum Kind { kBox, kRoundedBox, kEllipsoid, kFrustum, kRoundCone, kAnnulus, kSheet };
constexpr int kPrimitiveFloats = 28;
constexpr int kCameraFloats = 16;  // R (camera to world, rows), centre, fx, fy, cx, cy at 640 x 480
constexpr float kNear = 0.02f, kFar = 30.f;

struct F3 {
  float x, y, z;
};
DEVICE F3 sub(F3 a, F3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
DEVICE float dot(F3 a, F3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
DEVICE F3 at(F3 o, F3 d, float t) { return {o.x + t * d.x, o.y + t * d.y, o.z + t * d.z}; }
DEVICE F3 apply(const float* m, F3 v) {
  return {m[0] * v.x + m[1] * v.y + m[2] * v.z, m[3] * v.x + m[4] * v.y + m[5] * v.z,
          m[6] * v.x + m[7] * v.y + m[8] * v.z};
}
DEVICE bool closer(float t, float best) { return t > kNear && t < best; }

// Each returns the ray parameter of the nearest hit, or kFar.  Rays start outside of things, or see their inside.
DEVICE float hitSlab(F3 o, F3 d, F3 h, float& leave) {
  const float ix = 1.f / (fabsf(d.x) < 1e-9f ? 1e-9f : d.x), iy = 1.f / (fabsf(d.y) < 1e-9f ? 1e-9f : d.y),
              iz = 1.f / (fabsf(d.z) < 1e-9f ? 1e-9f : d.z);
  const float ax = (-h.x - o.x) * ix, bx = (h.x - o.x) * ix, ay = (-h.y - o.y) * iy, by = (h.y - o.y) * iy,
              az = (-h.z - o.z) * iz, bz = (h.z - o.z) * iz;
  const float enter = fmaxf(fmaxf(fminf(ax, bx), fminf(ay, by)), fminf(az, bz));
  leave = fminf(fminf(fmaxf(ax, bx), fmaxf(ay, by)), fmaxf(az, bz));
  return enter <= leave ? enter : kFar;
}
DEVICE float hitBox(F3 o, F3 d) {
  float leave;
  const float enter = hitSlab(o, d, {1, 1, 1}, leave);
  if (enter >= kFar) return kFar;
  return enter > kNear ? enter : (leave > kNear ? leave : kFar);
}
DEVICE float hitRoundedBox(F3 o, F3 d, const float* e) {
  float leave;
  const float enter = hitSlab(o, d, {e[0], e[1], e[2]}, leave);
  if (enter >= kFar || leave < kNear) return kFar;
  float t = fmaxf(enter, kNear);
  const float r = e[3], step = 1.f / sqrtf(dot(d, d));
  for (int k = 0; k < 20 && t < leave; ++k) {  // sphere tracing
    const F3 p = at(o, d, t);
    const float qx = fmaxf(fabsf(p.x) - e[0] + r, 0.f), qy = fmaxf(fabsf(p.y) - e[1] + r, 0.f),
                qz = fmaxf(fabsf(p.z) - e[2] + r, 0.f);
    const float distance = sqrtf(qx * qx + qy * qy + qz * qz) - r;
    if (distance < 5e-4f) return t;
    t += distance * step;
  }
  return kFar;
}
DEVICE float hitEllipsoid(F3 o, F3 d) {
  const float a = dot(d, d), b = dot(o, d), c = dot(o, o) - 1.f, q = b * b - a * c;
  if (q < 0) return kFar;
  const float s = sqrtf(q), t = (-b - s) / a;
  return t > kNear ? t : ((-b + s) / a > kNear ? (-b + s) / a : kFar);
}
DEVICE float hitFrustum(F3 o, F3 d, const float* e) {
  // Radius at height z (-1 .. 1): m + g z.
  const float m = .5f * (e[0] + e[1]), g = .5f * (e[1] - e[0]);
  const float ro = m + g * o.z, rd = g * d.z;
  const float a = d.x * d.x + d.y * d.y - rd * rd, b = o.x * d.x + o.y * d.y - ro * rd,
              c = o.x * o.x + o.y * o.y - ro * ro;
  float best = kFar;
  const float q = b * b - a * c;
  if (q >= 0 && fabsf(a) > 1e-12f) {
    const float s = sqrtf(q);
    for (int k = 0; k < 2; ++k) {
      const float t = (k ? -b + s : -b - s) / a, z = o.z + t * d.z;
      if (fabsf(z) <= 1.f && m + g * z >= 0 && closer(t, best)) best = t;
    }
  }
  if (e[2] < .5f && fabsf(d.z) > 1e-9f) {
    for (int k = 0; k < 2; ++k) {
      const float t = ((k ? 1.f : -1.f) - o.z) / d.z, x = o.x + t * d.x, y = o.y + t * d.y, r = k ? e[1] : e[0];
      if (x * x + y * y <= r * r && closer(t, best)) best = t;
    }
  }
  return best;
}
DEVICE float hitSphere(F3 o, F3 d, float r) {
  const float a = dot(d, d), b = dot(o, d), q = b * b - a * (dot(o, o) - r * r);
  if (q < 0) return kFar;
  const float t = (-b - sqrtf(q)) / a;
  return t > kNear ? t : kFar;
}
// Hull of two spheres: the nearest of both spheres and of the cone that touches them.
DEVICE float hitRoundCone(F3 o, F3 d, const float* p) {
  const F3 A = {p[0], p[1], p[2]}, B = {p[3], p[4], p[5]};
  const float ra = p[6], rb = p[7];
  const F3 oa = sub(o, A);
  float best = hitSphere(oa, d, ra);
  const float tb = hitSphere(sub(o, B), d, rb);
  if (tb < best) best = tb;
  F3 axis = sub(B, A);
  const float L = sqrtf(dot(axis, axis));
  if (L < 1e-6f || L <= fabsf(ra - rb)) return best;
  axis = {axis.x / L, axis.y / L, axis.z / L};
  const float sn = (ra - rb) / L, c2 = 1.f - sn * sn;
  const float y0 = dot(oa, axis), vy = dot(d, axis), k0 = ra - y0 * sn;
  const float a = (dot(d, d) - vy * vy) * c2 - vy * vy * sn * sn, b = (dot(oa, d) - y0 * vy) * c2 + k0 * vy * sn,
              c = (dot(oa, oa) - y0 * y0) * c2 - k0 * k0;
  const float q = b * b - a * c;
  if (q < 0 || fabsf(a) < 1e-12f) return best;
  const float s = sqrtf(q);
  for (int k = 0; k < 2; ++k) {
    const float t = (k ? -b + s : -b - s) / a, y = y0 + t * vy, centre = (y - ra * sn) / c2;
    if (centre >= 0 && centre <= L && ra - y * sn > 0 && closer(t, best)) best = t;
  }
  return best;
}
DEVICE float hitAnnulus(F3 o, F3 d, const float* e) {
  if (fabsf(d.z) < 1e-9f) return kFar;
  const float t = -o.z / d.z, x = o.x + t * d.x, y = o.y + t * d.y, q = x * x + y * y;
  return t > kNear && q >= e[0] * e[0] && q <= e[1] * e[1] ? t : kFar;
}
DEVICE float sheetHeight(F3 p, const float* e) {
  return p.y - e[2] * sinf(e[3] * p.x + e[4]) - e[5] * sinf(e[6] * p.x);
}
DEVICE float hitSheet(F3 o, F3 d, const float* e) {
  float leave;
  float t = hitSlab(o, d, {e[0], e[2] + e[5] + 1e-3f, e[1]}, leave);
  if (t >= kFar || leave < kNear) return kFar;
  t = fmaxf(t, kNear);
  const int steps = 28;
  const float dt = (leave - t) / steps;
  float before = sheetHeight(at(o, d, t), e);
  for (int k = 0; k < steps; ++k) {  // march, then the secant
    const float now = sheetHeight(at(o, d, t + dt), e);
    if (before * now <= 0) return t + dt * before / (before - now + (before == now ? 1e-6f : 0.f));
    before = now, t += dt;
  }
  return kFar;
}

// Writes one pixel: depth in metres (0: nothing hit), class, instance, material.
DEVICE void castPixel(const float* primitives, int count, const float* camera, int u, int v, int width, int height,
                      float* depth, uint8_t* cls, uint8_t* instance, uint8_t* material) {
  const float scale = 640.f / width;
  const float x = ((u + .5f) * scale - .5f - camera[14]) / camera[12],
              y = ((v + .5f) * (480.f / height) - .5f - camera[15]) / camera[13];
  const F3 d = apply(camera, {x, y, 1.f}), o = {camera[9], camera[10], camera[11]};
  const float dd = dot(d, d), dn = sqrtf(dd);
  float best = kFar;
  int hit = -1;
  for (int k = 0; k < count; ++k) {
    const float* p = primitives + k * kPrimitiveFloats;
    const F3 oc = {p[4] - o.x, p[5] - o.y, p[6] - o.z};
    const float tc = dot(oc, d) / dd, off = dot(oc, oc) - tc * tc * dd;
    if (off > p[7]) continue;
    const float half = sqrtf(p[7]) / dn;
    if (tc - half > best || tc + half < kNear) continue;
    const int kind = int(p[0]);
    float t;
    if (kind == kRoundCone) {
      t = hitRoundCone(o, d, p + 8);
    } else {
      const F3 lo = apply(p + 8, sub(o, {p[17], p[18], p[19]})), ld = apply(p + 8, d);
      switch (kind) {
        case kBox:
          t = hitBox(lo, ld);
          break;
        case kRoundedBox:
          t = hitRoundedBox(lo, ld, p + 20);
          break;
        case kEllipsoid:
          t = hitEllipsoid(lo, ld);
          break;
        case kFrustum:
          t = hitFrustum(lo, ld, p + 20);
          break;
        case kAnnulus:
          t = hitAnnulus(lo, ld, p + 20);
          break;
        default:
          t = hitSheet(lo, ld, p + 20);
      }
    }
    if (closer(t, best)) best = t, hit = k;
  }
  const int index = v * width + u;
  const float* p = primitives + (hit < 0 ? 0 : hit) * kPrimitiveFloats;
  depth[index] = hit < 0 ? 0.f : best;  // the ray's z is 1: its parameter is the depth
  cls[index] = hit < 0 ? 0 : uint8_t(p[1]);
  instance[index] = hit < 0 ? 0 : uint8_t(p[2]);
  material[index] = hit < 0 ? 0 : uint8_t(p[3] * 255.f);
}

#ifdef __CUDACC__
__global__ void castKernel(const float* primitives, const int* counts, int capacity, const float* cameras, int width,
                           int height, float* depth, uint8_t* cls, uint8_t* instance, uint8_t* material) {
  const int u = blockIdx.x * blockDim.x + threadIdx.x, v = blockIdx.y * blockDim.y + threadIdx.y, s = blockIdx.z;
  if (u >= width || v >= height) return;
  const size_t image = size_t(s) * width * height;
  castPixel(primitives + size_t(s) * capacity * kPrimitiveFloats, counts[s], cameras + s * kCameraFloats, u, v, width,
            height, depth + image, cls + image, instance + image, material + image);
}
#endif

// All pointers on the device (GPU build) or host. Returns 0 or the CUDA error.
extern "C" int raycast(const float* primitives, const int* counts, int capacity, const float* cameras, int scenes,
                       int width, int height, float* depth, uint8_t* cls, uint8_t* instance, uint8_t* material,
                       void* stream) {
#ifdef __CUDACC__
  const dim3 block(16, 8), grid((width + 15) / 16, (height + 7) / 8, scenes);
  castKernel<<<grid, block, 0, static_cast<cudaStream_t>(stream)>>>(primitives, counts, capacity, cameras, width,
                                                                    height, depth, cls, instance, material);
  return int(cudaGetLastError());
#else
  (void)stream;
#pragma omp parallel for schedule(dynamic)
  for (int row = 0; row < scenes * height; ++row) {
    const int s = row / height, v = row % height;
    const size_t image = size_t(s) * width * height;
    for (int u = 0; u < width; ++u)
      castPixel(primitives + size_t(s) * capacity * kPrimitiveFloats, counts[s], cameras + s * kCameraFloats, u, v,
                width, height, depth + image, cls + image, instance + image, material + image);
  }
  return 0;
#endif
}
