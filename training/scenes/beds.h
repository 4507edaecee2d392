// Beds and stretchers, empty or with somebody in them.
// Each function builds one thing in the local frame of b.pose (origin on the floor below its middle, front = +x) and
// returns its half extent and height, which the room needs to place it.
#pragma once
#include "people.h"
#include "small_things.h"

// Board at a bed's end, standing at x, facing along x.
inline void bedBoard(Builder& b, float x, float hw, float low, float high, int style) {
  Random& r = b.rnd;
  if (style == 0) b.box({x, 0, (low + high) / 2}, {r.u(.012f, .03f), hw, (high - low) / 2});
  if (style == 1) b.roundedBox({x, 0, (low + high) / 2}, {r.u(.015f, .035f), hw, (high - low) / 2}, r.u(.01f, .1f));
  if (style == 2) {
    rail(b, {x, -hw, low}, {x, hw, low}, high - low, r.u(.012f, .02f), 2 + r.i(2), 2 + r.i(7));
  }
  if (style == 3) {  // panel between posts
    for (float y : {-hw, hw}) b.capsule({x, y, 0.1f}, {x, y, high}, .022f);
    b.box({x, 0, (low + high) / 2 + .02f}, {.012f, hw, (high - low) / 2 - .04f});
    b.capsule({x, -hw, high}, {x, hw, high}, .018f);
  }
}

inline Extent bed(Builder& b, int personInstance) {
  Random& r = b.rnd;
  const float hl = r.u(.95f, 1.1f), hw = r.u(.4f, .53f), top = r.u(.42f, .88f), thick = r.u(.1f, .22f);
  const float base = top - thick;
  b.cls = kBed;
  // Under the mattress: legs, columns, or a closed body.
  const int under = r.i(4);
  b.box({0, 0, base - .03f}, {hl, hw, r.u(.02f, .05f)});
  if (under == 0) legs(b, hl - .08f, hw - .06f, base, .025f, r.chance(.5f));
  if (under == 1) {
    b.box({0, 0, .16f}, {hl * .75f, hw * .7f, .04f}), castors(b, hl * .78f, hw * .8f, r.u(.05f, .08f));
    for (float x : {-.5f, .5f}) b.box({x * hl, 0, base / 2 + .06f}, {.07f, .09f, base / 2 - .06f}, M3());
  }
  if (under == 2) {
    castors(b, hl * .85f, hw * .85f, r.u(.05f, .08f));
    for (float y : {-hw * .6f, hw * .6f})
      b.capsule({-hl * .6f, y, .14f}, {hl * .1f, y, base}, .025f),
          b.capsule({hl * .6f, y, .14f}, {-hl * .1f, y, base}, .025f);
    b.box({0, 0, .13f}, {hl * .85f, hw * .8f, .025f});
  }
  if (under == 3) b.box({0, 0, base / 2}, {hl * .97f, hw * .95f, base / 2});
  // Head is at +x. The back part may be raised.
  const float raise = r.chance(.5f) ? r.u(.15f, .9f) : 0, split = r.u(.15f, .3f);  // split: where the back begins
  const float back = hl - split;
  b.roundedBox({(split - hl) / 2, 0, base + thick / 2}, {(split + hl) / 2, hw * .97f, thick / 2}, .04f);
  const M3 Rb = Ry(-raise);
  b.roundedBox(V3{split, 0, base + thick / 2} + Rb * V3{back / 2, 0, 0}, {back / 2 + .03f, hw * .97f, thick / 2}, .04f,
               Rb);
  const V3 pillow = V3{split, 0, base + thick / 2} + Rb * V3{back - .22f, 0, thick / 2 + .05f};
  if (r.chance(.85f)) b.ellipsoid(pillow, {.2f, r.u(.28f, .36f), r.u(.06f, .1f)}, Rb);
  const int style = r.i(4), foot = r.chance(.6f) ? style : r.i(5);
  const float headTop = top + r.u(.15f, .55f), footTop = top + r.u(.02f, .4f),
              low = r.chance(.3f) ? .12f : base - r.u(0, .2f);
  bedBoard(b, hl + .03f, hw, low, headTop, style), bedBoard(b, -hl - .03f, hw, low, footTop, foot);
  // Side rails.
  const int side = r.i(5);
  for (float y : {-hw - .03f, hw + .03f}) {
    if (side == 0 || r.chance(.15f)) continue;
    const float h = r.u(.15f, .4f);
    if (side == 1) rail(b, {-hl * .5f, y, base}, {hl * .5f, y, base}, h + thick, .014f, 2 + r.i(3), 3 + r.i(4));
    if (side == 2) b.roundedBox({hl * .45f, y, top + h / 2 - .05f}, {hl * .33f, .018f, h / 2}, .015f);
    if (side == 3)
      for (float x : {-.42f, .42f}) b.roundedBox({x * hl, y, top + h / 2 - .05f}, {hl * .33f, .02f, h / 2}, .015f);
    if (side == 4) b.box({0, y, base + .02f}, {hl * .9f, .015f, r.u(.04f, .14f)});
  }
  const bool patient = personInstance > 0;
  float covered = 0;
  if (patient) {
    PersonStyle s = PersonStyle::sample(r);
    s.height = std::min(s.height, 1.85f * hl), s.coat = 0, s.bag = 0;
    JointAngles j = samplePose(r, Posture::Lie);
    j.pelvisPitch = 0, j.spinePitch = raise * .9f;
    covered = r.chance(.8f) ? r.u(.3f, .82f) : 0;
    const Pose keep = b.pose;
    const int bedInstance = b.instance;
    b.pose = keep * Pose{Rz(r.n(.06f)), {split - .04f, r.n(.05f), top}};
    b.cls = kPerson, b.instance = personInstance;
    buildPerson(b, s, j, Posture::Lie, -1, covered, kBed, bedInstance);
    b.pose = keep, b.cls = kBed, b.instance = bedInstance;
  }
  if (!patient && r.chance(.8f)) {  // blanket: flat, rumpled, folded
    const int kind = r.i(3);
    if (kind == 0) b.roundedBox({-.25f * hl, 0, top + .01f}, {hl * .7f, hw * 1.02f, .035f}, .03f);
    if (kind == 1)
      for (int k = 0; k < 5; ++k)
        b.ellipsoid({r.u(-.8f, .3f) * hl, r.u(-.6f, .6f) * hw, top}, {r.u(.12f, .5f), r.u(.1f, .35f), r.u(.03f, .12f)},
                    Rz(r.n(.5f)));
    if (kind == 2) b.roundedBox({-.7f * hl, 0, top + .06f}, {.2f, hw * .8f, r.u(.04f, .1f)}, .03f);
  }
  if (patient && covered > .2f && r.chance(.6f))  // the blanket's sides hang over the mattress
    b.roundedBox({-.3f * hl, 0, top - .01f}, {hl * .68f, hw * 1.03f, .02f}, .015f);
  if (!patient && r.chance(.15f)) {  // a toy, a bag, clothes
    const int own = b.instance;
    b.cls = kBackground, b.instance = 0;
    softThing(b, {r.u(-.8f, .3f) * hl, r.u(-.6f, .6f) * hw, top + .02f}, r.u(.2f, .6f));
    b.cls = kBed, b.instance = own;
  }
  return {hl + .08f, hw + .06f, headTop};
}

inline Extent stretcher(Builder& b, int personInstance) {
  Random& r = b.rnd;
  const float hl = r.u(.92f, 1.05f), hw = r.u(.27f, .36f), top = r.u(.6f, .98f), thick = r.u(.05f, .12f);
  b.cls = kStretcher;
  b.box({0, 0, top - thick - .02f}, {hl, hw, .025f});
  const float raise = r.chance(.4f) ? r.u(.2f, .9f) : 0;
  b.roundedBox({-.4f * hl, 0, top - thick / 2}, {.6f * hl, hw, thick / 2}, .03f);
  b.roundedBox(V3{.2f * hl, 0, top - thick / 2} + Ry(-raise) * V3{.4f * hl, 0, 0}, {.41f * hl, hw, thick / 2}, .03f,
               Ry(-raise));
  if (r.chance(.5f)) {
    for (float x : {-.45f, .45f}) b.cylinder({x * hl, 0, .2f}, {x * hl, 0, top - thick}, r.u(.04f, .09f));
    b.box({0, 0, .17f}, {hl * .75f, hw * .8f, r.u(.02f, .07f)});
  } else {
    for (float y : {-hw * .8f, hw * .8f})
      b.capsule({-.7f * hl, y, .13f}, {.5f * hl, y, top - thick}, .018f),
          b.capsule({.7f * hl, y, .13f}, {-.5f * hl, y, top - thick}, .018f);
    b.capsule({-.7f * hl, -hw * .8f, .13f}, {-.7f * hl, hw * .8f, .13f}, .016f),
        b.capsule({.7f * hl, -hw * .8f, .13f}, {.7f * hl, hw * .8f, .13f}, .016f);
  }
  castors(b, hl * .78f, hw * .85f, r.u(.06f, .1f));
  for (float y : {-hw - .02f, hw + .02f})
    if (r.chance(.7f))
      rail(b, {-.5f * hl, y, top - .05f}, {.45f * hl, y, top - .05f}, r.u(.15f, .32f), .012f, 1 + r.i(3), 3 + r.i(4));
  for (float x : {-hl - .06f, hl + .06f})
    if (r.chance(.6f))
      b.capsule({x, -hw * .8f, top + .1f}, {x, hw * .8f, top + .1f}, .014f),
          b.capsule({x, -hw * .8f, top + .1f}, {x * .95f, -hw * .8f, top - .1f}, .014f),
          b.capsule({x, hw * .8f, top + .1f}, {x * .95f, hw * .8f, top - .1f}, .014f);
  if (r.chance(.5f))
    b.ellipsoid({.75f * hl, 0, top + .04f + .4f * hl * std::sin(raise) * 1.3f}, {.16f, hw * .8f, .06f}, Ry(-raise));
  if (personInstance > 0) {
    PersonStyle s = PersonStyle::sample(r);
    s.coat = 0, s.bag = 0;
    JointAngles j = samplePose(r, Posture::Lie);
    j.spinePitch = raise * .9f;
    const Pose keep = b.pose;
    const int own = b.instance;
    b.pose = keep * Pose{Rz(r.n(.04f)), {.12f * hl, 0, top}};
    b.cls = kPerson, b.instance = personInstance;
    buildPerson(b, s, j, Posture::Lie, -1, r.chance(.7f) ? r.u(.3f, .8f) : 0, kStretcher, own);
    b.pose = keep, b.cls = kStretcher, b.instance = own;
  }
  return {hl + .1f, hw + .05f, top + .3f};
}
