#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "wardslam/core/blob.h"
#include "wardslam/core/keypoint.h"
#include "wardslam/mapping/map_memory.h"
#include "wardslam/mapping/semantic_cloud_tile.h"
#include "wardslam/odometry/depth_view.h"

/// What the blobs hold; docs/file_formats.md has the layouts. Values are kept column by column (all x, then all y, …),
/// which compresses better. Decoders throw BlobError on anything that is not whole.
namespace wardslam::storage {

[[nodiscard]] core::Bytes encodeFeatures(const core::Features& features);
[[nodiscard]] core::Features decodeFeatures(const core::Bytes& blob);

[[nodiscard]] core::Bytes encodeTile(const mapping::SemanticCloudTile& tile);
[[nodiscard]] mapping::SemanticCloudTile decodeTile(const core::Bytes& blob);

[[nodiscard]] core::Bytes encodeTileMemory(const mapping::TileMemory& tile);
[[nodiscard]] mapping::TileMemory decodeTileMemory(const core::Bytes& blob);

/// Points in a camera frame (m).
[[nodiscard]] core::Bytes encodeFan(const std::vector<Eigen::Vector3f>& fan_cam_m);
[[nodiscard]] std::vector<Eigen::Vector3f> decodeFan(const core::Bytes& blob);

[[nodiscard]] core::Bytes encodeDepthView(const odometry::DepthView& view);
[[nodiscard]] odometry::DepthView decodeDepthView(const core::Bytes& blob);

/// CV_8UC1.
[[nodiscard]] core::Bytes encodeCells(const cv::Mat& cells);
[[nodiscard]] cv::Mat decodeCells(const core::Bytes& blob);

}  // namespace wardslam::storage
