#!/usr/bin/env bash
# MRPT 2.14.7 (Debian 13): while a texture drawn by one CFBORender lives, another in a second thread cannot draw its own.
#
# Each CFBORender has an OpenGL context of its own by default, "which enables using them in different threads" (its
# header). OpenGL numbers the textures of every context from 1; MRPT keeps one list, by these numbers, for the whole
# process, and throws where a number comes a second time. With MRPT 2.5.8 (Debian 12) both draw.
#
# usage: mrpt-textures-of-two-contexts.sh [--root DIR]   (as root; DIR: a Debian 13 with libmrpt-dev, g++, cmake, libegl1
#        and libgl1-mesa-dri in it. Without it, such a root is made with debootstrap in a temporary folder, some 5 GB, and
#        removed at the end.)
# Ends with 0 while the fault is there, with 1 where anything is different.
set -euo pipefail

readonly PACKAGE=libmrpt-dev VERSION='1:2.14.7+ds-1' SUITE=trixie

die() {
  printf '%s\n' "$*" >&2
  exit 1
}

make_root() { # make_root DIR
  debootstrap --variant=minbase "$SUITE" "$1" >&2
  chroot "$1" env DEBIAN_FRONTEND=noninteractive apt-get install --yes --no-install-recommends \
    "$PACKAGE" g++ cmake make libegl1 libegl-mesa0 libgl1-mesa-dri >&2
}

((EUID == 0)) || die "needs root, for chroot"
root='' made=''
if [[ ${1-} == --root ]]; then
  root=$(realpath "$2")
else
  (($# == 0)) || die "usage: $0 [--root DIR]"
  made=$(mktemp -d)
  trap 'rm -rf --one-file-system "$made"' EXIT
  root=$made
  make_root "$root"
fi
work=$(mktemp -d -p "$root/tmp")
trap 'rm -rf --one-file-system "$work" ${made:+"$made"}' EXIT

# shellcheck disable=SC2016 # dpkg-query's, not the shell's
version=$(chroot "$root" dpkg-query -W -f '${Version}' "$PACKAGE") || die "$root has no $PACKAGE"
printf '%s %s\n' "$PACKAGE" "$version"
[[ $version == "$VERSION"* ]] || die "this is about version $VERSION: look again"

cat >"$work/draw.cpp" <<'CPP'
// draw one: a thread draws a textured square twice, in one context. draw two: two threads draw one each, in turn.
#include <mrpt/img/CImage.h>
#include <mrpt/opengl/CFBORender.h>
#include <mrpt/opengl/CTexturedPlane.h>
#include <mrpt/opengl/Scene.h>

#include <cstdio>
#include <future>
#include <string>
#include <thread>

namespace {

/// Brightness of the middle of what is drawn: a grey square 2 m before the camera.
int draw(mrpt::opengl::CFBORender& target, mrpt::opengl::Scene& scene, int grey) {
  mrpt::img::CImage texture(16, 16, mrpt::img::CH_RGB);
  texture.filledRectangle(0, 0, 15, 15, mrpt::img::TColor(grey, grey, grey));
  auto plane = mrpt::opengl::CTexturedPlane::Create();
  plane->setPlaneCorners(-1, 1, -1, 1);
  plane->assignImage(texture);
  plane->enableLighting(false);
  scene.clear();
  scene.insert(plane);
  auto& camera = target.getCamera(scene);
  camera.setPointingAt(0, 0, 0);
  camera.setElevationDegrees(90);
  camera.setZoomDistance(2);
  mrpt::img::CImage drawn;
  target.render_RGB(scene, drawn);
  return *drawn.ptr<uint8_t>(32, 32);
}

std::string attempt(mrpt::opengl::CFBORender& target, mrpt::opengl::Scene& scene, int grey) {
  try {
    return "grey of " + std::to_string(grey) + " drawn as " + std::to_string(draw(target, scene, grey));
  } catch (const std::exception& error) {
    const std::string text = error.what();
    const auto at = text.find("Duplicated");
    return "exception: " + (at == std::string::npos ? text : text.substr(at, text.find('\n', at) - at));
  }
}

}  // namespace

int main(int argc, char** argv) {
  const bool two = argc > 1 && std::string(argv[1]) == "two";
  std::promise<void> isDrawn, isDone;
  std::thread first([&] {
    mrpt::opengl::CFBORender target(64, 64);
    mrpt::opengl::Scene scene;
    std::printf("first thread: %s\n", attempt(target, scene, 100).c_str());
    if (!two) std::printf("first thread: %s\n", attempt(target, scene, 200).c_str());
    isDrawn.set_value();
    isDone.get_future().wait();  // its context and its texture live on
  });
  isDrawn.get_future().wait();
  if (two) {
    std::thread second([] {
      mrpt::opengl::CFBORender target(64, 64);
      mrpt::opengl::Scene scene;
      std::printf("second thread: %s\n", attempt(target, scene, 200).c_str());
      std::fflush(stdout);
    });
    second.join();
  }
  isDone.set_value();
  first.join();
}
CPP
cat >"$work/CMakeLists.txt" <<'CMAKE'
cmake_minimum_required(VERSION 3.25)
project(draw C CXX)
find_package(mrpt-opengl REQUIRED)
add_executable(draw draw.cpp)
target_link_libraries(draw mrpt::opengl)
CMAKE
chroot "$root" sh -c "cd '${work#"$root"}' && cmake -S . -B . && cmake --build ." >&2 || die "the program does not compile"

run() { chroot "$root" "${work#"$root"}/draw" "$1" 2>/dev/null; }

one=$(run one) two=$(run two)
printf 'one context, two textures:\n%s\ntwo contexts, one texture each:\n%s\n' "$one" "$two"
[[ $one == $'first thread: grey of 100 drawn as 100\nfirst thread: grey of 200 drawn as 200' ]] ||
  die "one context: not as described"
[[ $two == $'first thread: grey of 100 drawn as 100\nsecond thread: exception: Duplicated `key` with different `value`' ]] ||
  die "two contexts: not as described"
printf 'the fault is as described\n'
