// Random rooms with furniture and people, and a camera in each.  A scene depends on its seed alone.
#include <atomic>
#include <thread>

#include "beds.h"
#include "fittings.h"
#include "furniture.h"
#include "seats.h"

namespace {

enum class RoomKind { Ward, Corridor, Waiting, Office, Bathroom, Mixed };
enum class Thing {
  Bed,
  Stretcher,
  Chair,
  Couch,
  Bench,
  Wheelchair,
  Trolley,
  IvStand,
  Bedside,
  Overbed,
  Table,
  Rack,
  Kitchen,
  Bin,
  Plant,
  Sink,
  Toilet,
  Curtain,
  Monitor,
  Clutter,
  Count
};

// How many of each thing a room of each kind gets at most, and whether it stands at the wall.
struct Habit {
  Thing thing;
  float most[6];  // Ward, Corridor, Waiting, Office, Bathroom, Mixed
  float atWall;
};
const Habit kHabits[] = {{Thing::Bed, {1.5f, .5f, 0, 0, 0, 1}, .7f},
                         {Thing::Stretcher, {1, 1.5f, .3f, 0, 0, .8f}, .6f},
                         {Thing::Chair, {5, 3, 9, 4, 1, 4}, .5f},
                         {Thing::Couch, {.6f, .8f, 3, 1, 0, 1}, .8f},
                         {Thing::Bench, {.4f, 1.2f, 2, .3f, .4f, .9f}, .8f},
                         {Thing::Wheelchair, {1.5f, 2, 1.3f, .3f, .5f, 1.3f}, .3f},
                         {Thing::Trolley, {2.4f, 2.6f, .8f, .6f, .6f, 1.8f}, .5f},
                         {Thing::IvStand, {3, 1, .3f, 0, .2f, 1}, .3f},
                         {Thing::Bedside, {1.6f, .6f, 0, .1f, 0, 1.2f}, .8f},
                         {Thing::Overbed, {2, .2f, 0, 0, 0, .8f}, .1f},
                         {Thing::Table, {.7f, .5f, 2.5f, 4, .3f, 1.5f}, .5f},
                         {Thing::Rack, {.8f, .8f, .6f, 1.6f, .5f, 1}, .9f},
                         {Thing::Kitchen, {.6f, .3f, .7f, .8f, .7f, .8f}, 1},
                         {Thing::Bin, {1.4f, 1.6f, 1.6f, 1.5f, 1.5f, 1.4f}, .7f},
                         {Thing::Plant, {.7f, 1, 2, 1, .2f, 1}, .7f},
                         {Thing::Sink, {.8f, .3f, .2f, .2f, 2, .6f}, 1},
                         {Thing::Toilet, {.2f, 0, 0, 0, 1.8f, .3f}, 1},
                         {Thing::Curtain, {2.5f, .3f, .6f, .6f, .8f, 1}, .5f},
                         {Thing::Monitor, {1.5f, .6f, .2f, .2f, .1f, .8f}, .4f},
                         {Thing::Clutter, {2.5f, 2.5f, 3, 4, 2, 4}, .5f}};

struct Placed {
  float x0, x1, y0, y1, top;
  V3 centre;
  Thing thing;
  float yaw;
};

struct Scene {
  Random rnd;
  std::vector<float> primitives;
  std::vector<Placed> placed;
  std::vector<V3> people;   // x, y, body height
  std::vector<Pose> seats;  // places before desks, facing them
  std::vector<V3> heaps;    // where small and soft things lie close together
  RoomKind kind = RoomKind::Mixed;
  float W = 0, D = 0, ceiling = 0;  // W along x, D along y
  int peopleWanted = 0, nextInstance = 1;

  explicit Scene(uint64_t seed) : rnd{seed * 0xD1342543DE82EF95ull + 77} { rnd.next(); }

  Builder builder() { return Builder{rnd, primitives, Pose{}}; }
  int newInstance() { return nextInstance < 250 ? nextInstance++ : 250; }
  int takePerson(float chance) {  // an instance id, or 0
    if (peopleWanted <= 0 || !rnd.chance(chance)) return 0;
    --peopleWanted;
    return newInstance();
  }

  // ---- the room ----
  void wall(V3 a, V3 b, bool mayOpen) {
    Builder bd = builder();
    const V3 dir = unit(b - a);  // the room is to the left of it
    const float L = length(b - a), yaw = std::atan2(dir.y, dir.x);
    bd.pose = Pose{Rz(yaw), a};
    auto piece = [&](float s0, float s1, float z0, float z1) {
      if (s1 - s0 > .01f && z1 - z0 > .01f)
        bd.box({(s0 + s1) / 2, -.06f, (z0 + z1) / 2}, {(s1 - s0) / 2, .06f, (z1 - z0) / 2});
    };
    float s = 0;
    while (mayOpen && L - s > 1.4f && rnd.chance(.6f)) {
      const bool door = rnd.chance(.55f);
      const float w = door ? rnd.u(.8f, 1.6f) : rnd.u(.7f, 2.2f),
                  from = s + rnd.u(.1f, std::max(.15f, std::min(3.f, L - s - w - .1f))), to = from + w;
      if (to > L - .1f) break;
      const float sill = door ? 0 : rnd.u(.6f, 1.1f), head = door ? rnd.u(2.f, 2.25f) : rnd.u(1.7f, ceiling - .1f);
      piece(s, from, 0, ceiling), piece(from, to, head, ceiling), piece(from, to, 0, sill);
      if (door) {
        const float f = .03f;
        bd.box({from, .01f, head / 2}, {f, .03f, head / 2}), bd.box({to, .01f, head / 2}, {f, .03f, head / 2}),
            bd.box({(from + to) / 2, .01f, head}, {w / 2, .03f, f});
        const float a0 = rnd.u();
        if (a0 < .6f) {  // closed
          bd.box({(from + to) / 2, -.05f, head / 2}, {w / 2, .02f, head / 2}),
              bd.capsule({to - .1f, .02f, 1.05f}, {to - .22f, .02f, 1.05f}, .012f);
        } else if (a0 < .8f) {  // ajar
          const float turn = rnd.u(.3f, 1.8f);
          bd.box(V3{from, 0, head / 2} + Rz(turn) * V3{w / 2, 0, 0}, {w / 2, .02f, head / 2}, Rz(turn));
        }
      } else {
        if (rnd.chance(.3f)) bd.loss = rnd.u(.3f, 1.f);
        if (rnd.chance(.6f))
          bd.box({(from + to) / 2, -.07f, (sill + head) / 2}, {w / 2, .01f, (head - sill) / 2});  // pane or blind
        bd.loss = 0;
        bd.box({(from + to) / 2, -.04f, (sill + head) / 2}, {.025f, .03f, (head - sill) / 2}),
            bd.box({(from + to) / 2, .03f, sill}, {w / 2, .1f, .02f});
      }
      s = to;
    }
    piece(s, L, 0, ceiling);
    if (rnd.chance(.35f))
      bd.box({L / 2, .04f, rnd.u(.8f, 1.f)}, {L / 2, rnd.u(.015f, .05f), rnd.u(.02f, .08f)});  // handrail
    if (rnd.chance(.4f)) bd.box({L / 2, .005f, .05f}, {L / 2, .012f, .05f});
    const int n = int(rnd.u(0, 1.2f * L));
    for (int k = 0; k < n; ++k) {  // pictures, dispensers, outlets, lamps, switch boxes, screens, wall cabinets, pipes
      const float at = rnd.u(.2f, L - .2f), z = rnd.u(.3f, ceiling - .3f);
      if (rnd.chance(.1f))
        bd.capsule({at, .06f, 0}, {at, .06f, ceiling}, rnd.u(.02f, .06f));
      else
        bd.box({at, 0, z},
               {rnd.u(.04f, .5f), rnd.chance(.75f) ? rnd.u(.005f, .06f) : rnd.u(.05f, .2f), rnd.u(.04f, .4f)});
      if (rnd.chance(.1f)) bd.cylinder({at, .12f, z}, {at, .12f, z + .45f}, .07f);
    }
  }

  void room() {
    const float k = rnd.u();
    kind = k < .3f    ? RoomKind::Ward
           : k < .47f ? RoomKind::Corridor
           : k < .63f ? RoomKind::Waiting
           : k < .79f ? RoomKind::Office
           : k < .86f ? RoomKind::Bathroom
                      : RoomKind::Mixed;
    switch (kind) {
      case RoomKind::Ward:
        W = rnd.u(3.5f, 9), D = rnd.u(3, 7);
        break;
      case RoomKind::Corridor:
        W = rnd.u(6, 20), D = rnd.u(1.8f, 3.6f);
        break;
      case RoomKind::Waiting:
        W = rnd.u(4, 14), D = rnd.u(4, 10);
        break;
      case RoomKind::Office:
        W = rnd.u(3, 8), D = rnd.u(2.8f, 6.5f);
        break;
      case RoomKind::Bathroom:
        W = rnd.u(2, 4), D = rnd.u(1.8f, 3.5f);
        break;
      default:
        W = rnd.u(2.5f, 16), D = rnd.u(2.5f, 12);
    }
    ceiling = rnd.chance(.15f) ? rnd.u(3.2f, 5.5f) : rnd.u(2.35f, 3.2f);
    Builder b = builder();
    b.loss = rnd.chance(.15f) ? rnd.u(0.f, .35f) : 0;
    b.box({0, 0, -.1f}, {30, 30, .1f});
    b.loss = 0;
    if (!rnd.chance(.06f)) b.box({0, 0, ceiling + .1f}, {30, 30, .1f});
    const V3 c[4] = {{-W / 2, -D / 2, 0}, {W / 2, -D / 2, 0}, {W / 2, D / 2, 0}, {-W / 2, D / 2, 0}};
    for (int q = 0; q < 4; ++q)
      if (!rnd.chance(.05f)) wall(c[q], c[(q + 1) % 4], true);
    // What is seen through openings: walls of the next rooms.
    for (float s : {-1.f, 1.f}) {
      if (rnd.chance(.6f)) b.box({s * (W / 2 + rnd.u(1.5f, 6)), 0, ceiling / 2}, {.05f, 30, ceiling / 2});
      if (rnd.chance(.6f)) b.box({0, s * (D / 2 + rnd.u(1.5f, 6)), ceiling / 2}, {30, .05f, ceiling / 2});
    }
    const int lamps = rnd.i(6);
    for (int q = 0; q < lamps; ++q)
      b.box({rnd.u(-W, W) / 2, rnd.u(-D, D) / 2, ceiling - rnd.u(0, .1f)}, {rnd.u(.1f, .7f), rnd.u(.1f, .4f), .04f});
    if (rnd.chance(.3f)) {  // pillar or chimney
      const V3 at{rnd.u(-W, W) * .45f, rnd.u(-D, D) * .45f, 0};
      const float q = rnd.u(.1f, .35f);
      if (rnd.chance(.4f))
        b.cylinder(at, at + V3{0, 0, ceiling}, q);
      else
        b.box(at + V3{0, 0, ceiling / 2}, {q, rnd.u(.1f, .5f), ceiling / 2});
      placed.push_back({at.x - q, at.x + q, at.y - q, at.y + q, ceiling, at, Thing::Clutter, 0});
    }
    if (kind != RoomKind::Corridor && rnd.chance(.2f)) {  // partition
      const float x = rnd.u(-.3f, .3f) * W, L = rnd.u(.3f, .7f) * D, side = rnd.sign();
      b.box({x, side * (D / 2 - L / 2), ceiling / 2}, {.06f, L / 2, ceiling / 2});
      placed.push_back({x - .1f,
                        x + .1f,
                        std::min(side * D / 2, side * (D / 2 - L)),
                        std::max(side * D / 2, side * (D / 2 - L)),
                        ceiling,
                        {x, side * (D / 2 - L / 2), 0},
                        Thing::Clutter,
                        0});
    }
  }

  // ---- placing ----
  bool fits(const Placed& p, float gap) const {
    if (p.x0 < -W / 2 || p.x1 > W / 2 || p.y0 < -D / 2 || p.y1 > D / 2) return false;
    for (const Placed& q : placed)
      if (p.x0 < q.x1 + gap && p.x1 > q.x0 - gap && p.y0 < q.y1 + gap && p.y1 > q.y0 - gap) return false;
    return true;
  }
  static Placed footprint(V3 at, float yaw, Extent e, Thing thing) {
    const float c = std::fabs(std::cos(yaw)), s = std::fabs(std::sin(yaw)), hx = c * e.x + s * e.y,
                hy = s * e.x + c * e.y;
    return {at.x - hx, at.x + hx, at.y - hy, at.y + hy, e.z, at, thing, yaw};
  }
  bool findPlace(Extent e, Thing thing, float atWall, Placed& p) {
    for (int tries = 0; tries < 10; ++tries) {
      float yaw;
      V3 at;
      if (rnd.chance(atWall)) {
        const int w = rnd.i(4);
        // A bed stands with its head (+x) to the wall, all else with its back (-x).
        const bool head = thing == Thing::Bed,
                   along = thing == Thing::Curtain || (thing == Thing::Stretcher && rnd.chance(.7f));
        yaw = w * kPi / 2 + (along ? kPi / 2 : 0) + rnd.n(.03f);
        const float off = (along ? e.y : e.x) + rnd.u(.01f, .12f);
        const V3 n = Rz(w * kPi / 2) * V3{1, 0, 0}, t{-n.y, n.x, 0};
        const float depth = std::fabs(n.x) > .5f ? W / 2 : D / 2, run = std::fabs(n.x) > .5f ? D / 2 : W / 2;
        at = n * -(depth - off) + t * rnd.u(-run, run);
        if (head) yaw += kPi;
      } else {
        yaw = rnd.chance(.5f) ? rnd.i(4) * kPi / 2 + rnd.n(.08f) : rnd.u(-kPi, kPi);
        at = {rnd.u(-W, W) / 2, rnd.u(-D, D) / 2, 0};
      }
      p = footprint(at, yaw, e, thing);
      if (fits(p, rnd.u(-.02f, .2f))) return true;
    }
    return false;
  }

  struct Result {
    Extent e;
    float seat = 0, seatHalfWidth = 0, handle = 0;
  };
  Result build(Builder& b, Thing thing, int personInstance) {
    Result r{};
    switch (thing) {
      case Thing::Bed:
        r.e = bed(b, personInstance);
        break;
      case Thing::Stretcher:
        r.e = stretcher(b, personInstance);
        r.handle = 1;
        break;
      case Thing::Chair:
        r.e = chair(b, &r.seat);
        r.seatHalfWidth = .01f;
        break;
      case Thing::Couch:
        r.e = couch(b, &r.seat, &r.seatHalfWidth);
        break;
      case Thing::Bench:
        r.e = bench(b, &r.seat, &r.seatHalfWidth);
        break;
      case Thing::Wheelchair:
        r.e = wheelchair(b, personInstance);
        r.handle = .95f;
        break;
      case Thing::Trolley:
        r.e = trolley(b, &r.handle);
        break;
      case Thing::IvStand:
        r.e = ivStand(b);
        r.handle = .01f;
        break;
      case Thing::Bedside:
        r.e = bedsideCabinet(b);
        break;
      case Thing::Overbed:
        r.e = overbedTable(b);
        break;
      case Thing::Table:
        r.e = table(b);
        break;
      case Thing::Rack:
        r.e = storageRack(b);
        break;
      case Thing::Kitchen:
        r.e = kitchenCabinet(b);
        break;
      case Thing::Bin:
        r.e = trashBin(b);
        break;
      case Thing::Plant:
        r.e = plant(b);
        break;
      case Thing::Sink:
        r.e = sink(b);
        break;
      case Thing::Toilet:
        r.e = toilet(b);
        break;
      case Thing::Curtain:
        r.e = curtain(b, ceiling);
        break;
      case Thing::Monitor:
        r.e = patientMonitor(b);
        break;
      default:
        r.e = clutter(b);
    }
    return r;
  }
  // Things are built twice from the same random numbers: to know their size, then at their place.
  struct Plan {
    Thing thing;
    int person;            // instance of who lies or sits in it, or 0
    uint64_t state, next;  // of the random numbers: for the second building, and to go on after it
    Result size;
  };
  Plan plan(Thing thing) {
    const bool lies = thing == Thing::Bed || thing == Thing::Stretcher || thing == Thing::Wheelchair;
    Plan p{thing, lies ? takePerson(thing == Thing::Stretcher ? .3f : .45f) : 0, rnd.s, 0, {}};
    std::vector<float> scratch;
    Builder trial{rnd, scratch, Pose{}};
    p.size = build(trial, thing, p.person);
    return p;
  }
  void put(Thing thing, float atWall) {
    Plan p = plan(thing);
    Placed place;
    const uint64_t after = rnd.s;
    if (!findPlace(p.size.e, thing, atWall, place)) {
      if (p.person) ++peopleWanted;
      return;
    }
    p.next = rnd.s ^ (after << 1);
    set(p, place);
  }
  // At a given place; `gap` < 0 lets it overlap others (a table across a bed). Returns whether it fitted.
  bool putAt(Thing thing, V3 at, float yaw, float gap) {
    Plan p = plan(thing);
    const Placed place = footprint(at, yaw, p.size.e, thing);
    if (!fits(place, gap)) {
      if (p.person) ++peopleWanted;
      return false;
    }
    p.next = rnd.s + 1;
    set(p, place);
    return true;
  }
  void set(const Plan& plan, const Placed& p) {
    const Thing thing = plan.thing;
    const Result& size = plan.size;
    rnd.s = plan.state;
    Builder b = builder();
    b.pose = Pose{Rz(p.yaw), p.centre};
    b.instance = thing == Thing::Monitor || thing == Thing::Clutter ? 0 : newInstance();
    build(b, thing, plan.person);
    rnd.s = plan.next;
    placed.push_back(p);
    if (plan.person) people.push_back({p.centre.x, p.centre.y, 1.f});
    const Pose here = b.pose;
    if (size.seat > 0 && peopleWanted > 0) {  // people sit on it
      const int places = size.seatHalfWidth > .3f ? 1 + int(size.seatHalfWidth / .35f) : 1;
      for (int k = 0; k < places; ++k) {
        const int id = takePerson(places > 1 ? .3f : .4f);
        if (!id) continue;
        const float y = places > 1 ? -size.seatHalfWidth + size.seatHalfWidth * 2 * (k + .5f) / places : 0;
        b.cls = kPerson, b.instance = id, b.pose = here * Pose{Rz(rnd.n(.2f)), {rnd.u(-.1f, .06f), y, 0}};
        buildPerson(b, PersonStyle::sample(rnd), samplePose(rnd, Posture::Sit), Posture::Sit, size.seat);
        people.push_back({b.pose.t.x, b.pose.t.y, 1.3f});
      }
    } else if (size.handle > 0 && peopleWanted > 0 && rnd.chance(.4f)) {  // somebody pushes it
      const float side = thing == Thing::Stretcher ? rnd.sign() : 1;
      const V3 at =
          here * V3{-side * (size.e.x + (thing == Thing::IvStand ? .2f : .3f) + rnd.u(-.05f, .15f)), rnd.n(.06f), 0};
      standPerson(at, p.yaw + (side < 0 ? kPi : 0), Posture::Push, takePerson(1), false);
    } else if (peopleWanted > 0 && rnd.chance(.18f)) {  // somebody busy with it
      const float ring = rnd.u(0, 2 * kPi);
      const V3 dir = Rz(ring) * V3{1, 0, 0};
      const V3 local{dir.x * (size.e.x + .3f), dir.y * (size.e.y + .3f), 0};
      const V3 at = here * local;
      const V3 to = p.centre - at;
      const float a = rnd.u();
      standPerson(at, std::atan2(to.y, to.x) + rnd.n(.4f),
                  a < .35f   ? Posture::Bend
                  : a < .65f ? Posture::Reach
                  : a < .75f ? Posture::Kneel
                             : Posture::Stand,
                  takePerson(1), true);
    }
  }
  // Bed places along one wall, as in a ward: bed with its head to the wall, what belongs to it around, curtains
  // between.
  void putBays() {
    const int w = rnd.i(4);
    const V3 n = Rz(w * kPi / 2) * V3{1, 0, 0}, t{-n.y, n.x, 0};  // away from the wall, along it
    const float depth = std::fabs(n.x) > .5f ? W / 2 : D / 2, run = std::fabs(n.x) > .5f ? D / 2 : W / 2;
    const float pitch = rnd.u(1.7f, 3.6f), facing = w * kPi / 2;
    auto at = [&](float along, float off) { return n * (off - depth) + t * along; };
    for (float s = -run + rnd.u(.8f, 1.6f); s < run - .6f; s += pitch) {
      if (!putAt(Thing::Bed, at(s, rnd.u(1.08f, 1.2f)), facing + kPi + rnd.n(.02f), 0)) continue;
      const float side = rnd.sign();
      if (rnd.chance(.75f))
        putAt(Thing::Bedside, at(s + side * rnd.u(.75f, .9f), rnd.u(.27f, .35f)), facing + rnd.n(.05f), -.05f);
      if (rnd.chance(.55f))
        putAt(Thing::IvStand, at(s - side * rnd.u(.65f, .85f), rnd.u(.25f, .8f)), rnd.u(-kPi, kPi), -.2f);
      if (rnd.chance(.4f))
        putAt(Thing::Monitor, at(s + rnd.sign() * rnd.u(.65f, .9f), rnd.u(.3f, .6f)), facing + rnd.n(.3f), -.15f);
      if (rnd.chance(.55f)) putAt(Thing::Overbed, at(s + rnd.n(.25f), rnd.u(1.2f, 2.6f)), facing + rnd.n(.1f), -2.f);
      if (rnd.chance(.6f))
        putAt(Thing::Chair, at(s + rnd.sign() * rnd.u(.8f, 1.1f), rnd.u(.7f, 2.2f)),
              rnd.chance(.6f) ? facing + rnd.n(.3f) : rnd.u(-kPi, kPi), -.05f);
      if (rnd.chance(.25f)) putAt(Thing::Wheelchair, at(s + rnd.n(.6f), rnd.u(2.6f, 3.4f)), rnd.u(-kPi, kPi), 0);
      if (rnd.chance(.2f)) putAt(Thing::Bin, at(s + side * pitch * .45f, .25f), facing, 0);
      if (rnd.chance(.45f)) putAt(Thing::Curtain, at(s + pitch / 2, rnd.u(.8f, 1.6f)), facing + kPi / 2, -.3f);
    }
  }
  // Toys, bags, cartons, mugs close together on a table or the floor, for cameras close by: nobody's limbs.
  void putHeap() {
    V3 at{rnd.u(-W, W) * .42f, rnd.u(-D, D) * .42f, 0};
    for (int tries = 0; tries < 6 && !placed.empty(); ++tries) {
      const Placed& q = placed[rnd.i(int(placed.size()))];
      if (q.thing != Thing::Table && q.thing != Thing::Overbed && q.thing != Thing::Bedside) continue;
      at = {rnd.u(.7f * q.x0 + .3f * q.x1, .3f * q.x0 + .7f * q.x1),
            rnd.u(.7f * q.y0 + .3f * q.y1, .3f * q.y0 + .7f * q.y1), q.top};
      break;
    }
    Builder b = builder();
    b.loss = rnd.chance(.15f) ? rnd.u(0.f, .4f) : 0;
    for (int k = 2 + rnd.i(8); k > 0; --k) {
      const V3 spot = at + V3{rnd.n(.2f), rnd.n(.2f), 0};
      const float a = rnd.u();
      if (a < .5f)
        softThing(b, spot, rnd.u(.15f, .6f));
      else if (a < .85f)
        handSized(b, spot, Rz(rnd.u(0, 2 * kPi)));
      else
        carton(b, spot, Rz(rnd.u(0, 3.1f)));
    }
    heaps.push_back(at + V3{0, 0, rnd.u(0.f, .2f)});
  }
  // Somebody who stands or leans where a desk hides the legs: of whom a camera at the desk sees the trunk from close
  // by.
  void putPassersBy() {
    for (const Pose& seat : std::vector<Pose>(seats))
      if (peopleWanted > 0 && rnd.chance(.3f)) {
        const V3 at = seat * V3{rnd.u(.1f, 1.6f), rnd.n(.6f), 0};
        if (std::fabs(at.x) > W / 2 - .2f || std::fabs(at.y) > D / 2 - .2f) continue;
        standPerson(at, rnd.u(-kPi, kPi),
                    rnd.chance(.5f)   ? Posture::Walk
                    : rnd.chance(.5f) ? Posture::Stand
                                      : Posture::Bend,
                    takePerson(1), false);
      }
  }
  void putWorkplace(float atWall) {
    const uint64_t state = rnd.s;
    std::vector<float> scratch;
    std::vector<Pose> places;
    Builder trial{rnd, scratch, Pose{}};
    const Extent e = workplace(trial, places);
    const uint64_t after = rnd.s;
    Placed p;
    if (!findPlace(e, Thing::Table, atWall, p)) return;
    const uint64_t next = rnd.s ^ (after << 1);
    rnd.s = state;
    places.clear();
    Builder b = builder();
    b.pose = Pose{Rz(p.yaw), p.centre};
    b.instance = newInstance();
    workplace(b, places);
    rnd.s = next;
    placed.push_back(p);
    const Pose here = b.pose;
    for (const Pose& place : places) {
      const Pose seat = here * place;
      if (std::fabs(seat.t.x) > W / 2 - .2f || std::fabs(seat.t.y) > D / 2 - .2f) continue;
      seats.push_back(seat);
      if (rnd.chance(.6f)) {
        float height = 0;
        b.pose = Pose{seat.R * Rz(rnd.n(.35f)), seat.t}, b.instance = newInstance();
        const Extent size = chair(b, &height, rnd.chance(.65f) ? 1 : -1);
        placed.push_back(footprint(seat.t, 0, size, Thing::Chair));
        if (const int id = height > 0 ? takePerson(.6f) : 0) {
          b.cls = kPerson, b.instance = id;
          buildPerson(b, PersonStyle::sample(rnd), samplePose(rnd, Posture::Sit), Posture::Sit, height);
          people.push_back({seat.t.x, seat.t.y, 1.3f});
        }
      } else if (const int id = takePerson(.4f)) {
        standPerson(seat.t, std::atan2(seat.R.r1.x, seat.R.r0.x) + rnd.n(.6f),
                    rnd.chance(.4f)   ? Posture::Bend
                    : rnd.chance(.4f) ? Posture::Reach
                                      : Posture::Stand,
                    id, true);
      }
    }
  }
  void standPerson(V3 at, float yaw, Posture posture, int id, bool check) {
    if (!id) return;
    Placed p = footprint(at, yaw, {.22f, .26f, 1.8f}, Thing::Count);
    if (check && !fits(p, -.12f)) {
      ++peopleWanted;
      return;
    }
    Builder b = builder();
    b.cls = kPerson, b.instance = id, b.pose = Pose{Rz(yaw), at};
    const PersonStyle s = PersonStyle::sample(rnd);
    buildPerson(b, s, samplePose(rnd, posture), posture);
    people.push_back({at.x, at.y, s.height});
    placed.push_back(p);
  }
  void freePeople() {
    for (int tries = 0; tries < 40 && peopleWanted > 0; ++tries) {
      const V3 at{rnd.u(-W, W) * .48f, rnd.u(-D, D) * .48f, 0};
      const float yaw = rnd.u(-kPi, kPi), a = rnd.u();
      const Posture posture = a < .42f   ? Posture::Stand
                              : a < .8f  ? Posture::Walk
                              : a < .88f ? Posture::Bend
                              : a < .93f ? Posture::Reach
                                         : Posture::Kneel;
      standPerson(at, yaw, posture, takePerson(1), true);
      if (peopleWanted > 0 && !people.empty() && rnd.chance(.3f)) {  // somebody joins
        const V3 other = people.back(), off = Rz(rnd.u(-kPi, kPi)) * V3{rnd.u(.45f, 1.1f), 0, 0};
        standPerson({other.x + off.x, other.y + off.y, 0}, std::atan2(-off.y, -off.x) + rnd.n(.5f),
                    rnd.chance(.7f) ? Posture::Stand : Posture::Walk, takePerson(1), true);
      }
    }
  }

  void populate() {
    room();
    peopleWanted = rnd.chance(.3f) ? 0 : 1 + (rnd.chance(.3f) ? rnd.i(8) : rnd.i(4));
    const float desks[6] = {.15f, .08f, .25f, .85f, 0, .3f};
    for (int k = 0; k < 2; ++k)
      if (rnd.chance(desks[int(kind)])) putWorkplace(.4f);
    if (rnd.chance(kind == RoomKind::Ward ? .75f : kind == RoomKind::Mixed ? .15f : 0)) putBays();
    if (rnd.chance(.4f)) putPassersBy();
    int order[int(Thing::Count)];
    for (int k = 0; k < int(Thing::Count); ++k) order[k] = k;
    for (int k = int(Thing::Count) - 1; k > 0; --k) std::swap(order[k], order[rnd.i(k + 1)]);
    const float fill = rnd.chance(.08f) ? 0 : rnd.u(.3f, 1.f);
    for (int k : order) {
      const Habit& h = kHabits[k];
      const float wanted = h.most[int(kind)] * fill * rnd.u(0, 1.4f);
      int n = int(wanted) + rnd.chance(wanted - int(wanted));
      while (n-- > 0) put(h.thing, h.atWall);
    }
    if (kind == RoomKind::Waiting && rnd.chance(.5f)) put(Thing::Bench, .8f);
    for (int k = rnd.i(4); k > 0; --k) putHeap();
    freePeople();
  }

  // ---- the camera ----
  bool freeForCamera(V3 p) const {
    if (std::fabs(p.x) > W / 2 - .1f || std::fabs(p.y) > D / 2 - .1f || p.z > ceiling - .1f) return false;
    for (const Placed& q : placed)
      if (q.thing != Thing::Count && p.x > q.x0 - .1f && p.x < q.x1 + .1f && p.y > q.y0 - .1f && p.y < q.y1 + .1f &&
          p.z < q.top + .12f)
        return false;
    for (const V3& q : people)
      if (std::hypot(p.x - q.x, p.y - q.y) < .42f && p.z < q.z + .15f) return false;
    return true;
  }
  // How much a camera that looks from `at` towards `target` may see.
  float interest(V3 at, V3 target) const {
    const float yaw = std::atan2(target.y - at.y, target.x - at.x);
    float sum = 0;
    auto seen = [&](V3 p) {
      const float d = std::hypot(p.x - at.x, p.y - at.y),
                  turn = std::remainder(std::atan2(p.y - at.y, p.x - at.x) - yaw, 2 * kPi);
      return d > .5f && d < 6 && std::fabs(turn) < .5f;
    };
    for (const Placed& q : placed) sum += q.thing != Thing::Count && seen(q.centre);
    for (const V3& q : people) sum += 1.5f * seen(q);
    const V3 dir{std::cos(yaw), std::sin(yaw), 0};
    const float toX = ((dir.x > 0 ? W / 2 : -W / 2) - at.x) / (std::fabs(dir.x) < 1e-3f ? 1e-3f : dir.x),
                toY = ((dir.y > 0 ? D / 2 : -D / 2) - at.y) / (std::fabs(dir.y) < 1e-3f ? 1e-3f : dir.y);
    if (std::min(std::fabs(toX), std::fabs(toY)) < 1.2f) sum -= 2;  // a wall fills the image
    return sum;
  }
  // The most interesting of some camera positions.
  void camera(float* out) {
    V3 at{}, target{};
    bool tight = false;
    const int candidates = 1 + rnd.i(4);
    float best = -1e9f;
    for (int k = 0; k < candidates; ++k) {
      V3 a{}, t{};
      const bool near = propose(a, t);
      const float score = interest(a, t) + (near ? 2 : 0);
      if (score > best) best = score, at = a, target = t, tight = near;
    }
    aim(at, target, tight, out);
  }
  bool propose(V3& at, V3& target) {
    const float mode = rnd.u();
    bool tight = false;
    for (int tries = 0; tries < 40; ++tries) {
      const bool desk = !seats.empty() && mode < (kind == RoomKind::Office ? .45f : .25f);
      const bool near = !desk && !people.empty() && mode > .75f;
      const bool over = !desk && !near && !placed.empty() && mode > .67f;
      const bool close = !desk && !near && !over && mode > .55f;
      if (desk) {  // as if held by somebody who sits or stands at the desk
        const Pose& s = seats[rnd.i(int(seats.size()))];
        at = s * V3{rnd.u(-.3f, .6f), rnd.n(.25f), 0};
        at.z = rnd.u(.9f, 1.7f);
        target = at + s.R * Rz(rnd.n(.5f)) * V3{1, 0, 0} + V3{0, 0, -std::tan(rnd.u(-.3f, 1.1f))};
      } else if (close) {
        closeUp(at, target);
        tight = true;
      } else if (over) {  // close above something low
        const Placed& q = placed[rnd.i(int(placed.size()))];
        const float az = rnd.u(-kPi, kPi);
        const V3 off{std::cos(az) * ((q.x1 - q.x0) / 2 + rnd.u(-.1f, .7f)),
                     std::sin(az) * ((q.y1 - q.y0) / 2 + rnd.u(-.1f, .7f)), 0};
        at = {q.centre.x + off.x, q.centre.y + off.y, std::min(2.2f, std::min(q.top, 1.3f) + rnd.u(.2f, 1.f))};
        target = q.centre + V3{rnd.n(.2f), rnd.n(.2f), std::min(q.top, 1.2f) * rnd.u(.5f, 1.1f)};
      } else if (near) {
        const V3 p = people[rnd.i(int(people.size()))];
        const float d = rnd.chance(.5f) ? rnd.u(.45f, 1.f) : rnd.u(.6f, 2.2f), az = rnd.u(-kPi, kPi);
        at = {p.x + d * std::cos(az), p.y + d * std::sin(az), rnd.u(.2f, 2.f)};
        target = {p.x, p.y, rnd.u(.1f, 1.f) * p.z};
        if (rnd.chance(.4f)) target.z = at.z + rnd.n(.15f) * d;
        tight = true;
      } else {
        at = {rnd.u(-W, W) / 2, rnd.u(-D, D) / 2, rnd.chance(.45f) ? rnd.u(.2f, 1.1f) : rnd.u(.9f, 2.2f)};
        const float a = rnd.u();
        if (!people.empty() && a < .55f) {
          const V3 p = people[rnd.i(int(people.size()))];
          target = {p.x, p.y, rnd.u(.1f, 1.f) * p.z};
        } else if (!placed.empty() && a < .85f) {
          const Placed& q = placed[rnd.i(int(placed.size()))];
          target = q.centre + V3{0, 0, rnd.u(.2f, 1.f) * std::min(q.top, 1.5f)};
        } else {
          target = {rnd.u(-W, W) / 2, rnd.u(-D, D) / 2, rnd.u(.3f, 1.5f)};
        }
        if (rnd.chance(.5f)) target.z = at.z - length(target - at) * std::tan(rnd.n(.2f));  // level, as on a robot
      }
      if (freeForCamera(at) && length(target - at) > .3f) break;
    }
    return tight;
  }
  // From 0.4 to 1.3 m at what lies on something low, or at the floor.
  void closeUp(V3& at, V3& target) {
    target = {rnd.u(-W, W) * .45f, rnd.u(-D, D) * .45f, 0};
    if (!heaps.empty() && rnd.chance(.5f)) {
      target = heaps[rnd.i(int(heaps.size()))] + V3{rnd.n(.15f), rnd.n(.15f), 0};
    } else if (!placed.empty() && !rnd.chance(.15f)) {
      const Placed* q = &placed[rnd.i(int(placed.size()))];
      for (int tries = 0; tries < 8 && (q->top > 1.4f || q->thing == Thing::Count); ++tries)
        q = &placed[rnd.i(int(placed.size()))];
      target = {rnd.u(q->x0, q->x1), rnd.u(q->y0, q->y1), std::min(q->top, 1.4f) * rnd.u(.85f, 1.05f)};
    }
    const float d = rnd.u(.4f, 1.3f), az = rnd.u(-kPi, kPi), up = rnd.u(.1f, 1.35f);
    at = target + V3{std::cos(az) * std::cos(up), std::sin(az) * std::cos(up), std::sin(up)} * d;
  }
  void aim(V3 at, V3 target, bool tight, float* out) {
    const V3 look = target - at;
    const float jitter = tight ? .2f : .32f;
    float yaw = std::atan2(look.y, look.x) + rnd.u(-jitter, jitter);
    float pitch = std::atan2(look.z, std::hypot(look.x, look.y)) + rnd.n(.1f);
    pitch = std::min(std::max(pitch, -75.f / 180 * kPi), 40.f / 180 * kPi);
    const float roll = rnd.chance(.18f) ? rnd.u(-.79f, .79f) : rnd.n(rnd.chance(.5f) ? .015f : .09f);
    // Optical axes in the world: z forward, x right, y down.
    const M3 body = Rz(yaw) * Ry(-pitch) * Rx(roll);
    const V3 forward = body * V3{1, 0, 0}, left = body * V3{0, 1, 0}, up = body * V3{0, 0, 1};
    const V3 right = left * -1.f, down = up * -1.f;
    const float R[9] = {right.x, down.x, forward.x, right.y, down.y, forward.y, right.z, down.z, forward.z};
    std::memcpy(out, R, sizeof R);
    const float f = rnd.chance(.5f) ? rnd.u(500, 590) : rnd.u(420, 640);
    out[9] = at.x, out[10] = at.y, out[11] = at.z;
    out[12] = f, out[13] = f * rnd.u(.99f, 1.01f), out[14] = 319.5f + rnd.n(10), out[15] = 239.5f + rnd.n(10);
  }
};

}  // namespace

// Scenes seed .. seed + count - 1.  primitives: count x capacity x 28, counts: count, cameras: count x 16 (see
// raycast.cu). `views` scenes in a row share their room and get a camera each.  Returns how many scenes overran the
// capacity.
extern "C" int generate_scenes(uint64_t seed, int count, int views, int capacity, float* primitives, int* counts,
                               float* cameras, int threads) {
  std::atomic<int> next{0}, cut{0};
  auto work = [&] {
    for (int g; (g = next++) * views < count;) {
      Scene scene(seed + uint64_t(g));
      scene.populate();
      int n = int(scene.primitives.size()) / kPrimitiveFloats;
      if (n > capacity) n = capacity, ++cut;
      for (int k = g * views; k < std::min(count, (g + 1) * views); ++k) {
        std::memcpy(primitives + size_t(k) * capacity * kPrimitiveFloats, scene.primitives.data(),
                    size_t(n) * kPrimitiveFloats * sizeof(float));
        counts[k] = n;
        scene.camera(cameras + k * 16);
      }
    }
  };
  std::vector<std::thread> pool;
  for (int k = 0; k < threads; ++k) pool.emplace_back(work);
  for (std::thread& t : pool) t.join();
  return cut;
}
