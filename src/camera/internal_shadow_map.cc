// A depth picture of the scene from the lamp, which is infinitely far away, hence a parallel
// projection. The presentation pass compares each pixel's distance from the lamp with this map.

#include "camera/internal_shadow_map.h"

#include <algorithm>
#include <iterator>
#include <stdexcept>

namespace smile::camera::internal {
namespace {

// Texels per side; drawing in software costs time for each of them.
constexpr int kSize = 1024;

constexpr char kShadowVertexShader[] = R"(
uniform mat4 clip_from_world;
void main() { gl_Position = clip_from_world * vec4(PositionInWorld(), 1.0); }
)";

constexpr char kShadowFragmentShader[] = "void main() {}";

/// Returns the rotation of the lamp's frame L in the world: z towards the lamp, x horizontal.
Matrix3 AxesOfLamp(const Vector3& to_lamp) {
  const Vector3& z = to_lamp;
  const Vector3 x = Vector3::UnitZ().cross(z).normalized();
  Matrix3 R_WL;
  R_WL << x, z.cross(x), z;
  return R_WL;
}

/// Returns the bounds of pieces along the lamp's axes, extended outwards to whole steps, so that
/// the map, and the edges of its shadows, do not shimmer while things move.
Eigen::AlignedBox3d BoundsAlongLamp(const Matrix3& R_LW, const std::vector<Piece>& pieces) {
  constexpr double kStep = 0.25;  // [m]
  Eigen::AlignedBox3d bounds;
  for (const Piece& piece : pieces) {
    const Vector3 p_LV = R_LW * piece.p_WV;
    // A body whose simulation diverged must not make the map useless for all others.
    if (!p_LV.allFinite()) continue;
    bounds.extend(p_LV - Vector3::Constant(piece.bounding_radius));
    bounds.extend(p_LV + Vector3::Constant(piece.bounding_radius));
  }
  if (bounds.isEmpty()) return {Vector3::Constant(-kStep), Vector3::Constant(kStep)};
  return {(bounds.min() / kStep).array().floor() * kStep,
          (bounds.max() / kStep).array().ceil() * kStep};
}

/// Returns the pieces that cast shadows.
std::vector<Piece> Casters(const std::vector<Piece>& pieces) {
  std::vector<Piece> casters;
  std::ranges::copy_if(pieces, std::back_inserter(casters), &Piece::casts_shadow);
  return casters;
}

/// Returns true if two pieces cast the same shadow.
bool HaveSameShape(const Piece& a, const Piece& b) {
  const auto are_same = [](const auto& one, const auto& other) {
    return std::ranges::equal(one, other);
  };
  return std::ranges::equal(a.instance.rows, b.instance.rows, are_same) &&
         a.unit_mesh == b.unit_mesh;
}

}  // namespace

ShadowMap::Layer::Layer() {
  glBindTexture(GL_TEXTURE_2D, texture_.name());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, kSize, kSize, 0, GL_DEPTH_COMPONENT,
               GL_UNSIGNED_INT, nullptr);
  // Everything outside the map is lit.
  const GLfloat lit[] = {1, 1, 1, 1};
  glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, lit);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  // The card compares depths and filters the results linearly (percentage-closer filtering).
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, texture_.name(), 0);
  glDrawBuffer(GL_NONE);
  glReadBuffer(GL_NONE);
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    throw std::runtime_error("OpenGL: glCheckFramebufferStatus: no shadow map can be made");
  }
}

void ShadowMap::Layer::Begin() const {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  const GLfloat far_plane = 1;
  glClearBufferfv(GL_DEPTH, 0, &far_plane);
}

void ShadowMap::Layer::BeginWith(const Layer& other) const {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, other.framebuffer_.name());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer_.name());
  glBlitFramebuffer(0, 0, kSize, kSize, 0, 0, kSize, kSize, GL_DEPTH_BUFFER_BIT, GL_NEAREST);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
}

ShadowMap::ShadowMap()
    : program_(std::string(kVertexShaderInputs) + kShadowVertexShader, kShadowFragmentShader),
      clip_from_world_(program_.Uniform("clip_from_world")) {}

void ShadowMap::FitTo(const std::vector<Piece>& casters, const std::vector<Piece>& receivers,
                      const Vector3& to_lamp) {
  constexpr double kFarthestCaster = 4.0;  // above what is seen; keeps depth precise [m]
  // The map covers the visible pieces only, for resolution; towards the lamp it includes casters
  // above these.
  const Matrix3 R_LW = AxesOfLamp(to_lamp).transpose();
  Eigen::AlignedBox3d bounds = BoundsAlongLamp(R_LW, receivers);
  // z points towards the lamp: only this side is extended.
  bounds.max().z() = std::clamp(BoundsAlongLamp(R_LW, casters).max().z(), bounds.max().z(),
                                bounds.max().z() + kFarthestCaster);

  const Vector3 span = bounds.sizes();
  texel_span_ = std::max(span.x(), span.y()) / kSize;
  // Depth grows away from the lamp.
  const Vector3 scale(1 / span.x(), 1 / span.y(), -1 / span.z());
  const Vector3 corner_L(bounds.min().x(), bounds.min().y(), bounds.max().z());
  Eigen::Matrix4d map_from_world = Eigen::Matrix4d::Identity();
  map_from_world.topLeftCorner<3, 3>() = scale.asDiagonal() * R_LW;
  map_from_world.topRightCorner<3, 1>() = -scale.cwiseProduct(corner_L);
  map_from_world_ = map_from_world.cast<float>();
}

Eigen::Matrix4f ShadowMap::BeginCasters() const {
  glViewport(0, 0, kSize, kSize);
  // Draws back faces: lit front faces then never shade themselves by rounding (shadow acne).
  glFrontFace(GL_CCW);
  glCullFace(GL_FRONT);
  program_.Use();
  Eigen::Matrix4f clip_from_map = Eigen::Matrix4f::Identity();
  // Texture coordinates are 0 to 1, clip coordinates -1 to 1.
  clip_from_map.diagonal() << 2, 2, 2, 1;
  clip_from_map.topRightCorner<3, 1>().setConstant(-1);
  const Eigen::Matrix4f clip_from_world = clip_from_map * map_from_world_;
  glUniformMatrix4fv(clip_from_world_, 1, GL_FALSE, clip_from_world.data());
  return clip_from_world;
}

void ShadowMap::Draw(const std::vector<Piece>& pieces, const std::vector<Piece>& visible,
                     const Vector3& to_lamp, MeshStore* meshes) {
  // Pieces that cast no shadows do not enlarge the map: shadows are the same with and without them.
  const std::vector<Piece> casters = Casters(pieces);
  FitTo(casters, Casters(visible), to_lamp);
  const std::vector<bool> stands_still = StandsStill(casters);
  if (!stands_still.empty() && !std::ranges::count(stands_still, false)) return;

  const Eigen::Matrix4f clip_from_world = BeginCasters();

  RenewStillLayer(casters, stands_still, clip_from_world, meshes);
  if (is_in_still_.empty()) {
    map_.Begin();
    meshes->Draw(casters, clip_from_world);
  } else {
    map_.BeginWith(*still_);
    DrawCasters(casters, false, clip_from_world, meshes);
  }
  glCullFace(GL_BACK);
  glFrontFace(GL_CW);
  last_casters_ = casters;
  last_map_from_world_ = map_from_world_;
}

std::vector<bool> ShadowMap::StandsStill(const std::vector<Piece>& casters) const {
  std::vector<bool> stands_still;
  if (map_from_world_ != last_map_from_world_ || casters.size() != last_casters_.size()) return {};
  for (std::size_t i = 0; i < casters.size(); ++i) {
    stands_still.push_back(HaveSameShape(casters[i], last_casters_[i]));
  }
  return stands_still;
}

void ShadowMap::RenewStillLayer(const std::vector<Piece>& casters,
                                const std::vector<bool>& stands_still,
                                const Eigen::Matrix4f& clip_from_world, MeshStore* meshes) {
  // It is drawn again if something of it moves, and now and then to take up what has stopped.
  constexpr int kMaxAge = 16;
  bool is_valid = is_in_still_.size() == stands_still.size() && !is_in_still_.empty();
  for (std::size_t i = 0; is_valid && i < casters.size(); ++i) {
    is_valid = stands_still[i] || !is_in_still_[i];
  }
  const bool is_old = ++still_age_ >= kMaxAge && is_in_still_ != stands_still;
  if (is_valid && !is_old) return;
  is_in_still_.clear();
  still_age_ = 0;
  if (!std::ranges::count(stands_still, true)) return;
  is_in_still_ = stands_still;
  if (!still_) still_.emplace();
  still_->Begin();
  DrawCasters(casters, true, clip_from_world, meshes);
}

void ShadowMap::DrawCasters(const std::vector<Piece>& casters, bool stand_still,
                            const Eigen::Matrix4f& clip_from_world, MeshStore* meshes) const {
  std::vector<Piece> drawn;
  for (std::size_t i = 0; i < casters.size(); ++i) {
    if (is_in_still_[i] == stand_still) drawn.push_back(casters[i]);
  }
  meshes->Draw(drawn, clip_from_world);
}

}  // namespace smile::camera::internal
