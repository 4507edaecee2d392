#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "wardslam/core/keypoint.h"
#include "wardslam/mapping/semantic_cloud_tile.h"
#include "wardslam/storage/blob.h"

/// What the blobs hold; docs/file_formats.md has the layouts. Values are kept column by column (all x, then all y, …),
/// which compresses better. Decoders throw BlobError on anything that is not whole.
namespace wardslam::storage {

[[nodiscard]] Bytes encodeFeatures(const core::Features& features);
[[nodiscard]] core::Features decodeFeatures(const Bytes& blob);

[[nodiscard]] Bytes encodeTile(const mapping::SemanticCloudTile& tile);
[[nodiscard]] mapping::SemanticCloudTile decodeTile(const Bytes& blob);

/// Points in a camera frame (m).
[[nodiscard]] Bytes encodeFan(const std::vector<Eigen::Vector3f>& fan_cam_m);
[[nodiscard]] std::vector<Eigen::Vector3f> decodeFan(const Bytes& blob);

/// CV_8UC1.
[[nodiscard]] Bytes encodeCells(const cv::Mat& cells);
[[nodiscard]] cv::Mat decodeCells(const Bytes& blob);

}  // namespace wardslam::storage
