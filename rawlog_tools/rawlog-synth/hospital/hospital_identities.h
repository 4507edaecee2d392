#pragma once

namespace wardslam::synth {

/// Instance ids of a hospital, 16 bits for all storeys and days. One belongs to one thing and is never given again.
///
/// | storey | furnished  | visitors       | new on later days | patients (plus the number of their bed) |
/// |--------|------------|----------------|-------------------|-----------------------------------------|
/// | 0      | 1 …        | 10000 …        | 20000 …           | 40000 …                                 |
/// | 1      | 2001 …     | 12500 …        | 30000 …           | 41000 …                                 |
/// | 2      | 4001 …     | 15000 …        | 45000 …           | 42000 …                                 |
/// | 3      | 6001 …     | 17500 …        | 55000 …           | 43000 …                                 |
constexpr int kMostStoreys = 4;
constexpr int kIdentitiesPerStorey = 2000;  ///< Of what stands there on day 0.
constexpr int kNumbersPerStorey = 1000;     ///< Item::number, of each class.

constexpr int firstVisitorId(int storey) { return 10000 + 2500 * storey; }
/// Identities of what comes new begin here.
constexpr int firstNewIdentity(int storey) { return (storey < 2 ? 20000 : 25000) + 10000 * storey; }
constexpr int kFirstNewIdentity = firstNewIdentity(0);
constexpr int kFirstPatientId = 40000;  ///< Plus the number of their bed, which tells storeys apart.

}  // namespace wardslam::synth
