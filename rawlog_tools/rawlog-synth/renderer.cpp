#include "renderer.h"

#include <mrpt/opengl/CFBORender.h>
#include <mrpt/opengl/COpenGLScene.h>
#include <mrpt/opengl/CSetOfTexturedTriangles.h>
#include <mrpt/opengl/CSetOfTriangles.h>

#include <algorithm>
#include <cstdlib>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "triangle_view.h"
#include "wardslam/core/errors.h"
#include "wardslam/core/mrpt_compat.h"
#include "wardslam/core/mrpt_opengl_compat.h"

namespace wardslam::synth {
namespace {

namespace gl = mrpt::opengl;

/// Colour is rendered this much larger and averaged down: MRPT's textures have no mip maps.
constexpr double kSupersampling = 1.5;
constexpr float kNear_m = 0.2F;
constexpr float kFar_m = 30.0F;

gl::TTriangle toTriangle(const Vertex* corner, const mrpt::img::TColor& color) {
  gl::TTriangle triangle;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vertex& vertex = corner[i];
    auto& out = triangle.vertices[i];
    out.xyzrgba.pt = {vertex.p_m.x(), vertex.p_m.y(), vertex.p_m.z()};
    out.normal = {vertex.normal.x(), vertex.normal.y(), vertex.normal.z()};
    out.uv = {vertex.uv.x(), vertex.uv.y()};
    out.setColor(color);
  }
  return triangle;
}

/// Triangle numbers travel through the renderer as colours; black is none.
mrpt::img::TColor colorOf(std::size_t triangle) {
  const auto code = static_cast<std::uint32_t>(triangle + 1);
  return {static_cast<std::uint8_t>(code), static_cast<std::uint8_t>(code >> 8U),
          static_cast<std::uint8_t>(code >> 16U)};
}

cv::Mat numbersOf(const cv::Mat& bgr) {
  cv::Mat numbers(bgr.size(), CV_32SC1);
  numbers.forEach<int>([&](int& number, const int* at) {
    const auto& code = bgr.at<cv::Vec3b>(at[0], at[1]);
    number = code[2] + (code[1] << 8) + (code[0] << 16) - 1;
  });
  return numbers;
}

void insertTextured(gl::CSetOfTexturedTriangles& set, const Mesh& mesh) {
  for (std::size_t i = 0; i + 2 < mesh.vertices.size(); i += 3)
    set.insertTriangle(toTriangle(&mesh.vertices[i], {255, 255, 255}));
}

/// Adds the mesh to the flat set and to the list, so that colours and numbers agree.
void insertNumbered(gl::CSetOfTriangles& set, TriangleList& list, const Mesh& mesh, std::uint16_t instanceId) {
  for (std::size_t i = 0; i + 2 < mesh.vertices.size(); i += 3) {
    set.insertTriangle(toTriangle(&mesh.vertices[i], colorOf(list.size() + i / 3)));
  }
  list.add(mesh, instanceId);
}

gl::CSetOfTexturedTriangles::Ptr texturedSet(const cv::Mat& texture) {
  auto set = gl::CSetOfTexturedTriangles::Create();
  set->enableTextureLinearInterpolation(true);
  set->assignImage(mrpt::img::CImage(texture, mrpt::img::SHALLOW_COPY));
  return set;
}

/// Soft dark spots that are laid on the floor under what moves; the furniture's are painted on it.
gl::CSetOfTexturedTriangles::Ptr shadowSet() {
  constexpr int kSize_px = 64;
  cv::Mat alpha(kSize_px, kSize_px, CV_8UC1);
  alpha.forEach<std::uint8_t>([](std::uint8_t& a, const int* at) {
    const double x = (at[1] + 0.5) / kSize_px * 2 - 1;
    const double y = (at[0] + 0.5) / kSize_px * 2 - 1;
    const double inside = std::max(0.0, 1 - x * x - y * y);
    a = cv::saturate_cast<std::uint8_t>(120 * inside * inside);
  });
  auto set = gl::CSetOfTexturedTriangles::Create();
  set->enableTextureLinearInterpolation(true);
  set->assignImage(mrpt::img::CImage(cv::Mat(alpha.size(), CV_8UC3, cv::Scalar::all(20)), mrpt::img::DEEP_COPY),
                   mrpt::img::CImage(alpha, mrpt::img::DEEP_COPY));
  return set;
}

/// `above_m`: each shadow at its own height, so that they do not fight where they overlap.
Mesh shadowUnder(const Surfaces& surfaces, float above_m) {
  constexpr float kSpread_m = 0.22F;
  Eigen::AlignedBox3f box;
  for (const Surface& surface : surfaces) {
    for (const Vertex& vertex : surface.mesh.vertices) box.extend(vertex.p_m);
  }
  const Eigen::Vector3f size = box.sizes() + Eigen::Vector3f::Constant(2 * kSpread_m);
  return panel({box.min().x() - kSpread_m, box.min().y() - kSpread_m, above_m}, {size.x(), 0, 0}, {0, size.y(), 0});
}

void prepare(gl::COpenGLScene& scene, float ambient, float diffuse) {
  auto& viewport = *scene.getViewport();
  viewport.setViewportClipDistances(kNear_m, kFar_m);
  viewport.setCustomBackgroundColor({0.0F, 0.0F, 0.0F});
  auto& light = viewport.lightParameters();
  core::setWhiteLight(light, ambient, diffuse);
  light.direction = mrpt::math::TVector3Df(-0.38F, 0.23F, -0.89F).unitarize();  // from the lamps and the window
}

/// OpenGL counts pixels from the corner of the image, a camera model from the centre of its first pixel.
mrpt::img::TCamera cornerBased(const core::CameraModel& camera, const cv::Size& size_px) {
  const double x = static_cast<double>(size_px.width) / camera.width_px;
  const double y = static_cast<double>(size_px.height) / camera.height_px;
  mrpt::img::TCamera out;
  out.ncols = static_cast<std::uint32_t>(size_px.width);
  out.nrows = static_cast<std::uint32_t>(size_px.height);
  out.setIntrinsicParamsFromValues(camera.fx_px * x, camera.fy_px * y, (camera.cx_px + 0.5) * x,
                                   (camera.cy_px + 0.5) * y);
  return out;
}

/// MRPT's shaders declare their matrices "mediump", and Mesa's software renderer takes that for 16-bit floats on
/// processors that have them: vertices would be off by millimetres and the nearer surface would not always win.
/// Without those instructions it computes in full precision. (And no slower.) A user's own setting is kept.
void askForFullPrecision() { setenv("GALLIUM_OVERRIDE_CPU_CAPS", "sse4.1", 0); }

std::unique_ptr<gl::CFBORender> makeTarget(const cv::Size& size_px, bool ownContext) {
  gl::CFBORender::Parameters parameters(static_cast<unsigned>(size_px.width), static_cast<unsigned>(size_px.height));
  askForFullPrecision();
  // Two contexts in one thread would hide each other; the second target shares the first one's.
  parameters.create_EGL_context = ownContext;
  try {
    return std::make_unique<gl::CFBORender>(parameters);
  } catch (const std::exception&) {
    throw core::InputError("nothing can be rendered on this machine: install libegl1 and libgl1-mesa-dri");
  }
}

}  // namespace

struct Renderer::Impl {
  Impl(const Scene& renderedScene, const core::CameraModel& model);
  void addThings();
  void addActor(const Actor& actor);
  void placeActors(double t_s);
  void sortForBlending(const Eigen::Isometry3d& T_world_cam);
  void aim(gl::CFBORender& target, const gl::COpenGLScene& what, const cv::Size& targetSize_px,
           const Eigen::Isometry3d& T_world_cam) const;

  struct ActorModel {
    std::vector<gl::CSetOfTexturedTriangles::Ptr> surfaces;
    gl::CSetOfTriangles::Ptr flat;
  };

  const Scene& scene;
  core::CameraModel camera;
  cv::Size size_px;
  cv::Size largeSize_px;
  // The targets own the OpenGL context: they must outlive the scenes' textures.
  std::unique_ptr<gl::CFBORender> colorTarget;
  std::unique_ptr<gl::CFBORender> numberTarget;
  gl::COpenGLScene colors;
  gl::COpenGLScene numbers;  ///< Each triangle in the colour of its number.
  TriangleList triangles;    ///< Those of the static things first.
  std::size_t staticTriangles = 0;
  std::vector<ActorModel> actors;
  std::vector<gl::CSetOfTexturedTriangles::Ptr> opaque;  ///< The building first.
  gl::CSetOfTexturedTriangles::Ptr shadows = shadowSet();
};

Renderer::Impl::Impl(const Scene& renderedScene, const core::CameraModel& model)
    : scene(renderedScene),
      camera(model),
      size_px(model.width_px, model.height_px),
      largeSize_px(cvRound(model.width_px * kSupersampling), cvRound(model.height_px * kSupersampling)),
      colorTarget(makeTarget(largeSize_px, true)),
      numberTarget(makeTarget(size_px, false)) {
  prepare(colors, 0.74F, 0.36F);
  prepare(numbers, 1.0F, 0.0F);
  addThings();
  for (const auto& actor : scene.actors) addActor(*actor);
  for (const auto& set : opaque) colors.insert(set);
  colors.insert(shadows);
}

void Renderer::Impl::addThings() {
  std::map<Material, gl::CSetOfTexturedTriangles::Ptr> byMaterial;
  auto flat = gl::CSetOfTriangles::Create();
  for (const Thing& thing : scene.things) {
    for (const Surface& surface : thing.surfaces) {
      auto& set = byMaterial[surface.material];
      if (!set) set = texturedSet(scene.textures.at(surface.material));
      insertTextured(*set, surface.mesh);
      insertNumbered(*flat, triangles, surface.mesh, thing.label.id);
    }
  }
  for (const auto& [material, set] : byMaterial) opaque.push_back(set);
  numbers.insert(flat);
  staticTriangles = triangles.size();
}

/// Empty sets with the actor's textures; placeActors() fills them.
void Renderer::Impl::addActor(const Actor& actor) {
  ActorModel actorModel;
  for (const Surface& surface : actor.surfacesAt(0.0)) {
    actorModel.surfaces.push_back(texturedSet(scene.textures.at(surface.material)));
    opaque.push_back(actorModel.surfaces.back());
  }
  actorModel.flat = gl::CSetOfTriangles::Create();
  numbers.insert(actorModel.flat);
  actors.push_back(std::move(actorModel));
}

void Renderer::Impl::placeActors(double t_s) {
  triangles.shrink(staticTriangles);
  shadows->clearTriangles();
  for (std::size_t i = 0; i < actors.size(); ++i) {
    const Surfaces surfaces = scene.actors[i]->surfacesAt(t_s);
    insertTextured(*shadows, shadowUnder(surfaces, 0.006F + 0.003F * static_cast<float>(i)));
    actors[i].flat->clearTriangles();
    for (std::size_t k = 0; k < surfaces.size(); ++k) {
      actors[i].surfaces[k]->clearTriangles();
      insertTextured(*actors[i].surfaces[k], surfaces[k].mesh);
      insertNumbered(*actors[i].flat, triangles, surfaces[k].mesh, scene.actors[i]->label().id);
    }
  }
}

void Renderer::Impl::sortForBlending(const Eigen::Isometry3d& T_world_cam) {
  // MRPT draws back to front by one point of each object. Shadows must come last, to blend with the floor; the
  // building before them, as what hides it then spares its shading.
  const auto pointAhead = [&](double distance_m) {
    const Eigen::Vector3f p = (T_world_cam * Eigen::Vector3d(0, 0, distance_m)).cast<float>();
    return mrpt::math::TPoint3Df(p.x(), p.y(), p.z());
  };
  for (std::size_t i = 0; i < opaque.size(); ++i) {
    opaque[i]->setLocalRepresentativePoint(pointAhead(2.0 + static_cast<double>(i)));
  }
  shadows->setLocalRepresentativePoint(pointAhead(1.0));
}

void Renderer::Impl::aim(gl::CFBORender& target, const gl::COpenGLScene& what, const cv::Size& targetSize_px,
                         const Eigen::Isometry3d& T_world_cam) const {
  gl::CCamera view;
  view.set6DOFMode(true);
  view.setProjectiveFromPinhole(cornerBased(camera, targetSize_px));
  view.setPose(core::toMrpt(T_world_cam));
  target.setCamera(what, view);
}

Renderer::Renderer(const Scene& scene, const core::CameraModel& camera)
    : impl_(std::make_unique<Impl>(scene, camera)) {}

Renderer::~Renderer() = default;

Rendering Renderer::render(double t_s, const Eigen::Isometry3d& T_world_cam) {
  Impl& impl = *impl_;
  impl.placeActors(t_s);
  impl.sortForBlending(T_world_cam);
  impl.aim(*impl.colorTarget, impl.colors, impl.largeSize_px, T_world_cam);
  impl.aim(*impl.numberTarget, impl.numbers, impl.size_px, T_world_cam);

  mrpt::img::CImage large;
  mrpt::img::CImage codes;
  impl.colorTarget->render_RGB(impl.colors, large);
  impl.numberTarget->render_RGB(impl.numbers, codes);

  Rendering out;
  cv::resize(large.asCvMatRef(), out.color_bgr, impl.size_px, 0, 0, cv::INTER_AREA);
  auto view = impl.triangles.lookedAt(numbersOf(codes.asCvMatRef()), impl.camera, T_world_cam);
  out.depth_m = view.depth_m;
  out.instanceIds = view.instanceIds;
  return out;
}

}  // namespace wardslam::synth
