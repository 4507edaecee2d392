#!/usr/bin/env bash
# COctoMap of MRPT 2.5.8 (Debian 12) puts the points of a CObservation3DRangeScan where they would be if the sensor stood
# at the robot's origin, looking ahead: sensorPose is left out. Maps of points put the same scan where it belongs.
#
# A camera on a mast of 1 m that looks to the left makes an OctoMap 1 m too low and ahead of the robot; the rays begin at
# the sensor all the same. Points of 2D scans are right. MRPT 2.14.7 (Debian 13) does the same.
#
# usage: octomap-overlooks-sensor-pose.sh [--root DIR]   (as root; DIR: a Debian 12 with libmrpt-maps-dev, g++ and cmake
#        in it. Without it, such a root is made with debootstrap in a temporary folder, some 3 GB, and removed at the end.)
# Ends with 0 while the fault is there, with 1 where anything is different.
set -euo pipefail

readonly PACKAGE=libmrpt-maps-dev VERSION='1:2.5.8+ds-2' SUITE=bookworm
readonly -a TOOLS=(g++ cmake)

# shellcheck source=findings/support/debian_root.bash
source "$(dirname "${BASH_SOURCE[0]}")/support/debian_root.bash"

# One point, 2.02 m ahead of a sensor that stands 1 m over the robot and looks to its left.
program() {
  cat <<'CPP'
#include <mrpt/maps/COctoMap.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CObservation3DRangeScan.h>

#include <cmath>
#include <cstdio>

int main() {
  mrpt::obs::CObservation3DRangeScan scan;
  scan.sensorPose = mrpt::poses::CPose3D(0.0, 0.0, 1.0, M_PI / 2.0, 0.0, 0.0);
  scan.maxRange = 10.0F;
  scan.hasPoints3D = true;
  scan.resizePoints3DVectors(1);
  scan.points3D_x[0] = 2.02F;
  scan.points3D_y[0] = scan.points3D_z[0] = 0.02F;
  scan.points3D_idxs_x[0] = scan.points3D_idxs_y[0] = 0;

  mrpt::maps::CSimplePointsMap points;
  points.insertObservation(scan);
  float x = 0, y = 0, z = 0;
  points.getPoint(0, x, y, z);
  std::printf("CSimplePointsMap has the point at (%.2f %.2f %.2f)\n", x, y, z);

  mrpt::maps::COctoMap cells(0.05);
  cells.insertObservation(scan);
  double there = 0.0, ahead = 0.0;
  const bool isThere = cells.getPointOccupancy(x, y, z, there) && there > 0.5;
  const bool isAhead = cells.getPointOccupancy(2.02F, 0.02F, 0.02F, ahead) && ahead > 0.5;
  std::printf("COctoMap has that place %s, and (2.02 0.02 0.02) %s\n", isThere ? "occupied" : "not occupied",
              isAhead ? "occupied" : "not occupied");
}
CPP
}

enter_root "$@"
program | build_program
echo 'input: a 3D scan of one point, 2.02 m ahead of a sensor at (0 0 1) of the robot that looks to its left'
seen=$(in_root build/look)
printf 'should be: occupied at (-0.02 2.02 1.02), where maps of points have it\nis: %s\n' "$seen"
[[ $seen == *'the point at (-0.02 2.02 1.02)'*'that place not occupied, and (2.02 0.02 0.02) occupied' ]] ||
  die "that is not the fault described here any more"
echo 'The fault is there: the OctoMap has the point where it would be without sensorPose.'
