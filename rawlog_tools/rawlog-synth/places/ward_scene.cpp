#include "places/ward_scene.h"

#include <array>

#include "camera/camera_path.h"
#include "furniture/furniture.h"
#include "furniture/scene_builder.h"
#include "people/actors.h"
#include "people/people.h"
#include "places/ward_people.h"

namespace wardslam::synth {
namespace {

using Eigen::Isometry3f;

void addBedPlaces(SceneBuilder& ward) {
  const float w = ward.room().width_m;
  int number = 0;
  const auto addBedPlace = [&](const Isometry3f& wall) {
    ++number;
    ward.addBedPlace(number, wall, {number % 2 == 1, number != 2 && number != 5});
  };
  for (const float x : {1.6F, 4.4F, 7.2F}) addBedPlace(at(x, w, 0, kFromNorth_rad));
  for (const float x : {1.8F, 4.9F}) addBedPlace(at(x, 0, 0, kFromSouth_rad));
  for (const float x : {3.0F, 6.05F}) {
    ward.add("curtain", kCurtain, makeCurtain(ward.rng().uniform(0.9F, 1.3F), 2.1F, ward.room().height_m, ward.rng()),
             at(x - 0.2F, w - 0.08F, 0, kFromNorth_rad));
  }
  ward.add("curtain", kCurtain, makeCurtain(ward.rng().uniform(1.0F, 1.4F), 2.1F, ward.room().height_m, ward.rng()),
           at(3.2F, 0.08F, 0, kFromSouth_rad));
}

void addCorner(SceneBuilder& ward) {
  ward.stand("dining table", kTable, makeTable(ward.rng()), at(7.1F, 0.75F, 0, 0.2F), 0.7F, 0.7F);
  ward.stand("chair", kChair, makeChair(ward.rng()), ward.nudged(at(6.35F, 0.75F, 0, 0.1F)), 0.44F, 0.44F);
  ward.stand("chair", kChair, makeChair(ward.rng()), ward.nudged(at(7.2F, 1.5F, 0, -1.7F)), 0.44F, 0.44F);
  ward.stand("potted plant", kPlant, makePlant(ward.rng()), at(8.6F, 0.45F, 0), 0.36F, 0.36F);
  ward.stand("potted plant", kPlant, makePlant(ward.rng()), at(8.65F, 5.95F, 0, 1.0F), 0.36F, 0.36F);
  ward.stand("trash_bin", kTrashBin, makeTrashBin(ward.rng()), at(0.35F, 1.6F, 0), 0.36F, 0.4F);
  ward.add("tv", kTv, makeTelevision(ward.rng()), at(7.2F, 0, 1.75F, kFromSouth_rad));
}

void addPictures(SceneBuilder& ward) {
  struct Place {
    int poster = 0;
    float width_m = 0.5F;
    Isometry3f T = Isometry3f::Identity();
  };
  const float l = ward.room().length_m;
  const float w = ward.room().width_m;
  const std::array<Place, 12> places = {{{0, 0.55F, at(2.45F, w, 1.75F, kFromNorth_rad)},
                                         {1, 0.6F, at(5.35F, w, 1.8F, kFromNorth_rad)},
                                         {2, 0.5F, at(8.25F, w, 1.7F, kFromNorth_rad)},
                                         {9, 0.55F, at(0.55F, w, 1.7F, kFromNorth_rad)},
                                         {12, 0.5F, at(0.7F, 0, 1.75F, kFromSouth_rad)},
                                         {13, 0.55F, at(2.75F, 0, 1.7F, kFromSouth_rad)},
                                         {14, 0.6F, at(3.75F, 0, 1.75F, kFromSouth_rad)},
                                         {15, 0.5F, at(6.1F, 0, 1.7F, kFromSouth_rad)},
                                         {10, 0.45F, at(l, 0.65F, 1.7F, kFromEast_rad)},
                                         {11, 0.45F, at(l, 5.75F, 1.75F, kFromEast_rad)},
                                         {3, 0.5F, at(0, 2.1F, 1.75F, kFromWest_rad)},
                                         {8, 0.5F, at(0, 4.6F, 1.75F, kFromWest_rad)}}};
  for (const Place& place : places) ward.addPicture(place.poster, place.width_m, place.T);
}

void addTrolleyAndPeople(SceneBuilder& ward, bool people) {
  const Surfaces trolley = makeTrolley(ward.rng());
  auto actor = std::make_unique<TrolleyActor>(ward.label("trolley", kTrolley), porterWalk(), kTrolleyLeft_s, trolley);
  if (people) {
    ward.scene().actors.push_back(std::move(actor));
    addPeople(ward.scene(), ward.nextId(), {nurseWalk(), porterWalk(), visitorWalk(), {-10.0, kTrolleyLeft_s}});
    return;
  }
  ward.scene().things.push_back({actor->label(), actor->surfacesAt(kTrolleyLeft_s)});
}

}  // namespace

Scene buildWard(const SceneOptions& options) {
  SceneBuilder ward(RoomShape{}, options.seed);
  ward.addShell();
  addBedPlaces(ward);
  addCorner(ward);
  addPictures(ward);
  addTrolleyAndPeople(ward, options.people);
  return ward.take();
}

Setting wardSetting(const SceneOptions& options, const CameraMount& mount) {
  CameraPath path;
  path.mount = mount;
  Setting setting;
  setting.scene = buildWard(options);
  setting.T_world_cam = [path](double t_s) { return path.T_world_cam(t_s); };
  setting.duration_s = 20.0;
  return setting;
}

}  // namespace wardslam::synth
