#pragma once

#include <filesystem>

#include "gates/gates_support.h"

/// The round through two rooms and a corridor that several tests share. FloorFixture's tests make it
/// (floor_fixture_test.cpp); the others only read it, and skip where it is not there.
namespace wardslam::gates {

[[nodiscard]] std::filesystem::path floorFolder();

inline Rendering floorRendering() { return {floorFolder() / "floor.rawlog"}; }
inline Run floorRun() { return {floorFolder() / "deterministic"}; }
inline Run floorRunWithThreads() { return {floorFolder() / "threads"}; }
inline Run floorRunInRealTime() { return {floorFolder() / "realtime"}; }

}  // namespace wardslam::gates
