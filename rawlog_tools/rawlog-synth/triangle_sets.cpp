#include "triangle_sets.h"

#include <cstdint>
#include <mutex>
#include <shared_mutex>

namespace wardslam::synth {
namespace {

namespace gl = mrpt::opengl;

void fill(gl::TTriangle& triangle, const Vertex* corner, const mrpt::img::TColor& color) {
  for (std::size_t i = 0; i < 3; ++i) {
    const Vertex& vertex = corner[i];
    auto& out = triangle.vertices[i];
    out.xyzrgba.pt = {vertex.p_m.x(), vertex.p_m.y(), vertex.p_m.z()};
    out.normal = {vertex.normal.x(), vertex.normal.y(), vertex.normal.z()};
    out.uv = {vertex.uv.x(), vertex.uv.y()};
    out.setColor(color);
  }
}

mrpt::img::TColor colorOf(std::size_t triangle) {
  const auto code = static_cast<std::uint32_t>(triangle + 1);
  return {static_cast<std::uint8_t>(code), static_cast<std::uint8_t>(code >> 8U),
          static_cast<std::uint8_t>(code >> 16U)};
}

}  // namespace

void TexturedSet::append(const Vertex* vertices, std::size_t triangles) {
  const std::unique_lock<std::shared_mutex> lock(m_trianglesMtx.data);
  const std::size_t first = m_triangles.size();
  m_triangles.resize(first + triangles);
  for (std::size_t i = 0; i < triangles; ++i) fill(m_triangles[first + i], vertices + 3 * i, {255, 255, 255});
  CRenderizable::notifyChange();
}

NumberedSet::NumberedSet() {
  drawn_->enableLight(false);  // a number is no colour to be lit; and the lit shader inverts a matrix for every vertex
}

void NumberedSet::append(const Vertex* vertices, std::size_t triangles, std::size_t firstNumber) {
  const std::size_t first = collected_.size();
  collected_.resize(first + triangles);
  for (std::size_t i = 0; i < triangles; ++i) fill(collected_[first + i], vertices + 3 * i, colorOf(firstNumber + i));
}

void NumberedSet::show() {
  drawn_->clearTriangles();
  drawn_->insertTriangles(collected_.begin(), collected_.end());
}

}  // namespace wardslam::synth
