// Soft and rounded things that are no people, for all that they look like parts of some: toys, cushions, bags, clothes.
// Each is built on `at`, the middle of its underside, and turned by `R` about it. They keep the class that is set in
// `b`.
#pragma once
#include "parts.h"

// A bear, a rabbit or a doll of `size` metres from seat (or sole) to crown; it sits, stands or has fallen over.
inline void softToy(Builder& b, V3 at, float size, const M3& turn) {
  Random& r = b.rnd;
  const bool sits = r.chance(.65f), fallen = r.chance(.25f);
  const float fat = r.u(.75f, 1.2f), headSize = r.u(.8f, 1.3f), s = size;
  const M3 R = turn * (fallen ? Ry(r.sign() * r.u(.9f, 1.6f)) * Rx(r.n(.3f)) : Ry(r.u(-.35f, .15f)));
  const float lift = fallen ? .2f * s * fat : sits ? 0 : .25f * s;
  auto place = [&](V3 p) { return at + V3{0, 0, lift} + R * (p * s); };
  b.ellipsoid(place({0, 0, .27f}), V3{.18f * fat, .2f * fat, .28f} * s, R);
  const V3 head{.03f, r.n(.02f), .5f + .24f * headSize};
  b.ellipsoid(place(head), V3{.17f, .19f, .18f} * (s * headSize), R);
  if (r.chance(.7f)) b.ellipsoid(place(head + V3{.16f, 0, -.04f} * headSize), V3{.08f, .08f, .07f} * (s * headSize), R);
  const int ears = r.i(4);  // round, long, hanging, none
  for (float side : {-1.f, 1.f}) {
    const V3 ear = head + V3{0, side * .14f, .14f} * headSize;
    if (ears == 0) b.ellipsoid(place(ear), V3{.04f, .075f, .075f} * (s * headSize), R);
    if (ears == 1) b.capsule(place(ear), place(ear + V3{r.n(.05f), side * .05f, r.u(.15f, .35f)}), .045f * s);
    if (ears == 2) b.capsule(place(ear), place(ear + V3{0, side * .1f, -r.u(.15f, .3f)}), .05f * s);
    const V3 shoulder{.02f, side * .17f * fat, .44f};
    const V3 paw = shoulder + V3{r.u(0.f, .3f), side * r.u(0.f, .22f), r.u(-.3f, .08f)};
    b.roundCone(place(shoulder), place(paw), .075f * s * fat, .07f * s);
    const V3 hip{.05f, side * .13f * fat, .1f};
    const V3 foot = sits ? V3{r.u(.28f, .45f), side * r.u(.15f, .3f), .08f} : V3{.05f, side * .13f, -.2f};
    b.roundCone(place(hip), place(foot), .1f * s * fat, .085f * s);
    if (r.chance(.5f)) b.ellipsoid(place(foot + V3{.03f, 0, .04f}), V3{.06f, .08f, .1f} * s, R);
  }
}

inline void cushion(Builder& b, V3 at, const M3& turn) {
  Random& r = b.rnd;
  const float half = r.u(.16f, .3f), thick = r.u(.05f, .1f);
  const M3 R = turn * (r.chance(.5f) ? Ry(r.u(1.f, 1.5f)) : Ry(r.n(.15f)));  // leans, or lies
  const V3 c = at + V3{0, 0, .02f + std::fabs(R.r2.x) * half + std::fabs(R.r2.z) * thick};
  if (r.chance(.5f))
    b.ellipsoid(c, {half, half * r.u(.9f, 1.5f), thick}, R);
  else
    b.roundedBox(c, {half, half * r.u(.9f, 1.5f), thick}, thick * .9f, R);
}

// A rucksack, a shopping bag, a handbag or a bin bag.
inline void bag(Builder& b, V3 at, const M3& turn) {
  Random& r = b.rnd;
  const int style = r.i(4);
  if (style == 0) {
    const V3 half{r.u(.07f, .13f), r.u(.12f, .18f), r.u(.18f, .27f)};
    const M3 R = turn * Ry(r.u(-.3f, .5f));
    const V3 c = at + V3{0, 0, half.z};
    b.roundedBox(c, half, .06f, R);
    b.roundedBox(c + R * V3{half.x, 0, -.4f * half.z}, {.04f, half.y * .75f, half.z * .5f}, .035f, R);
    for (float side : {-.5f, .5f})
      b.capsule(c + R * V3{-half.x, side * half.y, half.z * .8f},
                c + R * V3{-half.x - .06f, side * half.y, -.6f * half.z}, .018f);
  } else if (style == 1) {
    const float w = r.u(.12f, .22f), h = r.u(.2f, .4f);
    b.frustum(at, at + turn * V3{r.n(.03f), r.n(.03f), h}, w, w * r.u(.6f, 1.1f), true, r.u(.3f, .8f), turn.r0);
    for (float side : {-.3f, .3f}) {
      const V3 top = at + V3{0, 0, h + r.u(.06f, .16f)};
      b.capsule(at + turn * V3{side * w, .5f * w, h}, top, .008f),
          b.capsule(at + turn * V3{side * w, -.5f * w, h}, top, .008f);
    }
  } else if (style == 2) {
    const V3 half{r.u(.05f, .12f), r.u(.13f, .25f), r.u(.08f, .16f)};
    b.roundedBox(at + V3{0, 0, half.z}, half, .05f, turn);
    const V3 top = at + turn * V3{0, 0, 2 * half.z + r.u(.02f, .15f)};
    for (float side : {-.6f, .6f}) b.capsule(at + turn * V3{0, side * half.y, 2 * half.z - .02f}, top, .012f);
  } else {
    const float q = r.u(.15f, .28f);
    b.ellipsoid(at + V3{0, 0, q * .8f}, {q, q * r.u(.8f, 1.2f), q * .85f}, turn);
    b.frustum(at + V3{0, 0, q * 1.4f}, at + V3{r.n(.05f), r.n(.05f), q * 2.1f}, q * .45f, q * .15f);
    for (int k = 0; k < 3; ++k)
      b.ellipsoid(at + turn * V3{r.n(.6f) * q, r.n(.6f) * q, q * r.u(.3f, 1.f)}, V3{1, 1, 1} * (q * r.u(.3f, .6f)));
  }
}

// Clothes, blankets, towels: dropped, or folded.
inline void clothes(Builder& b, V3 at, float reach, const M3& turn) {
  Random& r = b.rnd;
  if (r.chance(.3f)) {
    float z = 0;
    for (int k = 1 + r.i(4); k > 0; --k) {
      const float h = r.u(.015f, .05f);
      b.roundedBox(at + V3{r.n(.02f), r.n(.02f), z + h}, {reach * r.u(.6f, .9f), reach * r.u(.5f, .8f), h}, .02f,
                   turn * Rz(r.n(.2f)));
      z += 2 * h;
    }
    return;
  }
  for (int k = 3 + r.i(6); k > 0; --k) {
    const V3 c = at + turn * V3{r.n(.4f) * reach, r.n(.4f) * reach, r.u(0.f, .35f) * reach};
    if (r.chance(.6f))
      b.ellipsoid(c, {reach * r.u(.3f, .8f), reach * r.u(.15f, .5f), reach * r.u(.1f, .35f)},
                  Rz(r.u(0, 3.1f)) * Ry(r.n(.4f)));
    else
      b.roundCone(c, c + V3{r.n(.5f) * reach, r.n(.5f) * reach, r.n(.12f) * reach}, reach * r.u(.1f, .25f),
                  reach * r.u(.06f, .2f));
  }
}

// A carton: shut, or with its four flaps up.
inline void carton(Builder& b, V3 at, const M3& turn) {
  Random& r = b.rnd;
  const V3 half{r.u(.08f, .25f), r.u(.08f, .3f), r.u(.05f, .2f)};
  const V3 c = at + V3{0, 0, half.z};
  if (r.chance(.5f)) return b.box(c, half, turn);
  b.box(at + V3{0, 0, .01f}, {half.x, half.y, .01f}, turn);
  for (float side : {-1.f, 1.f}) {
    b.box(c + turn * V3{side * half.x, 0, 0}, {.005f, half.y, half.z}, turn);
    b.box(c + turn * V3{0, side * half.y, 0}, {half.x, .005f, half.z}, turn);
    const float a = r.u(-.5f, 1.4f), f = half.x * .8f;
    b.box(c + turn * V3{side * (half.x + f * std::sin(a)), 0, half.z + f * std::cos(a)}, {.004f, half.y, f},
          turn * Ry(side * a));
  }
  if (r.chance(.5f)) b.box(at + V3{0, 0, half.z * .6f}, {half.x * .9f, half.y * .9f, half.z * .5f}, turn);
}

// Mugs, bottles, balls, controllers, head sets, lamps: what a hand holds.
inline void handSized(Builder& b, V3 at, const M3& turn) {
  Random& r = b.rnd;
  switch (r.i(8)) {
    case 0: {  // mug
      const float q = r.u(.035f, .05f), h = r.u(.08f, .12f);
      b.frustum(at, at + V3{0, 0, h}, q * .9f, q, true), b.cylinder(at, at + V3{0, 0, h * r.u(.1f, .8f)}, q * .85f);
      b.annulus(at + turn * V3{q * 1.3f, 0, h * .5f}, turn * V3{0, 1, 0}, h * .22f, h * .36f);
      break;
    }
    case 1: {  // bottle
      const float q = r.u(.025f, .06f), h = r.u(.12f, .26f);
      b.cylinder(at, at + V3{0, 0, h}, q), b.frustum(at + V3{0, 0, h}, at + V3{0, 0, h * 1.3f}, q, q * .35f);
      break;
    }
    case 2: {  // balls, fruit
      for (int k = 1 + r.i(5); k > 0; --k) {
        const float q = r.u(.025f, .11f);
        b.ellipsoid(at + V3{r.n(.1f), r.n(.1f), q}, V3{q, q * r.u(.8f, 1.2f), q * r.u(.8f, 1.1f)}, turn);
      }
      break;
    }
    case 3: {  // controller
      for (float side : {-1.f, 1.f})
        b.roundCone(at + turn * V3{.02f, side * .05f, .03f}, at + turn * V3{-.05f, side * .07f, .02f}, .032f, .02f);
      b.roundedBox(at + V3{0, 0, .03f}, {.035f, .06f, .02f}, .015f, turn);
      break;
    }
    case 4: {  // head set
      const M3 R = turn * Rx(r.u(0.f, 1.6f));
      b.annulus(at + V3{0, 0, .08f}, R * V3{1, 0, 0}, .075f, .095f);
      for (float side : {-1.f, 1.f})
        b.ellipsoid(at + V3{0, 0, .07f} + R * V3{0, side * .085f, -.03f}, {.035f, .025f, .04f}, R);
      break;
    }
    case 5: {  // lamp
      const V3 elbow = at + turn * V3{r.u(-.15f, .05f), 0, r.u(.25f, .4f)};
      const V3 head = elbow + turn * V3{r.u(.1f, .3f), 0, r.u(-.05f, .2f)};
      b.cylinder(at, at + V3{0, 0, .02f}, .09f), b.capsule(at, elbow, .01f), b.capsule(elbow, head, .01f);
      b.frustum(head + V3{0, 0, .05f}, head - V3{0, 0, .07f}, .03f, .09f, true);
      break;
    }
    case 6: {  // crumpled paper, cables
      for (int k = 3 + r.i(5); k > 0; --k) {
        const V3 c = at + V3{r.n(.08f), r.n(.08f), .01f};
        b.capsule(c, c + V3{r.n(.1f), r.n(.1f), std::fabs(r.n(.02f))}, r.u(.004f, .02f));
      }
      break;
    }
    default: {  // figure, vase, trophy
      const float s = r.u(.1f, .3f);
      b.frustum(at, at + V3{0, 0, .6f * s}, .25f * s, r.u(.08f, .3f) * s),
          b.ellipsoid(at + V3{0, 0, .75f * s}, V3{.2f, .2f, .25f} * s);
    }
  }
}

// Any of them, `size` (about 0.1 to 0.4 m) setting the bigger ones.
inline void softThing(Builder& b, V3 at, float size) {
  Random& r = b.rnd;
  const M3 turn = Rz(r.u(0, 2 * kPi));
  const float a = r.u();
  if (a < .4f)
    softToy(b, at, size * r.u(.7f, 1.5f), turn);
  else if (a < .55f)
    cushion(b, at, turn);
  else if (a < .75f)
    bag(b, at, turn);
  else
    clothes(b, at, size * r.u(.5f, 1.f), turn);
}
