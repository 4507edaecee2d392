#include "life/life.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "furniture/furniture.h"
#include "furniture/hospital_furniture.h"
#include "furniture/odd_machine.h"
#include "life/errands.h"
#include "life/life_actors.h"
#include "people/outfits.h"
#include "people/patient.h"
#include "scene/classes.h"

namespace wardslam::synth {
namespace {

using Eigen::Vector2d;

/// How much of everything.
struct Amount {
  std::size_t people;
  std::size_t ridden;    ///< Wheelchairs with somebody in them.
  std::size_t brought;   ///< Trolleys, machines and a bed with a patient, in turn.
  std::size_t borrowed;  ///< Things of the place that may be moved.
  double nearCamera;
};

Amount amountOf(Density density) {
  switch (density) {
    case Density::None:
      break;
    case Density::Few:
      return {10, 1, 2, 4, 0.3};
    case Density::Normal:
      return {26, 2, 3, 8, 0.4};
    case Density::Busy:
      return {54, 3, 5, 12, 0.5};
    case Density::Crowd:
      return {90, 4, 6, 16, 0.6};
  }
  return {0, 0, 0, 0, 0.0};
}

/// A thing to be moved, with its looks.
struct Moved {
  Label label;
  Surfaces model;
  Portable portable;
  ThingState state;
  std::vector<std::pair<Label, Surfaces>> onIt;  ///< Who lies on it.
};

Portable pushedBy(const Eigen::AlignedBox2d& footprint_m, double handleZ_m) {
  Portable portable;
  portable.holderX_m = footprint_m.min().x() - static_cast<double>(anatomy::kReach_m) + 0.02;
  portable.pivotX_m = footprint_m.center().x();
  portable.handleZ_m = handleZ_m;
  portable.width_m = footprint_m.sizes().y();
  portable.from_m = footprint_m.min().x();
  portable.to_m = footprint_m.max().x();
  return portable;
}

Portable carriedChair() {
  Portable portable;
  portable.holderX_m = 0.55;  // in front of it, hands on its arms
  portable.holderHeading_rad = M_PI;
  portable.carried = true;
  portable.handleZ_m = 0.72;
  portable.width_m = 0.48;
  portable.from_m = -0.25;
  portable.to_m = 0.23;
  return portable;
}

Eigen::AlignedBox2d footprintOf(const Surfaces& model) {
  Eigen::AlignedBox2d box;
  for (const Surface& surface : model) {
    for (const Vertex& vertex : surface.mesh.vertices) box.extend(vertex.p_m.head<2>().cast<double>().eval());
  }
  return box;
}

class LifeMaker {
 public:
  LifeMaker(Scene& scene, std::uint16_t firstId, const Ways& ways, const LifeOptions& options)
      : scene_(scene),
        ways_(ways),
        options_(options),
        amount_(amountOf(options.density)),
        nextId_(firstId),
        dice_(0x5EED0000ULL + options.seed),
        rng_(0x11FE0000ULL + options.seed) {}

  std::uint16_t make() {
    if (amount_.people == 0) return nextId_;
    const std::vector<std::size_t> borrowed = chooseBorrowed();
    SocietyWorld world = makeWorld(borrowed);
    takeOver(borrowed);
    bringThings(world);
    settle(world);
    for (const Moved& thing : moved_) world.portables.push_back(thing.portable);
    addActors(std::make_shared<Society>(std::move(world), std::move(state_)));
    return nextId_;
  }

 private:
  Label label(const std::string& kind, core::ClassId id) {
    const std::string name = kind + "_l" + std::to_string(++counts_[kind]);
    return {nextId_++, name, id, kind};
  }

  [[nodiscard]] bool canBorrow(const ClearanceMap& all, const MovableThing& movable) const {
    if (movable.classId != kChair && movable.classId != kTrolley && movable.classId != kWheelchair) return false;
    const Eigen::Isometry3d& T = movable.T_world_thing;
    const Portable portable = portableOf(movable);
    const Vector2d holder = (T * Eigen::Vector3d(portable.holderX_m, 0, 0)).head<2>();
    return all.at(holder) > 0.22;
  }

  [[nodiscard]] static Portable portableOf(const MovableThing& movable) {
    return movable.classId == kChair ? carriedChair() : pushedBy(movable.footprint_m, 0.98);
  }

  [[nodiscard]] std::vector<std::size_t> chooseBorrowed() {
    const ClearanceMap all(scene_.things, {});
    std::vector<std::size_t> fitting;
    for (std::size_t i = 0; i < ways_.movable.size(); ++i) {
      const Vector2d p = ways_.movable[i].T_world_thing.translation().head<2>();
      const auto isSeat = [&](const Seat& seat) { return (seat.p_m - p).norm() < 0.4; };
      if (std::any_of(ways_.seats.begin(), ways_.seats.end(), isSeat) && rollDice(dice_) < 0.6) continue;
      if (canBorrow(all, ways_.movable[i])) fitting.push_back(i);
    }
    while (fitting.size() > amount_.borrowed) {
      const auto gone = static_cast<std::size_t>(rollDice(dice_) * static_cast<double>(fitting.size()));
      fitting.erase(fitting.begin() + static_cast<std::ptrdiff_t>(gone));
    }
    return fitting;
  }

  [[nodiscard]] SocietyWorld makeWorld(const std::vector<std::size_t>& borrowed) const {
    std::vector<bool> counts(scene_.things.size(), true);
    Ways left = ways_;
    for (const std::size_t i : borrowed) {
      const MovableThing& movable = ways_.movable[i];
      counts[movable.thing] = false;
      const Vector2d p = movable.T_world_thing.translation().head<2>();
      const auto isThis = [&](const Seat& seat) { return (seat.p_m - p).norm() < 0.4; };
      left.seats.erase(std::remove_if(left.seats.begin(), left.seats.end(), isThis), left.seats.end());
    }
    std::vector<Vector2d> route;
    for (double t = 0; t <= options_.duration_s; t += 0.25) route.push_back(ways_.camera_m(t));
    SocietyWorld world{WayNetwork(ways_.graph),
                       ClearanceMap(scene_.things, counts),
                       ClearanceMap(route),
                       ways_.camera_m,
                       {},
                       {},
                       options_.density == Density::Crowd,
                       amount_.nearCamera};
    measureWays(world);
    findPlaces(world, left);
    return world;
  }

  /// Things of the scene that become actors.
  void takeOver(const std::vector<std::size_t>& borrowed) {
    std::vector<std::size_t> gone;
    for (const std::size_t i : borrowed) {
      const MovableThing& movable = ways_.movable[i];
      const Thing& thing = scene_.things[movable.thing];
      const Eigen::Isometry3d& T = movable.T_world_thing;
      const double yaw = std::atan2(T.linear()(1, 0), T.linear()(0, 0));
      moved_.push_back({thing.label,
                        placed(thing.surfaces, T.inverse().cast<float>()),
                        portableOf(movable),
                        {T.translation().head<2>(), yaw, T.translation().z()},
                        {}});
      gone.push_back(movable.thing);
    }
    std::sort(gone.rbegin(), gone.rend());
    for (const std::size_t i : gone) scene_.things.erase(scene_.things.begin() + static_cast<std::ptrdiff_t>(i));
  }

  /// Puts a thing on a free place beside a way; false where there is none.
  bool park(const SocietyWorld& world, Moved thing) {
    for (int attempt = 0; attempt < 200; ++attempt) {
      const auto i = static_cast<std::size_t>(rollDice(dice_) * static_cast<double>(world.places.size()));
      if (i >= world.places.size() || world.places[i].kind != RestingPlace::Kind::Parking) continue;
      const double heading = world.places[i].heading_rad;
      thing.state = {world.places[i].p_m - thing.portable.pivotX_m * directionOf(heading), heading, 0.0};
      bool fits = world.walls.at(thing.state.p_m + thing.portable.holderX_m * directionOf(heading)) > 0.25;
      for (const Disc& disc : discsOf(thing.portable, thing.state)) {
        fits = fits && world.walls.at(disc.p_m) > disc.radius_m && world.cameraRoute.at(disc.p_m) > 0.6 + disc.radius_m;
        for (const Moved& other : moved_) fits = fits && (other.state.p_m - disc.p_m).norm() > 1.6;
      }
      if (!fits) continue;
      moved_.push_back(std::move(thing));
      return true;
    }
    return false;
  }

  void bringThings(const SocietyWorld& world) {
    if (world.places.empty()) return;
    for (std::size_t i = 0; i < amount_.ridden; ++i) {
      const Surfaces model = makeWheelchair(rng_);
      Moved chair{{}, model, pushedBy(footprintOf(model), 0.95), {}, {}};
      chair.portable.rider = kNobody - 1;  // to be found
      if (park(world, std::move(chair))) moved_.back().label = label("wheelchair", kWheelchair);
    }
    for (std::size_t i = 0; i < amount_.brought; ++i) {
      if (i % 3 == 1) {
        const Surfaces model = makeTrolley(rng_);
        if (park(world, {{}, model, pushedBy(footprintOf(model), 1.02), {}, {}}))
          moved_.back().label = label("trolley", kTrolley);
      } else if (i % 3 == 0) {
        const Surfaces model = makeOddMachine(rng_);
        if (park(world, {{}, model, pushedBy(footprintOf(model), 1.0), {}, {}}))
          moved_.back().label = label("medical_device", kMedicalDevice);
      } else {
        bringBed(world);
      }
    }
  }

  void bringBed(const SocietyWorld& world) {
    Surfaces model = makeBed(static_cast<int>(rollDice(dice_) * 4), rng_);
    const Eigen::AlignedBox2d footprint = footprintOf(model);
    for (Surface& surface : makeCoveredBody(rng_)) model.push_back(std::move(surface));
    if (!park(world, {{}, model, pushedBy(footprint, 0.98), {}, {}})) return;
    moved_.back().label = label("bed", kBed);
    moved_.back().onIt.emplace_back(label("patient", kPerson), makePatient(static_cast<int>(rollDice(dice_) * 3)));
    moved_.back().onIt.back().first.className = "person";
  }

  static Role roleFor(double dice) {
    if (dice < 0.28) return Role::Nurse;
    if (dice < 0.42) return Role::Doctor;
    if (dice < 0.56) return Role::Porter;
    return dice < 0.88 ? Role::Visitor : Role::Patient;
  }

  void addMember(Role role) {
    Member member;
    looks_.push_back(randomLook(role, rng_));
    member.stride_m = anatomy::strideLength_m(looks_.back().height_m);
    const bool slow = role == Role::Patient;
    member.walks_mps = slow ? 0.6 + 0.25 * rollDice(dice_) : 0.85 + 0.55 * rollDice(dice_);
    member.dice = dice_ ^ (0xABCDULL * (looks_.size() + 1));
    (void)rollDice(dice_);
    roles_.push_back(role);
    state_.members.push_back(member);
  }

  [[nodiscard]] bool isFree(const SocietyWorld& world, const Vector2d& p_m) const {
    if ((world.camera_m(0.0) - p_m).norm() < 1.6) return false;
    for (const Member& member : state_.members) {
      if ((member.body.p_m - p_m).norm() < 0.65) return false;
    }
    for (const Moved& thing : moved_) {
      for (const Disc& disc : discsOf(thing.portable, thing.state)) {
        if ((disc.p_m - p_m).norm() < disc.radius_m + 0.4) return false;
      }
    }
    return true;
  }

  /// Somewhere along a way.
  bool putOnWay(const SocietyWorld& world, Member& member) {
    const WayGraph& graph = world.ways.graph();
    for (int attempt = 0; attempt < 100 && !graph.edges.empty(); ++attempt) {
      const auto [a, b] = graph.edges[std::min(
          graph.edges.size() - 1, static_cast<std::size_t>(rollDice(dice_) * static_cast<double>(graph.edges.size())))];
      const Vector2d p = graph.nodes_m[a] + rollDice(dice_) * (graph.nodes_m[b] - graph.nodes_m[a]);
      if (!isFree(world, p) || world.walls.at(p) < 0.2) continue;
      member.body.p_m = p;
      member.body.heading_rad = 2 * M_PI * rollDice(dice_);
      return true;
    }
    return false;
  }

  /// At a seat, spot or group, as if there for a while already.
  bool putAtRest(const SocietyWorld& world, std::size_t who) {
    Member& member = state_.members[who];
    for (int attempt = 0; attempt < 40 && !world.places.empty(); ++attempt) {
      const auto i = std::min(world.places.size() - 1,
                              static_cast<std::size_t>(rollDice(dice_) * static_cast<double>(world.places.size())));
      const RestingPlace& place = world.places[i];
      if (place.kind == RestingPlace::Kind::Parking || state_.placeTaken[i] != kNobody || !isFree(world, place.p_m))
        continue;
      state_.placeTaken[i] = who;
      member.body.p_m = place.p_m;
      member.body.heading_rad = place.heading_rad;
      Step free;
      free.kind = Step::Kind::Free;
      free.index = i;
      member.steps.push_back(free);
      Step wait;
      wait.seconds = 5 + 80 * rollDice(dice_);
      wait.talks = place.kind == RestingPlace::Kind::Group;
      if (place.kind == RestingPlace::Kind::Seat) {
        Step up;
        up.kind = Step::Kind::GetUp;
        member.steps.push_back(up);
        member.body.pose.sitting = 1.0;
        member.body.pose.seat_m = place.seat_m;
        member.body.p_m -= kSeatedFeet_m * directionOf(place.heading_rad);
      }
      member.steps.push_back(wait);
      return true;
    }
    return false;
  }

  void settle(const SocietyWorld& world) {
    state_.placeTaken.assign(world.places.size(), kNobody);
    for (Moved& thing : moved_) {
      state_.things.push_back(thing.state);
      state_.heldBy.push_back(kNobody);
      if (thing.portable.rider != kNobody) seatRider(thing);
    }
    for (std::size_t i = 0; i < amount_.people; ++i) {
      addMember(roleFor(rollDice(dice_)));
      const std::size_t who = state_.members.size() - 1;
      if (rollDice(dice_) < 0.6 && putAtRest(world, who)) continue;
      if (putOnWay(world, state_.members[who])) continue;
      state_.members.pop_back();
      looks_.pop_back();
      roles_.pop_back();
    }
  }

  void seatRider(Moved& thing) {
    addMember(rollDice(dice_) < 0.7 ? Role::Patient : Role::Visitor);
    Member& rider = state_.members.back();
    thing.portable.rider = state_.members.size() - 1;
    rider.sitsIn = state_.things.size() - 1;
    rider.body.p_m = thing.state.p_m;
    rider.body.heading_rad = thing.state.heading_rad;
    rider.body.pose.sitting = 1.0;
    rider.body.pose.seat_m = static_cast<double>(kWheelchairSeat_m);
    rider.body.pose.footrest_m = 0.14;
  }

  void addActors(const std::shared_ptr<const Society>& society) {
    static const char* const kNames[] = {"nurse", "doctor", "porter", "visitor", "patient"};
    for (std::size_t i = 0; i < looks_.size(); ++i) {
      Label who = label(kNames[static_cast<std::size_t>(roles_[i])], kPerson);
      who.className = "person";
      if (scene_.textures.count(looks_[i].outfit) == 0)
        scene_.textures[looks_[i].outfit] = paintLifeOutfit(looks_[i].outfit, options_.seed);
      scene_.actors.push_back(std::make_unique<MemberActor>(who, society, i, looks_[i]));
    }
    for (std::size_t i = 0; i < moved_.size(); ++i) {
      scene_.actors.push_back(std::make_unique<MovedActor>(moved_[i].label, society, i, moved_[i].model));
      for (auto& [who, model] : moved_[i].onIt)
        scene_.actors.push_back(std::make_unique<MovedActor>(who, society, i, model));
    }
  }

  Scene& scene_;
  const Ways& ways_;
  LifeOptions options_;
  Amount amount_;
  std::uint16_t nextId_;
  std::uint64_t dice_;
  cv::RNG rng_;
  std::map<std::string, int> counts_;
  std::vector<Moved> moved_;
  SocietyState state_;
  std::vector<Look> looks_;
  std::vector<Role> roles_;
};

}  // namespace

const std::map<std::string, Density>& densities() {
  static const std::map<std::string, Density> kAll = {{"none", Density::None},
                                                      {"few", Density::Few},
                                                      {"normal", Density::Normal},
                                                      {"busy", Density::Busy},
                                                      {"crowd", Density::Crowd}};
  return kAll;
}

std::uint16_t addLife(Scene& scene, std::uint16_t firstId, const Ways& ways, const LifeOptions& options) {
  return LifeMaker(scene, firstId, ways, options).make();
}

}  // namespace wardslam::synth
