// Things that lie and stand on tables, beds and floors and are none of the named classes, however round and soft they
// are: background. Origin of each: the middle of its underside.
#pragma once
#include "soft_things.h"

// Computer screen on its foot, facing along `yaw`.
inline void screen(Builder& b, V3 foot, float yaw) {
  Random& r = b.rnd;
  const M3 R = Rz(yaw);
  const float w = r.u(.17f, .33f), h = r.u(.13f, .22f), lift = r.u(.06f, .2f),
              thick = r.chance(.2f) ? r.u(.05f, .18f) : r.u(.01f, .035f);
  b.cylinder(foot, foot + V3{0, 0, lift + .06f}, r.u(.015f, .04f));
  if (r.chance(.5f))
    b.box(foot + V3{0, 0, .01f}, {.09f, .12f, .01f}, R);
  else
    b.cylinder(foot, foot + V3{0, 0, .02f}, .11f);
  b.loss = r.chance(.5f) ? r.u(0.f, .5f) : 0;
  b.box(foot + V3{0, 0, lift + h} + R * V3{.03f, 0, 0}, {thick, w, h}, R * Ry(r.n(.12f)));
  b.loss = 0;
}
inline void clutterOn(Builder& b, float hx, float hy, float z, int n) {  // small things, background
  Random& r = b.rnd;
  const int cls = b.cls, instance = b.instance;
  b.cls = kBackground, b.instance = 0;
  for (int k = 0; k < n; ++k) {
    const V3 c{r.u(-hx, hx), r.u(-hy, hy), z};
    const float a = r.u();
    if (a < .12f) {
      handSized(b, c, Rz(r.u(0, 2 * kPi)));
    } else if (a < .16f) {
      softThing(b, c, r.u(.12f, .45f));
    } else if (a < .19f) {
      carton(b, c, Rz(r.u(0, 3.1f)));
    } else if (a < .35f) {
      const V3 h{r.u(.02f, .14f), r.u(.02f, .14f), r.u(.01f, .13f)};
      b.box(c + V3{0, 0, h.z}, h, Rz(r.u(0, 3.1f)));
    } else if (a < .53f) {
      const float q = r.u(.02f, .07f), h = r.u(.05f, .28f);
      b.frustum(c, c + V3{0, 0, h}, q, q * r.u(.6f, 1.2f));
    } else if (a < .6f) {
      b.ellipsoid(c + V3{0, 0, .06f}, {r.u(.04f, .12f), r.u(.04f, .12f), r.u(.04f, .1f)});
    } else if (a < .82f) {  // paper, book, keyboard
      b.box(c + V3{0, 0, .012f}, {r.u(.06f, .1f), r.u(.1f, .24f), r.u(.002f, .02f)}, Rz(r.n(.5f)));
    } else if (a < .88f) {  // stack of papers, files
      float h = 0;
      for (int q = 1 + r.i(5); q > 0; --q, h += .03f)
        b.box(c + V3{r.n(.015f), r.n(.015f), h + .013f}, {.1f, .14f, .013f}, Rz(r.n(.4f)));
    } else if (a < .91f) {  // bag, cushion, bundle
      for (int q = 1 + r.i(3); q > 0; --q)
        b.ellipsoid(c + V3{r.n(.05f), r.n(.05f), .07f}, {r.u(.05f, .16f), r.u(.05f, .13f), r.u(.04f, .14f)},
                    Rz(r.u(0, 3.f)));
    } else if (a < .92f) {  // printer, appliance
      const V3 h{r.u(.12f, .22f), r.u(.15f, .25f), r.u(.07f, .18f)};
      b.box(c + V3{0, 0, h.z}, h),
          b.box(c + V3{h.x * .8f, 0, h.z * .6f}, {h.x * .6f, h.y * .7f, .01f}, Ry(r.u(-.2f, .4f)));
    } else if (a < .93f) {  // small plant
      const int own = b.cls;
      b.cls = kPlant;
      b.frustum(c, c + V3{0, 0, .1f}, .04f, .06f);
      for (int q = 0; q < 9; ++q)
        b.ellipsoid(c + V3{0, 0, .12f} + Rz(r.u(0, 6.28f)) * Ry(-r.u(.2f, 1.4f)) * V3{.1f, 0, 0}, {.09f, .025f, .02f},
                    Rz(r.u(0, 6.28f)) * Ry(-r.u(0, 1.2f)));
      b.cls = own;
    } else if (a < .96f) {  // laptop
      const M3 R = Rz(r.u(-.6f, .6f) + (r.chance(.5f) ? kPi : 0));
      b.box(c + V3{0, 0, .012f}, {.12f, .17f, .012f}, R);
      const float tilt = r.u(-.5f, .1f);
      b.box(c + R * V3{-.12f + .11f * std::sin(tilt), 0, .02f + .11f * std::cos(tilt)}, {.006f, .17f, .11f},
            R * Ry(tilt));
    } else {
      screen(b, c, r.u(-.5f, .5f) + (r.chance(.5f) ? kPi : 0));
    }
  }
  b.cls = cls, b.instance = instance;
}
