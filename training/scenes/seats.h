// Chairs, couches, benches and wheelchairs. Frames as in beds.h; seats report where one sits.
#pragma once
#include "people.h"
#include "small_things.h"

// Seats report where one sits.
// A coat hung over the back of a chair, from `foot` along Rb: it stays part of the chair.
inline void coatOver(Builder& b, V3 foot, const M3& Rb, float height, float halfWidth) {
  Random& r = b.rnd;
  const float drop = height * r.u(.5f, 1.2f), thick = r.u(.03f, .07f);
  b.roundedBox(foot + Rb * V3{-.02f, 0, height - drop / 2 + .03f}, {thick, halfWidth * r.u(.9f, 1.15f), drop / 2}, .03f,
               Rb);
  b.roundCone(foot + Rb * V3{-.01f, -halfWidth, height - .02f}, foot + Rb * V3{-.01f, halfWidth, height - .02f},
              thick * 1.2f, thick * 1.2f);
  for (float side : {-1.f, 1.f})
    if (r.chance(.6f))
      b.roundCone(foot + Rb * V3{-.02f, side * halfWidth, height - .05f},
                  foot + Rb * V3{-.02f, side * (halfWidth + .03f), height - r.u(.3f, .55f)}, .05f, .035f);
}
// A toy, a bag, a cushion on a seat, which is then taken (*seatHeight = 0): background.
inline void thingOnSeat(Builder& b, V3 at, float* seatHeight) {
  const int cls = b.cls, instance = b.instance;
  b.cls = kBackground, b.instance = 0;
  softThing(b, at, b.rnd.u(.25f, .6f));
  b.cls = cls, b.instance = instance;
  if (seatHeight) *seatHeight = 0;
}

inline Extent chair(Builder& b, float* seatHeight, int styleWanted = -1) {
  Random& r = b.rnd;
  b.cls = kChair;
  const int style = styleWanted >= 0 ? styleWanted : r.i(6);
  float h = r.u(.4f, .5f), hw = r.u(.2f, .28f), hd = r.u(.2f, .26f), backTop = r.u(.75f, 1.05f);
  const float lean = r.u(0, .28f);
  const M3 Rb = Ry(-lean);
  const bool soft = r.chance(.5f);
  auto slab = [&](V3 c, V3 half, const M3& R = M3()) {
    if (soft)
      b.roundedBox(c, {half.x, half.y, std::max(half.z, .03f)}, .03f, R);
    else
      b.box(c, half, R);
  };
  auto backrest = [&](float low, float thick) {
    const float mid = (low + backTop) / 2, half = (backTop - low) / 2;
    const V3 c = V3{-hd, 0, h} + Rb * V3{0, 0, mid - h};
    if (soft)
      b.roundedBox(c, {thick, hw * .95f, half}, .03f, Rb);
    else
      b.box(c, {thick, hw * .95f, half}, Rb);
  };
  auto armrests = [&](bool posts) {
    const float ah = h + r.u(.16f, .27f), t = r.u(.012f, .03f);
    for (float y : {-hw - .02f, hw + .02f}) {
      b.box({r.u(-.04f, .04f), y, ah}, {hd * r.u(.6f, 1.f), t * 1.4f, t});
      if (posts)
        b.capsule({hd * .6f, y, 0}, {hd * .6f, y, ah}, .013f), b.capsule({-hd * .8f, y, h}, {-hd * .8f, y, ah}, .013f);
      else
        b.capsule({0, y * .9f, h}, {0, y, ah}, .018f);
    }
  };
  switch (style) {
    case 0: {  // four legs
      legs(b, hd * .9f, hw * .9f, h, r.u(.01f, .024f), r.chance(.6f));
      slab({0, 0, h}, {hd, hw, r.u(.012f, .04f)});
      if (r.chance(.25f)) {  // slats
        for (float y : {-hw * .9f, hw * .9f}) b.capsule({-hd, y, h}, V3{-hd, y, h} + Rb * V3{0, 0, backTop - h}, .015f);
        const int n = 1 + r.i(4);
        for (int k = 0; k < n; ++k)
          b.box(V3{-hd, 0, h} + Rb * V3{0, 0, (backTop - h) * (1 - .22f * k) - .05f}, {.01f, hw * .9f, r.u(.02f, .06f)},
                Rb);
      } else {
        for (float y : {-hw * .8f, hw * .8f})
          b.capsule({-hd, y, h}, V3{-hd, y, h} + Rb * V3{0, 0, backTop - h - .05f}, .012f);
        backrest(h + r.u(.02f, .22f), r.u(.01f, .03f));
      }
      if (r.chance(.5f)) armrests(true);
      break;
    }
    case 1: {  // office chair
      h = r.u(.42f, .58f), backTop = h + r.u(.35f, .75f);
      const float turn = r.u(0, 6.28f);
      for (int k = 0; k < 5; ++k) {
        const V3 tip = Rz(turn + k * 1.2566f) * V3{r.u(.26f, .33f), 0, .07f};
        b.roundCone({0, 0, .12f}, tip, .03f, .02f), b.ellipsoid(tip - V3{0, 0, .04f}, {.03f, .03f, .03f});
      }
      b.cylinder({0, 0, .1f}, {0, 0, h}, .028f);
      b.roundedBox({0, 0, h}, {hd, hw, r.u(.035f, .06f)}, .03f);
      const float low = h + r.u(.05f, .2f);
      b.capsule({-hd * .6f, 0, h - .02f}, {-hd - .03f, 0, h + .03f}, .03f),
          b.capsule({-hd - .03f, 0, h + .02f}, V3{-hd, 0, h} + Rb * V3{-.03f, 0, low - h + .1f}, .025f);
      b.roundedBox(V3{-hd, 0, h} + Rb * V3{0, 0, (low + backTop) / 2 - h},
                   {.035f, hw * r.u(.75f, 1.f), (backTop - low) / 2}, .03f, Rb);
      if (r.chance(.6f)) armrests(false);
      break;
    }
    case 2: {  // armchair, recliner
      h = r.u(.38f, .48f), hw = r.u(.26f, .36f), hd = r.u(.26f, .36f), backTop = r.u(.8f, 1.2f);
      const float arm = r.u(.05f, .11f), ah = h + r.u(.12f, .25f), clear = r.chance(.5f) ? .12f : 0;
      b.roundedBox({0, 0, (h + clear) / 2}, {hd, hw, (h - clear) / 2}, .05f);
      if (clear > 0) legs(b, hd * .8f, hw * .8f, .14f, .02f, true);
      for (float y : {-hw - arm, hw + arm})
        b.roundedBox({0, y, (ah + clear) / 2}, {hd * .95f, arm, (ah - clear) / 2}, .04f);
      b.roundedBox(V3{-hd, 0, h} + Rb * V3{0, 0, (backTop - h) / 2 - .1f},
                   {r.u(.06f, .11f), hw * 1.05f, (backTop - h) / 2 + .1f}, .05f, Rb);
      if (r.chance(.2f)) b.roundedBox({hd + .2f, 0, h - .05f}, {.2f, hw * .8f, .05f}, .04f, Ry(r.u(0, .5f)));
      hw += 2 * arm;
      break;
    }
    case 3: {  // cantilever
      for (float y : {-hw * .95f, hw * .95f}) {
        b.capsule({-hd, y, .015f}, {hd, y, .015f}, .013f), b.capsule({hd, y, .015f}, {hd, y, h}, .013f),
            b.capsule({hd, y, h}, {-hd, y, h}, .013f);
        b.capsule({-hd, y, h}, V3{-hd, y, h} + Rb * V3{0, 0, backTop - h}, .013f);
      }
      b.capsule({-hd, -hw, .015f}, {-hd, hw, .015f}, .013f);
      slab({0, 0, h}, {hd, hw, .02f}), backrest(h + r.u(.05f, .25f), .015f);
      if (r.chance(.6f)) armrests(false);
      break;
    }
    case 4: {  // shell
      for (float x : {-hd * .9f, hd * .9f})
        for (float y : {-hw, hw}) b.capsule({x * 1.1f, y * 1.1f, 0}, {x * .6f, y * .6f, h}, .013f);
      b.ellipsoid({0, 0, h + .03f}, {hd, hw, .05f});
      b.ellipsoid(V3{-hd * .9f, 0, h} + Rb * V3{0, 0, .2f}, {.045f, hw, .22f}, Rb);
      backTop = h + .42f;
      break;
    }
    default: {  // stool
      h = r.u(.42f, .7f), hw = hd = r.u(.15f, .2f), backTop = h;
      b.cylinder({0, 0, h - r.u(.03f, .08f)}, {0, 0, h}, hd);
      if (r.chance(.6f)) {
        for (int k = 0; k < 5; ++k) {
          const V3 tip = Rz(k * 1.2566f) * V3{.26f, 0, .06f};
          b.roundCone({0, 0, .1f}, tip, .025f, .02f), b.ellipsoid(tip - V3{0, 0, .03f}, {.03f, .03f, .03f});
        }
        b.cylinder({0, 0, .1f}, {0, 0, h - .04f}, .028f);
      } else
        legs(b, hd * .75f, hd * .75f, h - .03f, .015f, true);
    }
  }
  if (seatHeight) *seatHeight = h + .02f;
  if (backTop > h + .2f && r.chance(.12f)) coatOver(b, {-hd, 0, h}, Rb, backTop - h, hw);
  if (r.chance(.08f)) thingOnSeat(b, {0, 0, h + .03f}, seatHeight);
  return {hd + .08f, hw + .05f, backTop};
}

inline Extent couch(Builder& b, float* seatHeight, float* halfWidth) {
  Random& r = b.rnd;
  b.cls = kCouch;
  const float hw = r.u(.6f, 1.25f), hd = r.u(.34f, .48f), h = r.u(.36f, .48f), backTop = r.u(.7f, 1.f),
              arm = r.u(.06f, .16f), ah = r.chance(.35f) ? backTop - r.u(0.f, .05f) : h + r.u(.08f, .25f);
  const float clear = r.chance(.4f) ? r.u(.06f, .14f) : 0;
  b.roundedBox({0, 0, (h - .1f + clear) / 2}, {hd, hw, (h - .1f - clear) / 2 + .01f}, .03f);
  if (clear > 0) legs(b, hd * .85f, hw * .92f, clear + .02f, .025f, r.chance(.5f));
  const int cushions = hw < .75f ? 2 : 2 + r.i(2);
  for (int k = 0; k < cushions; ++k) {
    const float w = hw / cushions, y = -hw + w * (2 * k + 1);
    b.roundedBox({.05f, y, h - .05f}, {hd - .05f, w * .98f, .07f}, .05f);
    b.roundedBox({-hd + .14f, y, (h + backTop) / 2 - .03f}, {.09f, w * .97f, (backTop - h) / 2}, .06f,
                 Ry(-r.u(.05f, .25f)));
  }
  b.roundedBox({-hd + .06f, 0, backTop / 2}, {.08f, hw, backTop / 2 - .03f}, .04f);
  if (r.chance(.85f))
    for (float y : {-hw - arm * .7f, hw + arm * .7f})
      b.roundedBox({0, y, (ah + clear) / 2}, {hd, arm, (ah - clear) / 2}, .05f);
  *seatHeight = h + .02f, *halfWidth = hw * .8f;
  for (int k = r.i(4); k > 0; --k) cushion(b, {-hd * .3f, r.u(-.8f, .8f) * hw, h}, Rz(r.n(.3f)));
  if (r.chance(.2f)) thingOnSeat(b, {.05f, r.u(-.7f, .7f) * hw, h + .03f}, seatHeight);
  return {hd + .02f, hw + arm * 1.7f, backTop};
}

inline Extent bench(Builder& b, float* seatHeight, float* halfWidth) {
  Random& r = b.rnd;
  b.cls = kBench;
  const float hw = r.u(.55f, 1.3f), hd = r.u(.18f, .27f), h = r.u(.4f, .5f);
  const bool back = r.chance(.55f), seats = r.chance(.4f);
  const int n = std::max(2, int(hw / .27f));
  if (seats)
    for (int k = 0; k < n; ++k) {
      const float w = hw / n, y = -hw + w * (2 * k + 1);
      b.roundedBox({0, y, h}, {hd, w * .9f, .025f}, .02f),
          b.roundedBox({-hd, y, h + .25f}, {.02f, w * .9f, .2f}, .018f, Ry(-.2f));
      if (k && r.chance(.4f)) b.box({0, -hw + 2 * w * k, h + .2f}, {hd * .7f, .02f, .015f});
    }
  else {
    const bool slats = r.chance(.4f);
    if (slats)
      for (int k = 0; k < 4; ++k) b.box({-hd + (k + .5f) * hd / 2, 0, h}, {hd / 5, hw, .015f});
    else
      b.roundedBox({0, 0, h}, {hd, hw, r.u(.02f, .06f)}, .015f);
    if (back) b.box({-hd - .02f, 0, h + .25f}, {.015f, hw, r.u(.06f, .2f)}, Ry(-.15f));
  }
  if (seats) b.box({0, 0, h - .06f}, {.03f, hw, .03f});
  for (float y : {-hw * .8f, hw * .8f}) {
    b.box({0, y, h / 2}, {r.chance(.5f) ? .03f : hd * .9f, .025f, h / 2});
    b.box({0, y, .02f}, {hd, .025f, .02f});
    if (back && !seats) b.capsule({-hd, y, h}, {-hd - .03f, y, h + .4f}, .015f);
  }
  *seatHeight = h + .02f, *halfWidth = hw * .85f;
  return {hd + .1f, hw, h + (back || seats ? .45f : 0)};
}

inline Extent wheelchair(Builder& b, int personInstance) {
  Random& r = b.rnd;
  b.cls = kWheelchair;
  const float h = r.u(.44f, .52f), hw = r.u(.2f, .26f), hd = r.u(.2f, .24f), back = r.u(.82f, .98f),
              big = r.chance(.8f) ? r.u(.27f, .32f) : r.u(.12f, .18f);
  b.box({0, 0, h}, {hd, hw, r.u(.015f, .04f)}),
      b.box({-hd, 0, (h + back) / 2}, {.018f, hw, (back - h) / 2 - .03f}, Ry(-.08f));
  for (float side : {-1.f, 1.f}) {
    const float y = side * hw, outer = side * (hw + .06f);
    const V3 axle{-hd * .7f, outer, big};
    b.annulus(axle, {0, 1, 0}, big - r.u(.025f, .05f), big),
        b.frustum(axle - V3{0, .018f, 0}, axle + V3{0, .018f, 0}, big, big, true);
    if (r.chance(.6f)) b.annulus(axle + V3{0, side * .03f, 0}, {0, 1, 0}, big - .07f, big - .05f);
    const int spokes = r.i(3) * 3;
    for (int k = 0; k < spokes; ++k) {
      const V3 rim = axle + V3{std::cos(k * 2.f * kPi / spokes) * big, 0, std::sin(k * 2.f * kPi / spokes) * big};
      b.capsule(axle, rim, .007f);
    }
    b.cylinder(axle - V3{0, .03f, 0}, axle + V3{0, .03f, 0}, .035f);
    b.wheel({hd + .1f, y, .09f}, .09f, .03f), b.capsule({hd + .08f, y, .17f}, {hd, y, h}, .014f);
    b.capsule({-hd, y, .25f}, {-hd - .03f, y, back}, .013f),
        b.capsule({-hd - .03f, y, back}, {-hd - .14f, y, back + r.u(-.02f, .04f)}, .016f);
    const float ah = h + r.u(.18f, .25f);
    b.box({0, y * 1.06f, ah}, {hd * .8f, .025f, .018f}),
        b.capsule({hd * .7f, y * 1.05f, h}, {hd * .7f, y * 1.05f, ah}, .012f);
    if (r.chance(.6f)) b.box({0, y * 1.06f, h + .1f}, {hd * .8f, .008f, .09f});
    b.capsule({hd, y * .8f, h}, {hd + .16f, y * .8f, .14f}, .013f),
        b.box({hd + .2f, y * .55f, .12f}, {.07f, .06f, .01f}, Ry(.3f));
    b.capsule({-hd, y, .3f}, {hd, y, .3f}, .012f);
  }
  if (personInstance > 0) {
    PersonStyle s = PersonStyle::sample(r);
    s.bag = 0;
    const int own = b.instance;
    const Pose keep = b.pose;
    b.pose = keep * Pose{M3(), {-.08f, 0, 0}};
    b.cls = kPerson, b.instance = personInstance;
    buildPerson(b, s, samplePose(r, Posture::Sit), Posture::Sit, h + .02f);
    b.pose = keep, b.cls = kWheelchair, b.instance = own;
  }
  return {hd + .28f, hw + .1f, back};
}
