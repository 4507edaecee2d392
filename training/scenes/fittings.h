// What else stands in a hospital: racks, bins, plants, sinks, toilets, curtains. Frames as in beds.h.
#pragma once
#include "small_things.h"

inline Extent storageRack(Builder& b) {
  Random& r = b.rnd;
  b.cls = kStorageRack;
  const float hx = r.u(.15f, .32f), hy = r.u(.3f, .75f), h = r.u(1.1f, 2.2f);
  const int n = 3 + r.i(4);
  const bool closed = r.chance(.45f);
  legs(b, hx, hy, h, r.u(.01f, .025f), r.chance(.5f));
  if (closed) {
    for (float y : {-hy, hy}) b.box({0, y, h / 2}, {hx, .01f, h / 2});
    if (r.chance(.7f)) b.box({-hx, 0, h / 2}, {.008f, hy, h / 2});
  }
  for (int k = 0; k < n; ++k) {
    const float z = .1f + (h - .12f) * k / (n - 1);
    b.box({0, 0, z}, {hx, hy, .012f});
    b.cls = kStorageRack;
    if (k + 1 < n && r.chance(.85f)) {  // what lies on it belongs to it
      const int m = 1 + r.i(6);
      for (int q = 0; q < m; ++q) {
        const float y = -hy + (2 * q + 1) * hy / m;
        const V3 half{r.u(.4f, .9f) * hx, r.u(.4f, .95f) * hy / m,
                      std::min(.4f * (h - .12f) / (n - 1), r.u(.03f, .2f))};
        b.box({r.u(-.1f, .1f) * hx, y, z + .012f + half.z}, half);
      }
    }
  }
  return {hx, hy, h};
}
inline Extent trashBin(Builder& b) {
  Random& r = b.rnd;
  b.cls = kTrashBin;
  const float h = r.u(.3f, .95f), q = r.u(.11f, .26f);
  const int style = r.i(4);
  if (style == 0) b.frustum({0, 0, 0}, {0, 0, h}, q * r.u(.7f, 1.f), q);
  if (style == 1)
    b.frustum({0, 0, .02f}, {0, 0, h}, q * .8f, q, true), b.cylinder({0, 0, 0}, {0, 0, r.u(.05f, .6f) * h}, q * .78f);
  if (style == 2) {
    b.box({0, 0, h / 2}, {q * r.u(.7f, 1.1f), q, h / 2}), b.box({0, 0, h}, {q * 1.05f, q * 1.05f, .03f});
    if (r.chance(.4f)) castors(b, q * .8f, q * .8f, .04f);
  }
  if (style == 3) b.cylinder({0, 0, 0}, {0, 0, h}, q), b.ellipsoid({0, 0, h}, {q, q, q * .6f});
  return {q, q, h};
}
inline Extent plant(Builder& b) {
  Random& r = b.rnd;
  b.cls = kPlant;
  const float q = r.u(.1f, .24f), h = r.u(.15f, .5f);
  b.frustum({0, 0, 0}, {0, 0, h}, q * r.u(.6f, 1.f), q);
  const int style = r.i(3), n = 14 + r.i(22);
  const float stem = style == 1 ? r.u(.3f, 1.f) : r.u(0.f, .2f), reach = r.u(.25f, .6f);
  if (stem > .2f) b.capsule({0, 0, h}, {0, 0, h + stem}, .02f);
  for (int k = 0; k < n; ++k) {
    const float az = r.u(0, 2 * kPi), el = style == 2 ? r.u(.9f, 1.5f) : r.u(-.3f, 1.4f), L = reach * r.u(.4f, 1.f);
    const M3 R = Rz(az) * Ry(-el);
    const V3 root = {r.n(.03f), r.n(.03f), h + stem * (style == 1 ? r.u(.6f, 1.f) : 1.f)};
    const V3 tip = root + R * V3{L, 0, 0};
    if (style != 2) b.capsule(root, tip, .006f);
    b.ellipsoid(root + R * V3{L * (style == 2 ? .5f : .75f), 0, 0},
                {L * (style == 2 ? .5f : .35f), r.u(.02f, style == 0 ? .1f : .05f), .008f}, R * Rx(r.n(.5f)));
    if (style == 0 && r.chance(.5f)) b.ellipsoid(tip, {.09f, .06f, .01f}, Rz(az) * Ry(r.u(.2f, 1.2f)));
  }
  return {std::max(q, reach * .6f), std::max(q, reach * .6f), h + stem + reach};
}
inline Extent sink(Builder& b) {
  Random& r = b.rnd;
  b.cls = kSink;
  const float h = r.u(.75f, .95f), hx = r.u(.18f, .28f), hy = r.u(.2f, .38f);
  if (r.chance(.6f)) {
    b.roundedBox({0, 0, h - .02f}, {hx, hy, .02f}, .015f);
    b.ellipsoid({0, 0, h - .04f}, {hx * .95f, hy * .9f, r.u(.1f, .17f)});
    for (float y : {-hy, hy}) b.box({0, y, h + .01f}, {hx, .02f, .025f});
    b.box({hx, 0, h + .01f}, {.02f, hy, .025f});
    if (r.chance(.5f)) b.frustum({-hx * .4f, 0, 0}, {-hx * .4f, 0, h - .1f}, .09f, .11f);
  } else {
    b.box({0, 0, h / 2}, {hx, hy, h / 2 - .06f});
    for (float y : {-hy, hy}) b.box({0, y, h - .03f}, {hx, .03f, .05f});
    for (float x : {-hx, hx}) b.box({x, 0, h - .03f}, {.03f, hy, .05f});
  }
  b.capsule({-hx * .8f, 0, h}, {-hx * .8f, 0, h + .2f}, .013f),
      b.capsule({-hx * .8f, 0, h + .2f}, {-hx * .1f, 0, h + .17f}, .011f);
  return {hx, hy, h};
}
inline Extent toilet(Builder& b) {
  Random& r = b.rnd;
  b.cls = kToilet;
  const float h = r.u(.38f, .46f);
  b.ellipsoid({.05f, 0, h - .12f}, {.26f, .18f, .15f}), b.frustum({-.05f, 0, 0}, {0, 0, h - .1f}, .11f, .14f);
  b.frustum({.05f, 0, h - .03f}, {.05f, 0, h + .02f}, .25f, .25f, false, .74f, {1, 0, 0});
  if (r.chance(.7f)) b.roundedBox({-.25f, 0, h + .15f}, {.09f, .19f, .19f}, .02f);
  if (r.chance(.4f)) b.box({-.14f, 0, h + .2f}, {.02f, .18f, .2f}, Ry(-.1f));
  return {.33f, .2f, h + .3f};
}
inline Extent curtain(Builder& b, float ceiling) {
  Random& r = b.rnd;
  b.cls = kCurtain;
  const float hw = r.u(.3f, 1.6f), low = r.u(.02f, .45f), high = std::min(ceiling - .02f, r.u(1.8f, 2.5f));
  const float a = r.u(.015f, .07f), k = 2 * kPi / r.u(.12f, .35f);
  b.sheet({0, 0, (low + high) / 2}, hw, (high - low) / 2, a, k, r.u(0, 6), a * r.u(0, .8f), k * r.u(.3f, 1.9f),
          Rz(kPi / 2));
  b.cls = kBackground;
  if (r.chance(.7f)) b.capsule({0, -hw - .2f, high + .02f}, {0, hw + .2f, high + .02f}, .012f);
  b.cls = kCurtain;
  return {.1f, hw, high};
}
// Toys, bags, clothes and cartons on the floor, on a crate or a stool's height: background.
inline Extent softClutter(Builder& b) {
  Random& r = b.rnd;
  float z = 0;
  if (r.chance(.4f)) {
    const V3 half{r.u(.2f, .4f), r.u(.2f, .5f), r.u(.1f, .4f)};
    b.box({0, 0, half.z}, half), z = 2 * half.z;
  }
  float top = 0;
  for (int k = 1 + r.i(4); k > 0; --k) {
    const V3 at{r.n(.12f), r.n(.12f), z};
    const float size = r.u(.25f, .9f);
    if (r.chance(.8f))
      softThing(b, at, size);
    else
      carton(b, at, Rz(r.u(0, 3.1f)));
    top = std::max(top, size);
  }
  return {.4f, .4f, z + top};
}
// Unnamed things that stand about at all heights, some as tall as people: background.
inline Extent clutter(Builder& b) {
  Random& r = b.rnd;
  b.cls = kBackground, b.instance = 0;
  const int style = r.i(12);
  if (style > 8) return softClutter(b);
  if (style < 2) {
    const V3 h{r.u(.1f, .45f), r.u(.1f, .5f), r.u(.08f, 1.f)};
    b.box({0, 0, h.z}, h);
    if (r.chance(.5f)) b.box({r.n(.1f), r.n(.1f), 2 * h.z + .15f}, {h.x * .7f, h.y * .7f, .15f}, Rz(r.n(.3f)));
    return {h.x, h.y, 2 * h.z};
  }
  if (style == 2) {
    const float q = r.u(.05f, .3f), h = r.u(.2f, 1.9f);
    b.frustum({0, 0, 0}, {0, 0, h}, q, q * r.u(.5f, 1.1f));
    if (r.chance(.4f)) b.ellipsoid({0, 0, h}, {q, q, q * r.u(.5f, 1.2f)});
    return {q, q, h};
  }
  if (style == 3) {  // coat stand, lamp
    const float h = r.u(1.4f, 1.9f);
    b.cylinder({0, 0, 0}, {0, 0, h}, .02f), b.cylinder({0, 0, 0}, {0, 0, .04f}, .18f);
    if (r.chance(.5f))
      b.frustum({0, 0, h - .1f}, {0, 0, h + .15f}, .2f, .12f, true);
    else if (r.chance(.7f))
      b.frustum({.08f, 0, h - r.u(.6f, 1.f)}, {.04f, 0, h - .05f}, .2f, .09f, false, .5f);
    return {.25f, .25f, h};
  }
  if (style == 4) {  // vending machine, refrigerator, wardrobe
    const V3 h{r.u(.28f, .45f), r.u(.3f, .6f), r.u(.7f, 1.05f)};
    b.box({0, 0, h.z}, h), b.box({h.x + .01f, 0, h.z}, {.012f, h.y * .93f, h.z * .9f});
    return {h.x, h.y, 2 * h.z};
  }
  if (style == 5) {  // sign or partition on feet
    const float h = r.u(.6f, 1.9f), hy = r.u(.2f, .8f);
    b.box({0, 0, h / 2 + .1f}, {.015f, hy, h / 2});
    for (float y : {-hy * .8f, hy * .8f}) b.box({0, y, .05f}, {.2f, .02f, .05f});
    return {.2f, hy, h};
  }
  if (style == 6) {  // appliance of several boxes and cylinders
    float z = 0;
    const int n = 2 + r.i(4);
    for (int k = 0; k < n; ++k) {
      const V3 h{r.u(.05f, .3f), r.u(.05f, .3f), r.u(.05f, .3f)};
      if (r.chance(.6f))
        b.box({r.n(.05f), r.n(.05f), z + h.z}, h, Rz(r.n(.3f)));
      else
        b.cylinder({0, 0, z}, {0, 0, z + 2 * h.z}, h.x);
      z += 2 * h.z;
    }
    return {.3f, .3f, z};
  }
  if (style == 7) {  // bags and bundles
    const int n = 1 + r.i(4);
    for (int k = 0; k < n; ++k)
      b.ellipsoid({r.n(.15f), r.n(.15f), r.u(.1f, .3f)}, {r.u(.1f, .3f), r.u(.1f, .3f), r.u(.1f, .35f)},
                  Rz(r.u(0, 3.f)));
    return {.35f, .35f, .5f};
  }
  const float h = r.u(.6f, 1.1f);  // walking frame
  for (float y : {-.25f, .25f})
    b.capsule({.2f, y, 0}, {.05f, y, h}, .012f), b.capsule({-.2f, y, 0}, {-.05f, y, h}, .012f),
        b.capsule({.05f, y, h}, {-.05f, y, h}, .014f);
  b.capsule({.05f, -.25f, h * .8f}, {.05f, .25f, h * .8f}, .012f);
  return {.25f, .28f, h};
}
