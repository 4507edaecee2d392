#include "renderer.h"

#include <mrpt/opengl/CFBORender.h>
#include <mrpt/opengl/COpenGLScene.h>

#include <algorithm>
#include <cstdlib>
#include <mutex>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "chunks.h"
#include "lens.h"
#include "triangle_sets.h"
#include "triangle_view.h"
#include "wardslam/core/errors.h"
#include "wardslam/core/mrpt_compat.h"
#include "wardslam/core/mrpt_opengl_compat.h"

namespace wardslam::synth {
namespace {

namespace gl = mrpt::opengl;

/// Colour is rendered this much larger and averaged down: MRPT's textures have no mip maps.
constexpr double kSupersampling = 1.5;
/// Numbers seen through a lens are looked up in an image this much larger, so that they lie within a quarter pixel.
constexpr int kNumberScale = 2;
constexpr float kNear_m = 0.2F;
constexpr double kStep_m = 0.4;  ///< Backwards, to look around for what comes into view.

/// What NumberedSet wrote into the image.
cv::Mat numbersOf(const cv::Mat& bgr) {
  cv::Mat numbers(bgr.size(), CV_32SC1);
  numbers.forEach<int>([&](int& number, const int* at) {
    const auto& code = bgr.at<cv::Vec3b>(at[0], at[1]);
    number = code[2] + (code[1] << 8) + (code[0] << 16) - 1;
  });
  return numbers;
}

std::shared_ptr<TexturedSet> texturedSet(const cv::Mat& texture) {
  auto set = std::make_shared<TexturedSet>();
  set->enableTextureLinearInterpolation(true);
  set->assignImage(mrpt::img::CImage(texture, mrpt::img::SHALLOW_COPY));
  return set;
}

/// Soft dark spots that are laid on the floor under what moves; the furniture's are painted on it.
std::shared_ptr<TexturedSet> shadowSet() {
  constexpr int kSize_px = 64;
  cv::Mat alpha(kSize_px, kSize_px, CV_8UC1);
  alpha.forEach<std::uint8_t>([](std::uint8_t& a, const int* at) {
    const double x = (at[1] + 0.5) / kSize_px * 2 - 1;
    const double y = (at[0] + 0.5) / kSize_px * 2 - 1;
    const double inside = std::max(0.0, 1 - x * x - y * y);
    a = cv::saturate_cast<std::uint8_t>(120 * inside * inside);
  });
  auto set = std::make_shared<TexturedSet>();
  set->enableTextureLinearInterpolation(true);
  set->assignImage(mrpt::img::CImage(cv::Mat(alpha.size(), CV_8UC3, cv::Scalar::all(20)), mrpt::img::DEEP_COPY),
                   mrpt::img::CImage(alpha, mrpt::img::DEEP_COPY));
  return set;
}

/// Each actor's shadow lies at its own height; a crowd's must not rise to the knees.
float shadowHeight_m(std::size_t actor) {
  constexpr std::size_t kApart = 4;
  const auto apart = static_cast<float>(std::min(actor, kApart));
  const auto close = static_cast<float>(actor > kApart ? (actor - kApart) % 64 : 0);
  return 0.006F + 0.003F * apart + 0.0004F * close;
}

constexpr float kShadowSpread_m = 0.22F;

/// What is seen of an actor, whose bounds these are: its shadow falls around it.
Eigen::AlignedBox3f withItsShadow(const Eigen::AlignedBox3f& bounds_m, float floorZ_m) {
  const Eigen::Vector3f spread(kShadowSpread_m, kShadowSpread_m, 0);
  return Eigen::AlignedBox3f(bounds_m.min() - spread, bounds_m.max() + spread)
      .extend(Eigen::Vector3f(bounds_m.center().x(), bounds_m.center().y(), floorZ_m));
}

/// `z_m`: each shadow at its own height, so that they do not fight where they overlap.
Mesh shadowUnder(const Surfaces& surfaces, float z_m) {
  Eigen::AlignedBox3f box;
  for (const Surface& surface : surfaces) {
    for (const Vertex& vertex : surface.mesh.vertices) box.extend(vertex.p_m);
  }
  const Eigen::Vector3f size = box.sizes() + Eigen::Vector3f::Constant(2 * kShadowSpread_m);
  return panel({box.min().x() - kShadowSpread_m, box.min().y() - kShadowSpread_m, z_m}, {size.x(), 0, 0},
               {0, size.y(), 0});
}

/// OpenGL gives rows of whole words, MRPT leaves room for none but full ones: the image gets columns to its right, so
/// that its rows and those of the larger colours are whole.
core::CameraModel withWholeRows(core::CameraModel camera) {
  constexpr int kColumns = 8;
  camera.width_px = (camera.width_px + kColumns - 1) / kColumns * kColumns;
  return camera;
}

/// Sees a quarter more on each side: what a camera that turns will see soon.
core::CameraModel wider(core::CameraModel camera) {
  const int x_px = camera.width_px / 4;
  const int y_px = camera.height_px / 4;
  camera.width_px += 2 * x_px;
  camera.height_px += 2 * y_px;
  camera.cx_px += x_px;
  camera.cy_px += y_px;
  return camera;
}

void prepare(gl::COpenGLScene& scene, float farthest_m, float ambient, float diffuse) {
  auto& viewport = *scene.getViewport();
  viewport.setViewportClipDistances(kNear_m, farthest_m);
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
/// And each renderer has a thread of its own: those that Mesa would add only wait for each other.
void prepareMesa() {
  static std::once_flag once;  // the environment is no place for two threads
  std::call_once(once, [] {
    setenv("GALLIUM_OVERRIDE_CPU_CAPS", "sse4.1", 0);
    setenv("LP_NUM_THREADS", "0", 0);
  });
}

/// One thread at a time is in OpenGL. Mesa's software renderer looks, before it reads an image or writes a buffer,
/// through what all contexts of the process are about to draw (llvmpipe_is_resource_referenced() in Mesa 22.3), and
/// does not keep their threads from giving just that memory back: it read memory that was gone. Pixels are made by one
/// thread at a time in there anyway; scenes, people, lenses and noise are not, and files are packed in parallel.
std::mutex& openGl() {
  static std::mutex mutex;
  return mutex;
}

std::unique_ptr<gl::CFBORender> makeTarget(const cv::Size& size_px, bool ownContext) {
  gl::CFBORender::Parameters parameters(static_cast<unsigned>(size_px.width), static_cast<unsigned>(size_px.height));
  prepareMesa();
  // Two contexts in one thread would hide each other; the second target shares the first one's.
  parameters.create_EGL_context = ownContext;
  const std::lock_guard lock(openGl());
  try {
    return std::make_unique<gl::CFBORender>(parameters);
  } catch (const std::exception&) {
    throw core::InputError("nothing can be rendered on this machine: install libegl1 and libgl1-mesa-dri");
  }
}

cv::Mat drawn(gl::CFBORender& target, const gl::COpenGLScene& scene) {
  mrpt::img::CImage image;
  const std::lock_guard lock(openGl());
  target.render_RGB(scene, image);
  return image.asCvMatRef();
}

}  // namespace

struct Renderer::Impl {
  Impl(const Scene& renderedScene, const core::CameraModel& model);
  void addThings();
  void addActor(const Actor& actor);
  void placeThings(const Eigen::Isometry3d& T_world_cam, const Frustum& frustum);
  void placeActors(double t_s, const Eigen::Isometry3d& T_world_cam, const Frustum& frustum);
  void place(double t_s, const Eigen::Isometry3d& T_world_cam);
  void sortForBlending(const Eigen::Isometry3d& T_world_cam);
  void aim(gl::CFBORender& target, const gl::COpenGLScene& what, const cv::Size& targetSize_px,
           const Eigen::Isometry3d& T_world_cam) const;
  [[nodiscard]] cv::Mat withoutAddedColumns(const cv::Mat& image) const;
  [[nodiscard]] cv::Mat drawColors(const Eigen::Isometry3d& T_world_cam);
  [[nodiscard]] TriangleList::View drawNumbers(const Eigen::Isometry3d& T_world_cam);

  const Scene& scene;
  LensView lens;
  core::CameraModel camera;  ///< The pinhole that is rendered.
  cv::Size size_px;
  cv::Size largeSize_px;
  cv::Size numberSize_px;
  // The targets own the OpenGL context: they must outlive the scenes' textures.
  std::unique_ptr<gl::CFBORender> colorTarget;
  std::unique_ptr<gl::CFBORender> numberTarget;
  gl::COpenGLScene colors;
  gl::COpenGLScene numbers;  ///< Each triangle in the colour of its number.
  Chunks chunks;
  std::vector<bool> seen;  ///< The chunks that the sets hold now.
  std::map<Material, std::shared_ptr<TexturedSet>> things;
  NumberedSet flatThings;
  TriangleList triangles;  ///< Those of the static things first.
  std::size_t staticTriangles = 0;
  std::map<Material, std::shared_ptr<TexturedSet>> moving;  ///< Of all actors: each texture is there once.
  NumberedSet flatActors;
  std::vector<std::shared_ptr<TexturedSet>> opaque;  ///< The building first.
  std::shared_ptr<TexturedSet> shadows = shadowSet();
};

Renderer::Impl::Impl(const Scene& renderedScene, const core::CameraModel& model)
    : scene(renderedScene),
      lens(model),
      camera(withWholeRows(lens.pinhole())),
      size_px(camera.width_px, camera.height_px),
      largeSize_px(cvRound(camera.width_px * kSupersampling), cvRound(camera.height_px * kSupersampling)),
      numberSize_px(lens.isIdeal() ? size_px : size_px * kNumberScale),
      colorTarget(makeTarget(largeSize_px, true)),
      numberTarget(makeTarget(numberSize_px, false)),
      chunks(renderedScene) {
  prepare(colors, scene.farthest_m, 0.74F, 0.36F);
  prepare(numbers, scene.farthest_m, 1.0F, 0.0F);
  addThings();
  for (const auto& actor : scene.actors) addActor(*actor);
  for (const auto& set : opaque) colors.insert(set);
  colors.insert(shadows);
}

/// Empty sets with the materials' textures; placeThings() fills them.
void Renderer::Impl::addThings() {
  for (const Thing& thing : scene.things) {
    for (const Surface& surface : thing.surfaces) {
      auto& set = things[surface.material];
      if (!set) set = texturedSet(scene.textures.at(surface.material));
      triangles.add(surface.mesh, thing.label.id);
    }
  }
  for (const auto& [material, set] : things) opaque.push_back(set);
  numbers.insert(flatThings.drawn());
  numbers.insert(flatActors.drawn());
  staticTriangles = triangles.size();
}

/// Empty sets with the actor's textures; placeActors() fills them.
void Renderer::Impl::addActor(const Actor& actor) {
  for (const Surface& surface : actor.surfacesAt(0.0)) {
    auto& set = moving[surface.material];
    if (set) continue;
    set = texturedSet(scene.textures.at(surface.material));
    opaque.push_back(set);
  }
}

/// Fills the sets with the chunks in view and around it, so that they mostly hold them already.
void Renderer::Impl::placeThings(const Eigen::Isometry3d& T_world_cam, const Frustum& frustum) {
  const auto needed = chunks.seenFrom(T_world_cam, frustum);
  bool isComplete = !seen.empty();
  for (std::size_t i = 0; isComplete && i < needed.size(); ++i) isComplete = seen[i] || !needed[i];
  if (isComplete) return;
  seen = chunks.seenFrom(T_world_cam, Frustum(wider(camera), T_world_cam * Eigen::Translation3d(0, 0, -kStep_m),
                                              static_cast<double>(scene.farthest_m)));
  for (std::size_t i = 0; i < needed.size(); ++i) seen[i] = seen[i] || needed[i];
  for (const auto& [material, set] : things) set->clearTriangles();
  flatThings.clear();
  for (const Chunks::Run& run : chunks.runs()) {
    if (!seen[run.chunk]) continue;
    things.at(run.material)->append(run.vertices, run.triangles);
    flatThings.append(run.vertices, run.triangles, run.firstNumber);
  }
  flatThings.show();
}

void Renderer::Impl::placeActors(double t_s, const Eigen::Isometry3d& T_world_cam, const Frustum& frustum) {
  triangles.shrink(staticTriangles);
  shadows->clearTriangles();
  for (const auto& [material, set] : moving) set->clearTriangles();
  flatActors.clear();
  const CellView cells = chunks.cellsFrom(T_world_cam);
  for (std::size_t i = 0; i < scene.actors.size(); ++i) {
    const Actor& actor = *scene.actors[i];
    const Eigen::AlignedBox3f bounds_m = withItsShadow(actor.boundsAt(t_s), actor.floorZ_m());
    if (!frustum.mayShow(bounds_m) || !cells.mayShow(bounds_m)) continue;
    const Surfaces surfaces = actor.surfacesAt(t_s);
    shadows->append(shadowUnder(surfaces, actor.floorZ_m() + shadowHeight_m(i)));
    for (const Surface& surface : surfaces) {
      moving.at(surface.material)->append(surface.mesh);
      flatActors.append(surface.mesh.vertices.data(), surface.mesh.vertices.size() / 3, triangles.size());
      triangles.add(surface.mesh, actor.label().id);
    }
  }
  flatActors.show();
}

void Renderer::Impl::place(double t_s, const Eigen::Isometry3d& T_world_cam) {
  const Frustum frustum(camera, T_world_cam, static_cast<double>(scene.farthest_m));
  placeThings(T_world_cam, frustum);
  placeActors(t_s, T_world_cam, frustum);
  sortForBlending(T_world_cam);
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

cv::Mat Renderer::Impl::withoutAddedColumns(const cv::Mat& image) const {
  const int width_px = lens.pinhole().width_px * (image.cols / camera.width_px);
  return image.cols == width_px ? image : image.colRange(0, width_px).clone();
}

/// BGR, through the lens.
cv::Mat Renderer::Impl::drawColors(const Eigen::Isometry3d& T_world_cam) {
  aim(*colorTarget, colors, largeSize_px, T_world_cam);
  const cv::Mat large = drawn(*colorTarget, colors);
  cv::Mat small;
  cv::resize(large, small, size_px, 0, 0, cv::INTER_AREA);
  return lens.colours(withoutAddedColumns(small));
}

TriangleList::View Renderer::Impl::drawNumbers(const Eigen::Isometry3d& T_world_cam) {
  aim(*numberTarget, numbers, numberSize_px, T_world_cam);
  const cv::Mat codes = drawn(*numberTarget, numbers);
  return triangles.lookedAt(numbersOf(lens.nearest(withoutAddedColumns(codes))), lens, T_world_cam);
}

Renderer::Renderer(const Scene& scene, const core::CameraModel& camera)
    : impl_(std::make_unique<Impl>(scene, camera)) {}

Renderer::~Renderer() {
  const std::lock_guard lock(openGl());
  impl_.reset();
}

Rendering Renderer::render(double t_s, const Eigen::Isometry3d& T_world_cam) {
  impl_->place(t_s, T_world_cam);
  Rendering out;
  out.color_bgr = impl_->drawColors(T_world_cam);
  const auto view = impl_->drawNumbers(T_world_cam);
  out.depth_m = view.depth_m;
  out.instanceIds = view.instanceIds;
  return out;
}

cv::Mat Renderer::renderColor(double t_s, const Eigen::Isometry3d& T_world_cam) {
  impl_->place(t_s, T_world_cam);
  return impl_->drawColors(T_world_cam);
}

}  // namespace wardslam::synth
