// People: a skeleton with joint limits and proportions from anthropometry (shares of the body height), fleshed out with
// tapered capsules and ellipsoids, clothed.
#pragma once
#include "scene.h"

enum class Posture { Stand, Walk, Bend, Sit, Kneel, Lie, Push, Reach };

struct JointAngles {  // radians; [0] left, [1] right
  float pelvisPitch = 0, pelvisRoll = 0, spinePitch = 0, spineRoll = 0, spineTwist = 0, neckPitch = 0, neckYaw = 0,
        neckRoll = 0;
  float hipFlex[2] = {0, 0}, hipAbduct[2] = {.05f, .05f}, hipTurn[2] = {.1f, .1f}, knee[2] = {.05f, .05f},
        ankle[2] = {0, 0};
  float shoulderFlex[2] = {0, 0}, shoulderAbduct[2] = {.12f, .12f}, shoulderTurn[2] = {0, 0}, elbow[2] = {.2f, .2f};
};

struct PersonStyle {
  float height, girth, headScale, legLoose, armLoose, shoulder, belly;
  int hair, coat,
      bag;  // hair 0 short 1 long 2 none 3 bun 4 cap 5 hood; coat 0 none 1 short 2 to the knee 3 skirt 4 gown
  bool bust;
  float hairLoss, clothLoss;

  static PersonStyle sample(Random& r) {
    PersonStyle s;
    const float a = r.u();
    s.height = a < .12f ? r.u(1.0f, 1.45f) : r.u(1.5f, 1.98f);
    s.headScale = s.height < 1.45f ? r.u(1.1f, 1.28f) : r.u(.95f, 1.08f);
    s.girth = r.chance(.25f) ? r.u(1.1f, 1.4f) : r.u(.86f, 1.14f);
    s.belly = r.chance(.2f) ? r.u(1.1f, 1.5f) : r.u(.9f, 1.1f);
    s.shoulder = r.u(.92f, 1.12f);
    s.legLoose = r.chance(.4f) ? r.u(1.15f, 1.5f) : r.u(1.f, 1.15f);
    s.armLoose = r.chance(.4f) ? r.u(1.15f, 1.5f) : r.u(1.f, 1.15f);
    const float h = r.u();
    s.hair = h < .5f ? 0 : h < .68f ? 1 : h < .78f ? 2 : h < .87f ? 3 : h < .95f ? 4 : 5;
    const float c = r.u();
    s.coat = c < .6f ? 0 : c < .7f ? 1 : c < .8f ? 2 : c < .9f ? 3 : 4;
    s.bag = r.chance(.12f) ? 1 + r.i(3) : 0;
    s.bust = r.chance(.45f);
    s.hairLoss = r.chance(.4f) ? r.u(.2f, 1.f) : 0;
    s.clothLoss = r.chance(.25f) ? r.u(.05f, .75f) : 0;
    return s;
  }
};

inline JointAngles samplePose(Random& r, Posture posture) {
  JointAngles j;
  auto limit = [](float v, float lo, float hi) { return std::min(std::max(v, lo), hi); };
  j.neckPitch = r.n(.2f), j.neckYaw = r.n(.4f), j.neckRoll = r.n(.08f);
  j.spinePitch = r.n(.07f) + .03f, j.spineRoll = r.n(.05f), j.spineTwist = r.n(.12f);
  for (int k = 0; k < 2; ++k) {
    j.hipAbduct[k] = limit(.06f + r.n(.05f), -.05f, .4f), j.hipTurn[k] = .12f + r.n(.12f);
    j.shoulderFlex[k] = r.n(.12f), j.shoulderAbduct[k] = limit(.14f + r.n(.09f), 0, 1), j.shoulderTurn[k] = r.n(.25f);
    j.elbow[k] = limit(.25f + r.n(.2f), 0, 2.4f);
  }
  auto arms = [&](int kind) {
    for (int k = 0; k < 2; ++k) {
      switch (kind) {
        case 1:  // folded before the chest
          j.shoulderFlex[k] = r.u(.4f, .7f), j.shoulderAbduct[k] = r.u(.1f, .35f), j.elbow[k] = r.u(1.6f, 2.f),
          j.shoulderTurn[k] = r.u(.9f, 1.4f);
          break;
        case 2:  // hands on the hips
          j.shoulderFlex[k] = r.u(-.5f, -.1f), j.shoulderAbduct[k] = r.u(.5f, .9f), j.elbow[k] = r.u(1.2f, 1.9f),
          j.shoulderTurn[k] = r.u(.6f, 1.2f);
          break;
        case 3:  // something held before the body
          j.shoulderFlex[k] = r.u(.1f, .7f), j.shoulderAbduct[k] = r.u(0.f, .3f), j.elbow[k] = r.u(1.f, 1.8f),
          j.shoulderTurn[k] = r.u(-.1f, .7f);
          break;
        case 4:  // anything
          j.shoulderFlex[k] = r.u(-.6f, 2.6f), j.shoulderAbduct[k] = r.u(0.f, 1.5f), j.elbow[k] = r.u(0.f, 2.3f),
          j.shoulderTurn[k] = r.u(-.8f, 1.3f);
          break;
        case 5:  // one arm busy, the other hangs
          if (k == 0)
            j.shoulderFlex[k] = r.u(.2f, 1.7f), j.elbow[k] = r.u(.2f, 2.2f), j.shoulderTurn[k] = r.u(-.4f, 1.f);
          break;
        case 6:  // both reach forward
          j.shoulderFlex[k] = r.u(.6f, 1.7f), j.shoulderAbduct[k] = r.u(0.f, .4f), j.elbow[k] = r.u(0.f, .9f),
          j.shoulderTurn[k] = r.u(-.2f, .4f);
          break;
      }
    }
    if (r.chance(.5f))
      std::swap(j.shoulderFlex[0], j.shoulderFlex[1]), std::swap(j.elbow[0], j.elbow[1]),
          std::swap(j.shoulderTurn[0], j.shoulderTurn[1]);
  };
  switch (posture) {
    case Posture::Stand: {
      const float a = r.u();
      arms(a < .45f ? 0 : a < .52f ? 1 : a < .6f ? 2 : a < .74f ? 3 : a < .82f ? 4 : a < .93f ? 5 : 6);
      const float shift = r.n(.06f);
      j.hipAbduct[0] += shift, j.hipAbduct[1] -= shift, j.knee[r.i(2)] = r.u(.02f, .35f);
      break;
    }
    case Posture::Walk: {
      const float phase = r.u(0, 2 * kPi), stride = r.u(.25f, .6f), swing = r.u(.1f, .6f);
      for (int k = 0; k < 2; ++k) {
        const float p = phase + (k ? kPi : 0);
        j.hipFlex[k] = .08f + stride * std::sin(p);
        const float lift = std::max(0.f, std::cos(p));  // bent while it swings forward
        j.knee[k] = .08f + r.u(.8f, 1.2f) * lift + .15f * std::max(0.f, -std::sin(p));
        j.ankle[k] = -.35f * std::max(0.f, -std::sin(p)) + .1f * lift;
        j.shoulderFlex[k] = -swing * std::sin(p) + r.n(.06f);
        j.elbow[k] = .25f + .4f * std::max(0.f, -std::sin(p)) * swing + std::fabs(r.n(.15f));
      }
      j.spinePitch += r.u(0, .12f), j.spineTwist = .12f * std::sin(phase) + r.n(.05f);
      const float a = r.u();
      if (a > .7f) arms(a < .84f ? 3 : a < .95f ? 5 : 1);
      break;
    }
    case Posture::Reach:
      arms(r.chance(.5f) ? 6 : 4);
      j.spinePitch += r.u(-.1f, .4f);
      break;
    case Posture::Bend: {
      j.pelvisPitch = r.u(.2f, .8f), j.spinePitch = r.u(.2f, .9f), j.neckPitch = r.u(-.6f, .2f);
      for (int k = 0; k < 2; ++k) j.hipFlex[k] = j.pelvisPitch + r.n(.12f), j.knee[k] = std::fabs(r.n(.35f));
      arms(r.chance(.7f) ? 6 : 5);
      break;
    }
    case Posture::Sit: {
      j.pelvisPitch = r.u(-.35f, .2f), j.spinePitch = r.u(-.05f, .5f), j.neckPitch = r.u(-.3f, .5f);
      for (int k = 0; k < 2; ++k) {
        j.hipFlex[k] = 1.45f + j.pelvisPitch + r.n(.12f), j.knee[k] = 1.5f + r.n(.25f), j.hipAbduct[k] = r.u(0, .3f);
      }
      if (r.chance(.12f)) j.hipTurn[0] = -.3f, j.hipFlex[0] += .25f, j.hipAbduct[0] = -.15f;  // legs crossed
      const float a = r.u();
      arms(a < .2f ? 0 : a < .3f ? 1 : a < .75f ? 3 : a < .9f ? 6 : 5);
      break;
    }
    case Posture::Kneel: {
      j.pelvisPitch = r.u(0, .5f), j.spinePitch = r.u(0, .6f);
      const bool squat = r.chance(.5f);
      for (int k = 0; k < 2; ++k)
        j.hipFlex[k] = (squat || k ? r.u(1.5f, 2.1f) : r.u(0.f, .5f)),
        j.knee[k] = squat ? r.u(1.9f, 2.4f) : (k ? r.u(1.4f, 1.8f) : r.u(1.4f, 2.f));
      arms(r.chance(.6f) ? 6 : 4);
      break;
    }
    case Posture::Lie: {
      j.neckPitch = r.u(0.f, .35f), j.neckYaw = r.n(.5f);
      for (int k = 0; k < 2; ++k)
        j.hipFlex[k] = r.chance(.25f) ? r.u(.2f, .9f) : r.u(0, .12f), j.knee[k] = j.hipFlex[k] * r.u(1.2f, 2.f),
        j.hipAbduct[k] = r.u(0, .2f), j.ankle[k] = .4f;
      arms(r.chance(.5f) ? 0 : r.chance(.6f) ? 3 : 1);
      break;
    }
    case Posture::Push: {
      const float phase = r.u(0, 2 * kPi), stride = r.u(.15f, .5f);
      for (int k = 0; k < 2; ++k) {
        const float p = phase + (k ? kPi : 0);
        j.hipFlex[k] = .1f + stride * std::sin(p), j.knee[k] = .1f + .9f * std::max(0.f, std::cos(p)),
        j.ankle[k] = -.3f * std::max(0.f, -std::sin(p));
        j.shoulderFlex[k] = r.u(.3f, .75f), j.elbow[k] = r.u(.4f, 1.2f), j.shoulderAbduct[k] = r.u(.1f, .3f),
        j.shoulderTurn[k] = r.u(-.1f, .3f);
      }
      j.spinePitch = r.u(.05f, .3f), j.pelvisPitch = r.u(0, .1f);
      break;
    }
  }
  return j;
}

// Builds the person; b.pose puts the pelvis-centred body frame: `seat` < 0: the lowest foot stands on the pose's
// origin, else the underside of the pelvis is `seat` above it. lying: the pelvis' back touches the origin, head towards
// +x of the pose. blanket (0..1): share of the body, from the feet, hidden under cloth of the class `blanketClass`.
inline void buildPerson(Builder& b, const PersonStyle& s, const JointAngles& j, Posture posture, float seat = -1,
                        float blanket = 0, int blanketClass = kBed, int blanketInstance = 0) {
  Random& r = b.rnd;
  const float H = s.height, g = std::sqrt(s.girth) * H, w = s.girth * H;
  const M3 Rp = Ry(j.pelvisPitch) * Rx(j.pelvisRoll);
  const M3 Rl = Rp * Rz(j.spineTwist * .4f) * Ry(j.spinePitch * .5f) * Rx(j.spineRoll * .5f);
  const M3 Rt = Rl * Rz(j.spineTwist * .6f) * Ry(j.spinePitch * .5f) * Rx(j.spineRoll * .5f);
  const V3 pelvis{0, 0, 0}, waist = pelvis + Rp * V3{0, 0, .075f * H}, chest = waist + Rl * V3{0, 0, .10f * H};
  const V3 neck = chest + Rt * V3{-.005f * H, 0, .125f * H};
  const M3 Rh = Rt * Rz(j.neckYaw) * Ry(j.neckPitch) * Rx(j.neckRoll);
  const float hs = s.headScale;
  const V3 head = neck + Rt * V3{.008f * H, 0, .03f * H} + Rh * V3{.012f * H, 0, .078f * H * hs};
  V3 hip[2], knee[2], ankle[2], toe[2], heel[2], shoulder[2], elbow[2], wrist[2], hand[2];
  M3 Rfoot[2];
  for (int k = 0; k < 2; ++k) {
    const float side = k ? -1.f : 1.f;
    hip[k] = pelvis + Rp * V3{0, side * .054f * g, -.015f * H};
    const M3 Rthigh = Rp * Rx(side * j.hipAbduct[k]) * Ry(-j.hipFlex[k]) * Rz(side * j.hipTurn[k]);
    knee[k] = hip[k] + Rthigh * V3{0, 0, -.245f * H};
    const M3 Rshank = Rthigh * Ry(j.knee[k]);
    ankle[k] = knee[k] + Rshank * V3{0, 0, -.243f * H};
    Rfoot[k] = Rshank * Ry(-j.ankle[k]);
    heel[k] = ankle[k] + Rfoot[k] * V3{-.025f * H, 0, -.022f * H};
    toe[k] = ankle[k] + Rfoot[k] * V3{.095f * H, side * .008f * H, -.027f * H};
    shoulder[k] = neck + Rt * V3{-.005f * H, side * .105f * H * s.shoulder, -.018f * H};
    const M3 Rarm = Rt * Ry(-j.shoulderFlex[k]) * Rx(side * j.shoulderAbduct[k]) * Rz(-side * j.shoulderTurn[k]);
    elbow[k] = shoulder[k] + Rarm * V3{0, 0, -.178f * H};
    const M3 Rfore = Rarm * Ry(-j.elbow[k]);
    wrist[k] = elbow[k] + Rfore * V3{0, 0, -.148f * H};
    hand[k] = wrist[k] + Rfore * Ry(r.u(-.5f, .4f)) * V3{0, 0, -.075f * H};
  }
  const Pose outer = b.pose;
  if (posture == Posture::Lie) {  // on the back: the body's up axis becomes the pose's x, its front the pose's z
    const M3 lie{{0, 0, 1}, {0, 1, 0}, {1, 0, 0}};
    M3 flip = lie;
    flip.r1 = {0, -1, 0};
    b.pose = outer * Pose{Rx(r.n(.12f)) * flip, {0, 0, .07f * w}};
  } else if (seat >= 0) {
    b.pose = outer * Pose{M3(), {0, 0, seat + .062f * H}};
  } else {
    float low = 1e9f;
    for (int k = 0; k < 2; ++k)
      low = std::min({low, toe[k].z - .014f * H, heel[k].z - .016f * H, knee[k].z - .03f * H});
    b.pose = outer * Pose{M3(), {0, 0, -low}};
  }
  // A part, or the cloth over it.
  const int cls = b.cls, instance = b.instance;
  const float along = 1.f - blanket;  // parts whose height share (0 head .. 1 feet) is beyond this are covered
  auto cover = [&](float share, float& grow) {
    const bool under = blanket > 0 && share > along;
    b.cls = under ? blanketClass : cls, b.instance = under ? blanketInstance : instance;
    grow = under ? .022f : 0;
    b.loss = under ? 0 : s.clothLoss;
  };
  float e = 0;
  const float depthTrunk = s.girth;
  cover(.55f, e);  // pelvis and trunk
  b.ellipsoid(pelvis + Rp * V3{-.008f * H, 0, .01f * H}, {.066f * w + e, .098f * g + e, .085f * H + e}, Rp);
  cover(.45f, e);
  b.ellipsoid(waist + Rl * V3{.006f * H * s.belly, 0, .01f * H}, {.062f * w * s.belly + e, .088f * g + e, .1f * H + e},
              Rl);
  cover(.3f, e);
  b.ellipsoid(chest + Rt * V3{0, 0, .025f * H}, {.066f * H * depthTrunk + e, .093f * g * s.shoulder + e, .115f * H + e},
              Rt);
  b.roundCone(shoulder[0] + Rt * V3{0, -.02f * H, 0}, neck + Rt * V3{-.004f * H, 0, -.004f * H}, .033f * g + e,
              .04f * g + e);
  b.roundCone(shoulder[1] + Rt * V3{0, .02f * H, 0}, neck + Rt * V3{-.004f * H, 0, -.004f * H}, .033f * g + e,
              .04f * g + e);
  b.roundCone(chest + Rt * V3{.01f * H, .045f * H, .055f * H}, chest + Rt * V3{.01f * H, -.045f * H, .055f * H},
              .058f * g + e, .058f * g + e);
  if (s.bust && s.height > 1.45f)
    for (float side : {-1.f, 1.f})
      b.ellipsoid(chest + Rt * V3{.05f * H, side * .042f * H, .022f * H}, {.034f * g, .034f * g, .036f * g});
  if (blanket > 0)  // the cloth spans the gap between the legs
    cover(1.f, e), b.roundCone((hip[0] + hip[1]) * .5f, (ankle[0] + ankle[1]) * .5f, .06f * w, .035f * H);
  // Neck, head, face, hair.
  cover(.1f, e);
  b.loss = 0;
  b.roundCone(neck + Rt * V3{0, 0, -.02f * H}, head + Rh * V3{-.008f * H, 0, -.03f * H}, .034f * g, .033f * H);
  b.ellipsoid(head, V3{.054f, .043f, .067f} * (H * hs), Rh);
  b.ellipsoid(head + Rh * V3{.02f * H * hs, 0, -.035f * H * hs}, V3{.033f, .034f, .034f} * (H * hs), Rh);
  b.ellipsoid(head + Rh * V3{.056f * H * hs, 0, -.01f * H * hs}, V3{.012f, .01f, .016f} * (H * hs), Rh);
  b.loss = s.hairLoss;
  const float fluff = r.u(1.04f, 1.2f);
  if (s.hair == 0) b.ellipsoid(head + Rh * V3{-.01f * H, 0, .014f * H}, V3{.05f, .046f, .06f} * (H * hs * fluff), Rh);
  if (s.hair == 1) {
    b.ellipsoid(head + Rh * V3{-.012f * H, 0, .012f * H}, V3{.052f, .05f, .062f} * (H * hs * fluff), Rh);
    b.roundCone(head + Rh * V3{-.03f * H, 0, 0}, neck + Rt * V3{-.045f * H, 0, -r.u(0.f, .1f) * H}, .048f * H * hs,
                .045f * H);
  }
  if (s.hair == 3)
    b.ellipsoid(head + Rh * V3{-.012f * H, 0, .012f * H}, V3{.05f, .045f, .06f} * (H * hs), Rh),
        b.ellipsoid(head + Rh * V3{-.055f * H, 0, .035f * H}, V3{.026f, .026f, .026f} * (H * fluff));
  if (s.hair == 4) {
    b.ellipsoid(head + Rh * V3{-.004f * H, 0, .022f * H}, V3{.058f, .048f, .055f} * (H * hs), Rh);
    if (r.chance(.5f))
      b.ellipsoid(head + Rh * V3{.06f * H * hs, 0, .028f * H * hs}, V3{.04f, .036f, .006f} * (H * hs), Rh);
  }
  if (s.hair == 5) b.ellipsoid(head + Rh * V3{-.018f * H, 0, -.005f * H}, V3{.06f, .056f, .085f} * (H * hs), Rh);
  // Arms.
  for (int k = 0; k < 2; ++k) {
    cover(posture == Posture::Lie && r.chance(.5f) ? .2f : .38f, e);
    const float L = s.armLoose, thin = std::sqrt(s.girth);
    b.roundCone(shoulder[k], elbow[k], .031f * g * std::min(L, 1.2f) + e, .0245f * g * L + e);
    const bool bare = r.chance(.4f);
    b.roundCone(elbow[k], wrist[k], .0235f * g * (bare ? 1.f : L) + e, .0165f * H * thin * (bare ? 1.f : L) + e);
    b.roundCone(wrist[k], wrist[k] + (hand[k] - wrist[k]) * .55f, .0165f * H, .021f * H);
    b.roundCone(wrist[k] + (hand[k] - wrist[k]) * .5f, hand[k], .02f * H, .012f * H);
  }
  // Legs.
  const float cuff = r.u(.9f, 1.3f);
  for (int k = 0; k < 2; ++k) {
    cover(.7f, e);
    const float L = s.legLoose;
    b.roundCone(hip[k], knee[k], .052f * g * std::min(L, 1.15f) + e, .0345f * g * std::min(L, 1.3f) + e);
    cover(.85f, e);
    const V3 calf = knee[k] + (ankle[k] - knee[k]) * .35f;
    b.roundCone(knee[k], ankle[k], .0335f * g * std::min(L, 1.3f) + e, .0235f * H * L * (L > 1.15f ? cuff : 1.f) + e);
    if (L < 1.12f) b.ellipsoid(calf, {.034f * g, .032f * g, .07f * H});
    cover(.95f, e);
    b.roundCone(heel[k], toe[k], .022f * H + e, .0175f * H + e);
    b.roundCone(ankle[k], ankle[k] + (toe[k] - ankle[k]) * .5f, .023f * H + e, .021f * H + e);
  }
  cover(.5f, e);
  b.loss = s.clothLoss;
  // Coats, skirts, gowns: elliptic cones wide enough for the legs.
  if (s.coat && posture != Posture::Lie && posture != Posture::Kneel) {
    const bool sitting = posture == Posture::Sit;
    const V3 mid = (knee[0] + knee[1]) * .5f;
    const V3 spread = knee[0] - knee[1];
    const float reach = .5f * length(spread) + .04f * w;
    if (s.coat != 3)
      b.frustum(pelvis + Rp * V3{0, 0, -.03f * H}, chest + Rt * V3{0, 0, .09f * H}, .112f * g, .104f * g * s.shoulder,
                false, .72f * std::sqrt(s.girth), Rp * V3{0, 1, 0});
    if (!sitting) {
      const float drop = s.coat == 1 ? .45f : r.u(.8f, 1.25f);
      const V3 low = pelvis + (mid - pelvis) * drop;
      const V3 sideAxis = length(spread) > .05f ? spread : Rp * V3{0, 1, 0};
      const float r1 = std::max(.105f * w, (drop > .7f ? reach : .6f * reach + .05f * w)) * r.u(1.f, 1.2f);
      b.frustum(low, pelvis + Rp * V3{0, 0, .05f * H}, r1, .1f * g, false, std::max(.62f, std::min(1.f, .1f * w / r1)),
                sideAxis);
    } else if (s.coat >= 2) {
      b.frustum(mid, pelvis + Rp * V3{0.02f * H, 0, .0f}, reach, .1f * g, false, .55f, Rp * V3{0, 1, 0});
    }
  }
  if (s.bag == 1 && posture != Posture::Lie)
    b.roundedBox(chest + Rt * V3{-.12f * H, 0, -.01f * H}, {r.u(.05f, .11f), r.u(.12f, .17f), r.u(.17f, .27f)}, .05f,
                 Rt);
  b.cls = kBackground, b.instance = 0, b.loss = 0;
  if (s.bag == 2 && posture != Posture::Lie)
    b.roundedBox(hand[0] + V3{0, 0, -r.u(.15f, .35f)}, {r.u(.1f, .22f), r.u(.03f, .09f), r.u(.1f, .2f)}, .03f,
                 Rz(r.n(.4f)));
  if (s.bag == 3 && posture != Posture::Lie)
    b.roundedBox(pelvis + Rp * V3{r.u(-.08f, .04f), .12f * g, -.02f}, {r.u(.1f, .18f), r.u(.03f, .07f), r.u(.1f, .17f)},
                 .03f, Rp);
  if (posture == Posture::Stand || posture == Posture::Walk) {  // something carried: not a person
    const V3 between = (hand[0] + hand[1]) * .5f;
    if (r.chance(.08f) && length(hand[0] - hand[1]) < .6f)
      b.box(between + V3{.05f, 0, .05f}, {r.u(.03f, .2f), r.u(.1f, .25f), r.u(.01f, .2f)}, Rz(r.n(.2f)));
  }
  b.cls = cls, b.instance = instance, b.pose = outer;
}
