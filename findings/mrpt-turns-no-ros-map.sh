#!/usr/bin/env bash
# COccupancyGridMap2D of MRPT 2.5.8 (Debian 12) reads a map of ROS map_server as if it lay straight in its frame: the third
# number of `origin`, by which the map is turned, is left out without a word. Nav2's map server turns it. And the corner
# is moved to a multiple of the resolution: everything is off by up to half a cell in x and in y.
#
# A robot of MRPT that takes over such a map of a fleet stands in other rooms than its colleagues.
# MRPT 2.14.7 (Debian 13) does the same.
#
# usage: mrpt-turns-no-ros-map.sh [--root DIR]   (as root; DIR: a Debian 12 with libmrpt-maps-dev, g++ and cmake in it.
#        Without it, such a root is made with debootstrap in a temporary folder, some 3 GB, and removed at the end.)
# Ends with 0 while the fault is there, with 1 where anything is different.
set -euo pipefail

readonly PACKAGE=libmrpt-maps-dev VERSION='1:2.5.8+ds-2' SUITE=bookworm
readonly -a TOOLS=(g++ cmake)

# shellcheck source=findings/support/debian_root.bash
source "$(dirname "${BASH_SOURCE[0]}")/support/debian_root.bash"

# A map of 3 x 2 cells of 0.1 m; the first cell of the upper row is occupied.
program() {
  cat <<'CPP'
#include <mrpt/maps/COccupancyGridMap2D.h>

#include <cmath>
#include <cstdio>
#include <fstream>

int main() {
  std::ofstream("map.pgm", std::ios::binary) << "P5\n3 2\n255\n" << '\0' << "\xFE\xFE\xFE\xFE\xFE";
  for (const char* origin : {"[1.0, 2.0, 1.5707963]", "[1.03, 2.07, 0.0]"}) {
    std::ofstream("map.yaml") << "image: map.pgm\nresolution: 0.1\norigin: " << origin
                              << "\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";
    const auto map = mrpt::maps::COccupancyGridMap2D::FromROSMapServerYAML("map.yaml");
    for (unsigned row = 0; row < map.getSizeY(); ++row) {
      for (unsigned column = 0; column < map.getSizeX(); ++column) {
        if (map.getCell(static_cast<int>(column), static_cast<int>(row)) > 0.5F) continue;
        std::printf("origin %s: occupied at (%.2f %.2f)\n", origin, map.getXMin() + 0.1 * (column + 0.5),
                    map.getYMin() + 0.1 * (row + 0.5));
      }
    }
  }
}
CPP
}

enter_root "$@"
program | build_program
echo 'input: a map of 3 x 2 cells of 0.1 m, the first cell of its upper row occupied, at two origins'
seen=$(in_root build/look)
printf 'should be: (0.85 2.05), a quarter turn about (1 2), and (1.08 2.22)\nis:\n%s\n' "$seen"
[[ $seen == *'1.5707963]: occupied at (1.05 2.15)'*'0.0]: occupied at (1.05 2.25)' ]] ||
  die "that is not the fault described here any more"
echo 'The fault is there: the map is not turned, and its corner is moved.'
