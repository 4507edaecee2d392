#pragma once

#include "wardslam/core/segmentation.h"

namespace wardslam::synth {

/// Numbers of COCO and of config/labels/hospital.yaml.
enum Class : core::ClassId {
  kPerson = 1,
  kChair = 57,
  kPlant = 59,
  kBed = 60,
  kTable = 61,
  kToilet = 62,
  kTv = 63,
  kSink = 72,
  kCurtain = 101,
  kTrolley = 102,
  kIvStand = 103,
  kCabinet = 104,
  kWheelchair = 105,
  kTrashBin = 106,
  kNurseStation = 107,
  kPicture = 110,
  kMonitor = 113,
  kRack = 114,
  kSign = 116,
  kExtinguisher = 117,
  kWhiteboard = 118,
  kDispenser = 119,
  kOutletPanel = 120,
  kDoor = 132,
  kWindow = 133,
  kScreen = 134,
  kMedicalDevice = 135
};

}  // namespace wardslam::synth
