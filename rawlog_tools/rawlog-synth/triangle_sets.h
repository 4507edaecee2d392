#pragma once

#include <mrpt/opengl/CSetOfTexturedTriangles.h>
#include <mrpt/opengl/CSetOfTriangles.h>

#include <cstddef>
#include <vector>

#include "mesh.h"

namespace wardslam::synth {

/// Textured triangles that come many at a time: MRPT's own way in takes two locks and a walk over all contexts for
/// each.
class TexturedSet : public mrpt::opengl::CSetOfTexturedTriangles {
 public:
  /// Three vertices for each triangle.
  void append(const Vertex* vertices, std::size_t triangles);
  void append(const Mesh& mesh) { append(mesh.vertices.data(), mesh.vertices.size() / 3); }
};

/// Triangles in the colours of their numbers, which travel so through the renderer; black is none.
class NumberedSet {
 public:
  NumberedSet();

  void clear() { collected_.clear(); }
  void append(const Vertex* vertices, std::size_t triangles, std::size_t firstNumber);
  /// What is drawn from now on is what has been collected.
  void show();
  [[nodiscard]] const mrpt::opengl::CSetOfTriangles::Ptr& drawn() const { return drawn_; }

 private:
  std::vector<mrpt::opengl::TTriangle> collected_;
  mrpt::opengl::CSetOfTriangles::Ptr drawn_ = mrpt::opengl::CSetOfTriangles::Create();
};

}  // namespace wardslam::synth
