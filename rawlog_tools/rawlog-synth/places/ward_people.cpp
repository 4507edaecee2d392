#include "places/ward_people.h"

namespace wardslam::synth {

Walker porterWalk() {
  // Pushes the trolley across the aisle into the gap between two beds, leaves it, rests by the window.
  return Walker({{0.0, {5.9, 1.0}},
                 {2.2, {5.86, 2.3}},
                 {4.4, {5.8, 3.75}},
                 {6.6, {5.8, 3.75}},
                 {7.6, {6.3, 3.6}},
                 {9.0, {7.6, 3.4}},
                 {10.6, {8.4, 2.6}},
                 {30.0, {8.4, 2.6}},
                 {32.0, {6.5, 2.5}},
                 {34.0, {6.5, 2.5}},
                 {36.5, {8.4, 2.6}},
                 {48.6, {8.4, 2.6}}},
                10.6);
}

Walker nurseWalk() {
  // Overtakes the camera, crosses right in front of it, sees to a bed; later comes towards the camera.
  // clang-format off
  return Walker({{-2.0, {1.0, 3.5}},
                 {-1.0, {2.3, 3.35}},
                 {0.0, {3.4, 3.2}},
                 {0.9, {4.2, 2.8}},
                 {1.8, {4.2, 2.0}},
                 {2.9, {3.95, 1.2}},
                 {12.0, {3.95, 1.2}},
                 {13.2, {3.9, 2.1}},
                 {14.4, {3.2, 2.9}},
                 {16.0, {3.7, 3.5}},
                 {17.4, {4.85, 3.65}},
                 {18.1, {5.35, 3.2}},
                 {18.9, {6.0, 2.8}},
                 {19.8, {7.0, 2.75}},
                 {20.6, {7.5, 2.7}},
                 {24.0, {7.5, 2.7}},
                 {25.8, {5.9, 2.4}},
                 {27.4, {4.2, 2.3}},
                 {28.8, {3.95, 1.2}},
                 {40.9, {3.95, 1.2}}},
                2.9);
  // clang-format on
}

Walker visitorWalk() {
  // From the table to the bed by the window and back.
  return Walker({{0.0, {8.35, 1.8}},
                 {5.5, {8.35, 1.8}},
                 {7.2, {8.1, 3.0}},
                 {8.4, {8.1, 4.0}},
                 {9.6, {8.15, 4.9}},
                 {24.0, {8.15, 4.9}},
                 {25.2, {8.1, 4.0}},
                 {26.8, {8.1, 2.9}},
                 {28.4, {8.35, 1.8}},
                 {38.0, {8.35, 1.8}}},
                0.0);
}

}  // namespace wardslam::synth
