// What things are put together from: castors, legs, rails. All in the local frame of b.pose, metres.
#pragma once
#include "scene.h"

struct Extent {
  float x, y, z;
};

inline void castors(Builder& b, float hx, float hy, float r = .05f) {
  for (float x : {-hx, hx})
    for (float y : {-hy, hy}) b.wheel({x, y, r}, r, .03f);
}
inline void legs(Builder& b, float hx, float hy, float h, float thick, bool round) {
  for (float x : {-hx, hx})
    for (float y : {-hy, hy}) {
      if (round)
        b.cylinder({x, y, 0}, {x, y, h}, thick);
      else
        b.box({x, y, h / 2}, {thick, thick, h / 2});
    }
}
// Rail: two or more horizontal tubes with posts, in the plane y = const from x0 to x1.
inline void rail(Builder& b, V3 a, V3 c, float height, float r, int bars, int posts) {
  for (int k = 0; k < bars; ++k) {
    const V3 up{0, 0, height * (bars == 1 ? 1.f : float(k) / (bars - 1))};
    b.capsule(a + up, c + up, r);
  }
  for (int k = 0; k < posts; ++k) {
    const V3 p = a + (c - a) * (posts == 1 ? .5f : float(k) / (posts - 1));
    b.capsule(p, p + V3{0, 0, height}, r);
  }
}
