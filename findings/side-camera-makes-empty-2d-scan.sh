#!/usr/bin/env bash
# convertTo2DScan() of CObservation3DRangeScan in MRPT 2.5.8 (Debian 12), asked for a scan as from the robot's origin
# (use_origin_sensor_pose), looks ahead of the robot with the camera's field of view, wherever the camera looks. Of a camera
# that looks to the side or back the scan comes out without a single valid range, and nothing is said.
#
# A robot with cameras all around sees obstacles ahead only. Without the option, the scan is right.
# MRPT 2.14.7 (Debian 13) does the same.
#
# usage: side-camera-makes-empty-2d-scan.sh [--root DIR]   (as root; DIR: a Debian 12 with libmrpt-maps-dev, g++ and cmake in it.
#        Without it, such a root is made with debootstrap in a temporary folder, some 3 GB, and removed at the end.)
# Ends with 0 while the fault is there, with 1 where anything is different.
set -euo pipefail

readonly PACKAGE=libmrpt-maps-dev VERSION='1:2.5.8+ds-2' SUITE=bookworm
readonly -a TOOLS=(g++ cmake)

# shellcheck source=findings/support/debian_root.bash
source "$(dirname "${BASH_SOURCE[0]}")/support/debian_root.bash"

# A wall 2 m before a camera of 64 x 48 px, which looks ahead or to the robot's left.
program() {
  cat <<'CPP'
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservation3DRangeScan.h>

#include <cmath>
#include <cstdio>

int main() {
  for (const double yaw : {0.0, M_PI / 2.0}) {
    mrpt::obs::CObservation3DRangeScan camera;
    camera.sensorPose = mrpt::poses::CPose3D(0.0, 0.0, 1.0, yaw, 0.0, 0.0);
    camera.hasRangeImage = true;
    camera.rangeImage_setSize(48, 64);
    camera.rangeImage.fill(2000);
    camera.rangeUnits = 0.001F;
    camera.maxRange = 10.0F;
    camera.cameraParams.ncols = 64;
    camera.cameraParams.nrows = 48;
    camera.cameraParams.setIntrinsicParamsFromValues(50.0, 50.0, 31.5, 23.5);
    for (const bool isFromOrigin : {false, true}) {
      mrpt::obs::T3DPointsTo2DScanParams options;
      options.z_min = -10.0;
      options.z_max = 10.0;
      options.use_origin_sensor_pose = isFromOrigin;
      mrpt::obs::CObservation2DRangeScan scan;
      camera.convertTo2DScan(scan, options);
      mrpt::maps::CSimplePointsMap points;
      points.insertionOptions.minDistBetweenLaserPoints = 0.0F;
      points.insertObservation(scan);
      std::printf("looks %s, scan from the %s: %s\n", yaw > 0.0 ? "left" : "ahead", isFromOrigin ? "origin" : "camera",
                  points.empty() ? "no points" : "points");
    }
  }
}
CPP
}

enter_root "$@"
program | build_program
echo 'input: a range image of a wall 2 m before the camera, with the camera looking ahead and to the left of the robot'
seen=$(in_root build/look)
printf 'should be: points in all four\nis:\n%s\n' "$seen"
[[ $seen == *'ahead, scan from the camera: points'*'ahead, scan from the origin: points'*'left, scan from the camera: points'*'left, scan from the origin: no points' ]] ||
  die "that is not the fault described here any more"
echo 'The fault is there: as from the origin, what a camera sees beside the robot is in no scan.'
