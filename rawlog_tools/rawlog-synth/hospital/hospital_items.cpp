#include "hospital/hospital_items.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>

#include "furniture/furniture.h"
#include "furniture/hospital_furniture.h"
#include "people/patient.h"
#include "scene/classes.h"

namespace wardslam::synth {
namespace {

using Eigen::Vector2d;

struct Kind {
  core::ClassId classId;
  const char* className;
  bool movable;
};

/// In the order of ItemKind.
constexpr std::array<Kind, 27> kKinds = {{{kBed, "bed", true},
                                          {kCabinet, "bedside_cabinet", false},
                                          {kIvStand, "iv_stand", true},
                                          {kChair, "chair", true},
                                          {kTrolley, "trolley", true},
                                          {kWheelchair, "wheelchair", true},
                                          {kScreen, "folding_screen", true},
                                          {kTrashBin, "trash_bin", false},
                                          {kPlant, "potted plant", false},
                                          {kTable, "dining table", false},
                                          {kCurtain, "curtain", false},
                                          {kRack, "storage_rack", false},
                                          {kNurseStation, "nurse_station", false},
                                          {kTable, "dining table", false},
                                          {kToilet, "toilet", false},
                                          {kSink, "sink", false},
                                          {kDoor, "door", false},
                                          {kWindow, "window", false},
                                          {kPicture, "picture", false},
                                          {kSign, "sign", false},
                                          {kSign, "sign", false},
                                          {kOutletPanel, "wall_outlet_panel", false},
                                          {kMonitor, "patient_monitor", false},
                                          {kTv, "tv", false},
                                          {kExtinguisher, "fire_extinguisher", false},
                                          {kDispenser, "dispenser", false},
                                          {kWhiteboard, "whiteboard", false}}};

const Kind& of(ItemKind kind) { return kKinds.at(static_cast<std::size_t>(kind)); }

Surfaces makeOccupied(const Item& item, cv::RNG& rng) {
  Surfaces bed = makeBed(item.variant, rng);
  if (!item.occupied) return bed;
  const Surfaces cover = makeCoveredBody(rng);
  bed.insert(bed.end(), cover.begin(), cover.end());
  return bed;
}

/// The corners of a footprint, world frame.
std::array<Vector2d, 4> cornersOf(const Item& item, double grown_m) {
  std::array<Vector2d, 4> corners;
  const Vector2d low = item.footprint_m.min().array() - grown_m;
  const Vector2d high = item.footprint_m.max().array() + grown_m;
  const std::array<Vector2d, 4> own = {low, {high.x(), low.y()}, high, {low.x(), high.y()}};
  const Eigen::Isometry3d T = item.T_world_item.cast<double>();
  for (std::size_t i = 0; i < 4; ++i) corners[i] = (T * Eigen::Vector3d(own[i].x(), own[i].y(), 0)).head<2>();
  return corners;
}

/// Whether a line along a side of `a` parts the two.
bool parted(const std::array<Vector2d, 4>& a, const std::array<Vector2d, 4>& b) {
  for (std::size_t i = 0; i < 2; ++i) {
    const Vector2d axis = a[i + 1] - a[i];
    const auto rangeOf = [&](const std::array<Vector2d, 4>& corners) {
      double low = std::numeric_limits<double>::infinity();
      double high = -low;
      for (const Vector2d& corner : corners) {
        low = std::min(low, axis.dot(corner));
        high = std::max(high, axis.dot(corner));
      }
      return std::pair(low, high);
    };
    const auto [lowA, highA] = rangeOf(a);
    const auto [lowB, highB] = rangeOf(b);
    if (highA < lowB || highB < lowA) return true;
  }
  return false;
}

}  // namespace

core::ClassId classIdOf(ItemKind kind) { return of(kind).classId; }
const char* classNameOf(ItemKind kind) { return of(kind).className; }
bool isMovable(ItemKind kind) { return of(kind).movable; }
std::string nameOf(const Item& item) { return std::string(classNameOf(item.kind)) + "_" + std::to_string(item.number); }

Surfaces modelOf(const Item& item) {
  cv::RNG rng(item.modelSeed + 1);
  switch (item.kind) {
    case ItemKind::Bed:
      return makeOccupied(item, rng);
    case ItemKind::Cabinet:
      return makeBedsideCabinet(rng);
    case ItemKind::IvStand:
      return makeIvStand(rng);
    case ItemKind::Chair:
      return makeChair(rng);
    case ItemKind::Trolley:
      return makeTrolley(rng);
    case ItemKind::Wheelchair:
      return makeWheelchair(rng);
    case ItemKind::Screen:
      return makeFoldingScreen(rng);
    case ItemKind::TrashBin:
      return makeTrashBin(rng);
    case ItemKind::Plant:
      return makePlant(rng);
    case ItemKind::Table:
      return makeTable(rng);
    case ItemKind::Curtain:
      return makeCurtain(item.size_m, 2.3F, kHospitalCeiling_m, rng);
    case ItemKind::Shelf:
      return makeShelf(item.size_m, rng);
    case ItemKind::Counter:
      return makeCounter(item.size_m, rng);
    case ItemKind::Desk:
      return makeDesk(rng);
    case ItemKind::Toilet:
      return makeToilet(rng);
    case ItemKind::Basin:
      return makeBasin(rng);
    case ItemKind::DoorLeaf:
      return makeDoorLeaf(item.size_m, 2.06F, item.opening_rad, rng);
    case ItemKind::Window:
      return makeWindow(item.size_m, 0.1F * static_cast<float>(item.variant), rng);
    case ItemKind::Picture:
      return makePicture(item.variant, item.size_m, rng);
    case ItemKind::Sign:
      return makeSign(item.variant, item.size_m, rng);
    case ItemKind::HangingSign:
      return makeHangingSign(item.variant, kHospitalCeiling_m, rng);
    case ItemKind::Outlets:
      return makeOutletPanel(rng);
    case ItemKind::Monitor:
      return makePatientMonitor(rng);
    case ItemKind::Television:
      return makeTelevision(rng);
    case ItemKind::Extinguisher:
      return makeExtinguisher(rng);
    case ItemKind::Dispenser:
      return makeDispenser(rng);
    case ItemKind::Whiteboard:
      return makeWhiteboard(rng);
  }
  return {};
}

Eigen::AlignedBox2d footprintOf(const Item& item) {
  constexpr ItemKind kFlat[] = {ItemKind::Window,  ItemKind::Picture, ItemKind::Television,
                                ItemKind::Outlets, ItemKind::Monitor, ItemKind::Whiteboard};
  Eigen::AlignedBox2d box;
  if (std::find(std::begin(kFlat), std::end(kFlat), item.kind) != std::end(kFlat)) return box;
  for (const Surface& surface : modelOf(item)) {
    for (const Vertex& vertex : surface.mesh.vertices) {
      if (vertex.p_m.z() < kHeadroom_m) box.extend(vertex.p_m.head<2>().cast<double>().eval());
    }
  }
  return box;
}

Vector2d middleOf(const Item& item) {
  const Vector2d own = item.footprint_m.isEmpty() ? Vector2d::Zero() : Vector2d(item.footprint_m.center());
  return (item.T_world_item.cast<double>() * Eigen::Vector3d(own.x(), own.y(), 0)).head<2>();
}

double distanceTo(const Item& item, const Vector2d& p_m) {
  if (item.footprint_m.isEmpty()) return std::numeric_limits<double>::infinity();
  const Eigen::Vector3d own = item.T_world_item.cast<double>().inverse() * Eigen::Vector3d(p_m.x(), p_m.y(), 0);
  return item.footprint_m.exteriorDistance(Vector2d(own.head<2>()));
}

bool collide(const Item& a, const Item& b, double gap_m) {
  if (a.footprint_m.isEmpty() || b.footprint_m.isEmpty()) return false;
  const auto cornersA = cornersOf(a, gap_m);
  const auto cornersB = cornersOf(b, 0.0);
  return !parted(cornersA, cornersB) && !parted(cornersB, cornersA);
}

}  // namespace wardslam::synth
