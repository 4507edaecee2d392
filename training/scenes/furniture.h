// Trolleys, stands, cabinets, tables and work places. Frames as in beds.h.
#pragma once
#include "small_things.h"

inline Extent trolley(Builder& b, float* handle) {
  Random& r = b.rnd;
  b.cls = kTrolley;
  const float hx = r.u(.2f, .45f), hy = r.u(.18f, .35f), h = r.u(.7f, 1.15f);
  const int style = r.i(5);
  castors(b, hx * .88f, hy * .88f, r.u(.04f, .08f));
  if (style == 0) {  // shelves between posts
    legs(b, hx, hy, h, r.u(.01f, .018f), true);
    const int n = 2 + r.i(3);
    for (int k = 0; k < n; ++k) {
      const float z = .15f + (h - .2f) * k / (n - 1);
      b.box({0, 0, z}, {hx, hy, .012f});
      if (r.chance(.5f)) b.box({0, hy, z + .04f}, {hx, .006f, .03f}), b.box({0, -hy, z + .04f}, {hx, .006f, .03f});
      if (r.chance(.6f)) clutterOn(b, hx * .7f, hy * .7f, z + .012f, 1 + r.i(5));
    }
  } else if (style == 1 || style == 2) {  // drawers
    const float low = r.u(.1f, .2f);
    b.box({0, 0, (low + h) / 2}, {hx, hy, (h - low) / 2});
    const int n = 3 + r.i(4);
    for (int k = 0; k < n; ++k) {
      const float z = low + (h - low) * (k + .5f) / n;
      b.box({hx + .008f, 0, z}, {.01f, hy * .94f, (h - low) / n * .44f}),
          b.capsule({hx + .04f, -hy * .4f, z + .02f}, {hx + .04f, hy * .4f, z + .02f}, .008f);
    }
    b.box({0, 0, h + .01f}, {hx * 1.05f, hy * 1.05f, .015f});
    if (r.chance(.4f)) rail(b, {-hx, -hy, h}, {-hx, hy, h}, r.u(.1f, .5f), .01f, 2, 2);
    clutterOn(b, hx * .7f, hy * .7f, h + .025f, r.i(5));
  } else if (style == 3) {  // computer on wheels
    b.box({0, 0, .12f}, {hx * .9f, hy * .9f, .03f}), b.cylinder({0, 0, .1f}, {0, 0, h}, r.u(.03f, .06f)),
        b.box({0, 0, h}, {hx * .8f, hy * 1.1f, .018f});
    b.box({0, 0, h + .3f}, {.025f, r.u(.2f, .28f), r.u(.13f, .17f)}, Ry(r.n(.15f))),
        b.cylinder({-.05f, 0, h}, {-.05f, 0, h + .3f}, .02f);
    if (r.chance(.5f)) b.box({.1f, 0, h + .02f}, {.07f, .2f, .01f});
  } else {  // laundry bag, waste frame
    legs(b, hx, hy, h, .012f, true);
    b.roundedBox({0, 0, h * .55f}, {hx * .92f, hy * .92f, h * .38f}, .08f);
    if (r.chance(.5f)) b.box({0, 0, h}, {hx, hy, .015f});
  }
  if (r.chance(.7f))
    b.capsule({-hx - .1f, -hy, h * .95f}, {-hx - .1f, hy, h * .95f}, .013f),
        b.capsule({-hx, -hy, h * .9f}, {-hx - .1f, -hy, h * .95f}, .01f),
        b.capsule({-hx, hy, h * .9f}, {-hx - .1f, hy, h * .95f}, .01f);
  *handle = std::min(h, 1.05f);
  return {hx + .12f, hy + .05f, h + .1f};
}

inline Extent ivStand(Builder& b) {
  Random& r = b.rnd;
  b.cls = kIvStand;
  const float h = r.u(1.5f, 2.2f), turn = r.u(0, 6.f), reach = r.u(.2f, .32f);
  const int feet = 4 + r.i(3);
  for (int k = 0; k < feet; ++k) {
    const V3 tip = Rz(turn + k * 2 * kPi / feet) * V3{reach, 0, .06f};
    b.roundCone({0, 0, .12f}, tip, .02f, .015f), b.ellipsoid(tip - V3{0, 0, .03f}, {.028f, .028f, .028f});
  }
  b.cylinder({0, 0, .08f}, {0, 0, h}, r.u(.011f, .022f));
  const int hooks = 2 + r.i(3);
  for (int k = 0; k < hooks; ++k) {
    const V3 tip = V3{0, 0, h} + Rz(turn + k * 2 * kPi / hooks) * V3{r.u(.08f, .15f), 0, .03f};
    b.capsule({0, 0, h - .02f}, tip, .006f);
    if (r.chance(.55f))
      b.roundedBox(tip - V3{0, 0, .14f}, {r.u(.015f, .04f), r.u(.04f, .07f), r.u(.08f, .13f)}, .015f, Rz(r.u(0, 6.f)));
  }
  const int pumps = r.chance(.6f) ? 1 + r.i(3) : 0;
  for (int k = 0; k < pumps; ++k)
    b.box({.06f, r.n(.02f), r.u(.75f, 1.4f)}, {r.u(.04f, .08f), r.u(.05f, .13f), r.u(.04f, .12f)}, Rz(turn));
  if (r.chance(.3f)) {  // a rack of pumps
    float z = r.u(.7f, 1.1f);
    for (int k = 2 + r.i(4); k > 0 && z < h - .2f; --k) {
      const float q = r.u(.05f, .12f);
      b.box({.06f, r.n(.02f), z + q}, {r.u(.05f, .1f), r.u(.08f, .16f), q * .95f}, Rz(turn)), z += 2 * q;
    }
  }
  return {.2f, .2f, h};
}

inline Extent patientMonitor(Builder& b) {  // on a pole: background, so that not every pole is an IV stand
  Random& r = b.rnd;
  b.cls = kBackground, b.instance = 0;
  const float h = r.u(1.f, 1.5f);
  for (int k = 0; k < 5; ++k) b.roundCone({0, 0, .1f}, Rz(k * 1.2566f) * V3{.28f, 0, .05f}, .025f, .02f);
  b.cylinder({0, 0, .08f}, {0, 0, h}, .022f),
      b.box({.06f, 0, h}, {r.u(.04f, .09f), r.u(.14f, .22f), r.u(.1f, .18f)}, Ry(r.n(.1f)));
  if (r.chance(.6f)) b.box({0, 0, h * .65f}, {.12f, .15f, .015f}), b.box({0, 0, h * .65f - .08f}, {.1f, .13f, .06f});
  return {.25f, .25f, h};
}

inline Extent cabinet(Builder& b, int cls, float hx, float hy, float h, bool wheels) {
  Random& r = b.rnd;
  b.cls = cls;
  const float low = wheels ? .09f : r.chance(.4f) ? r.u(.04f, .12f) : 0;
  b.box({0, 0, (low + h) / 2}, {hx, hy, (h - low) / 2});
  if (wheels)
    castors(b, hx * .85f, hy * .85f, .045f);
  else if (low > 0)
    legs(b, hx * .85f, hy * .85f, low, .02f, false);
  const int n = 1 + r.i(4);
  for (int k = 0; k < n; ++k) {
    const float z = low + (h - low) * (k + .5f) / n;
    b.box({hx + .007f, 0, z}, {.009f, hy * .95f, (h - low) / n * .46f});
    if (r.chance(.7f)) b.capsule({hx + .035f, -hy * .3f, z}, {hx + .035f, hy * .3f, z}, .007f);
  }
  b.box({0, 0, h}, {hx * 1.04f, hy * 1.04f, .015f});
  return {hx + .03f, hy + .02f, h};
}
inline Extent bedsideCabinet(Builder& b) {
  Random& r = b.rnd;
  const float h = r.u(.55f, .95f);
  Extent e = cabinet(b, kBedsideCabinet, r.u(.19f, .27f), r.u(.19f, .3f), h, r.chance(.6f));
  if (r.chance(.3f)) b.box({e.x * .2f, e.y + .2f, h - .02f}, {e.x * .8f, .2f, .012f});  // fold-out table
  clutterOn(b, e.x * .7f, e.y * .7f, h + .015f, r.i(6));
  return e;
}
inline Extent kitchenCabinet(Builder& b) {
  Random& r = b.rnd;
  const float hy = r.u(.3f, 1.5f), h = r.u(.82f, .95f);
  Extent e = cabinet(b, kBackground, r.u(.27f, .33f), hy, h, false);
  clutterOn(b, e.x * .6f, hy * .9f, h + .02f, r.i(8));
  b.cls = kBackground;
  if (r.chance(.6f)) b.box({-.1f, 0, r.u(1.7f, 1.9f)}, {.17f, hy, r.u(.25f, .4f)});
  return e;
}
inline Extent overbedTable(Builder& b) {
  Random& r = b.rnd;
  b.cls = kTable;
  const float h = r.u(.7f, 1.05f), hx = r.u(.18f, .25f), hy = r.u(.35f, .5f), foot = -hy * .85f;
  b.box({0, 0, h}, {hx, hy, r.u(.012f, .025f)}, Rx(r.chance(.1f) ? r.u(-.4f, .4f) : 0));
  b.box({0, foot, h / 2}, {r.u(.02f, .05f), r.u(.02f, .04f), h / 2});
  for (float x : {-hx * .9f, hx * .9f}) b.box({x, foot + hy * .8f, .07f}, {.02f, hy * .85f, .02f});
  b.box({0, foot, .07f}, {hx, .025f, .025f}), castors(b, hx * .9f, hy * .8f, .035f);
  clutterOn(b, hx * .7f, hy * .8f, h + .02f, r.i(6));
  return {hx, hy, h};
}
inline Extent table(Builder& b) {
  Random& r = b.rnd;
  b.cls = kTable;
  const float h = r.chance(.2f) ? r.u(.4f, .55f) : r.chance(.2f) ? r.u(.9f, 1.15f) : r.u(.68f, .8f);
  const float hx = r.u(.3f, .55f), hy = r.u(.35f, 1.1f), t = r.u(.01f, .03f);
  const int style = r.i(6);
  if (style == 5) {  // low, with a shelf or closed
    const float low = r.u(.35f, .55f);
    b.box({0, 0, low - t}, {hx, hy, t});
    if (r.chance(.5f))
      b.box({0, 0, low / 2}, {hx * .92f, hy * .95f, low / 2 - t});
    else
      legs(b, hx * .9f, hy * .92f, low - t, r.u(.02f, .05f), false),
          b.box({0, 0, low * .4f}, {hx * .9f, hy * .9f, .012f});
    clutterOn(b, hx * .8f, hy * .85f, low, r.i(6));
    return {hx, hy, low};
  }
  if (style == 0 || style == 1)
    b.box({0, 0, h - t}, {hx, hy, t}), legs(b, hx * .9f, hy * .92f, h - t, r.u(.015f, .04f), r.chance(.5f));
  if (style == 2) {  // panels at the ends, one behind
    b.box({0, 0, h - t}, {hx, hy, t});
    for (float y : {-hy * .93f, hy * .93f}) b.box({0, y, h / 2}, {hx * .9f, .015f, h / 2 - t});
    if (r.chance(.7f)) b.box({-hx * .8f, 0, h * .6f}, {.012f, hy * .9f, h * .3f});
    if (r.chance(.6f)) b.box({0, hy * .65f, h * .5f}, {hx * .8f, .2f, h * .42f});
  }
  if (style == 3) {  // round
    const float q = r.u(.3f, .6f);
    b.cylinder({0, 0, h - 2 * t}, {0, 0, h}, q), b.cylinder({0, 0, 0}, {0, 0, h}, r.u(.03f, .06f)),
        b.frustum({0, 0, 0}, {0, 0, .05f}, q * .6f, q * .4f);
    clutterOn(b, q * .5f, q * .5f, h, r.i(6));
    return {q, q, h};
  }
  if (style == 4) {  // counter: closed front
    b.box({0, 0, h / 2}, {hx * .9f, hy, h / 2}), b.box({0, 0, h}, {hx, hy * 1.02f, t});
    if (r.chance(.5f))
      b.box({-hx * .8f, 0, h + .15f}, {.03f, hy, .16f}), b.box({-hx * .8f, 0, h + .32f}, {.14f, hy, .015f});
  }
  clutterOn(b, hx * .8f, hy * .85f, h, r.i(9));
  return {hx, hy, h};
}
// Desks side by side, perhaps two rows back to back, with screens and all that lies about; `seats` are the places of
// those who work there (facing the desk).
inline Extent workplace(Builder& b, std::vector<Pose>& seats) {
  Random& r = b.rnd;
  const float hx = r.u(.33f, .48f), hy = r.u(.55f, .95f), h = r.u(.68f, .8f), t = r.u(.01f, .025f);
  const int columns = 1 + r.i(3), rows = r.chance(.45f) ? 2 : 1;
  const bool panel = rows == 2 && r.chance(.3f);
  const int feet = r.i(3), mess = r.i(3);
  for (int row = 0; row < rows; ++row)
    for (int k = 0; k < columns; ++k) {
      const float front = row ? -1.f : 1.f, x = rows == 2 ? front * hx : 0, y = (2 * k + 1 - columns) * hy,
                  face = row ? kPi : 0;
      b.cls = kTable;
      b.box({x, y, h - t}, {hx, hy * .995f, t});
      if (feet == 0) {
        for (float sx : {-.9f, .9f})
          for (float sy : {-.93f, .93f}) b.box({x + sx * hx, y + sy * hy, h / 2}, {.025f, .025f, h / 2 - t});
      } else {
        for (float sy : {-.93f, .93f}) b.box({x, y + sy * hy, h / 2}, {feet == 1 ? hx * .9f : .04f, .018f, h / 2 - t});
        if (r.chance(.5f)) b.box({x - front * hx * .7f, y, h * .6f}, {.012f, hy * .9f, h * .3f});
      }
      if (r.chance(.5f)) b.box({x, y + r.sign() * hy * .65f, h * .42f}, {hx * .8f, .2f, h * .4f});
      b.cls = kBackground;
      const int own = b.instance;
      b.instance = 0;
      const int screens = r.i(4);
      for (int q = 0; q < screens; ++q)
        screen(b,
               {x - front * hx * r.u(.1f, .7f),
                y + (screens == 1 ? r.n(.15f) : (q - .5f * (screens - 1)) * .5f + r.n(.03f)), h},
               face + r.n(.25f));
      if (screens && r.chance(.9f))
        b.box({x + front * hx * .45f, y + r.n(.08f), h + .012f}, {.075f, .2f, .012f}, Rz(r.n(.1f)));
      if (panel && !row) b.box({0, y, h + .2f}, {.02f, hy, .22f});
      b.instance = own;
      const Pose keep = b.pose;
      b.pose = keep * Pose{M3(), {x, y, 0}};
      b.cls = kTable;
      clutterOn(b, hx * .9f, hy * .9f, h, r.i(mess == 0 ? 5 : mess == 1 ? 14 : 26));
      b.pose = keep;
      seats.push_back(Pose{Rz(face + kPi), {x + front * (hx + r.u(.15f, .55f)), y + r.n(.12f), 0}});
    }
  return {hx * rows, hy * columns, h};
}
