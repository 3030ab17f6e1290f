// One pass for colors and ids, so that they always agree. There is no multisampling, so each pixel
// belongs to one object. Each attachment is cleared, written and read back, which in software takes
// most of the time of large pictures. So ids share one with the colors where they can.

#include "camera/internal_eye_pass.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "camera/internal_light.h"

namespace smile::camera::internal {
namespace {

// How bright a face is depends on where it looks and on nothing else, so that every face of a block
// has one color. A face that looks up shows the color of the scene file itself; one that looks to
// the side is darker, and differently dark for each of the four sides: -y, -x, +x, +y from bright
// to dark. The numbers keep any two neighboring faces of a cube at least 20 of 255 steps apart.
// Brightness scales the color as it is shown on a screen, which leaves hue and saturation alone.
// Glowing pieces show their color in any orientation. The light of a scene multiplies the others
// and turns the side that is bright; the usual light changes no bit.
constexpr char kEyeVertexShader[] = R"(
uniform mat4 clip_from_world;
uniform vec3 light;
uniform vec2 to_bright_side;
out vec3 shade;
flat out uint id;

float Brightness(vec3 n) {
  float side = 0.62 + dot(n.xy, to_bright_side);
  float brightness = n.z > 0.0 ? mix(side, 1.0, n.z) : mix(side, 0.35, -n.z);
  return min(brightness, 1.0);
}

void main() {
  shade = screen_color;
  if (glows == 0u) shade = screen_color * Brightness(NormalInWorld()) * light;
  id = object_id;
  gl_Position = clip_from_world * vec4(PositionInWorld(), 1.0);
}
)";

constexpr char kEyeFragmentShader[] = R"(
in vec3 shade;
flat in uint id;
layout(location = 0) out vec4 color;
layout(location = 1) out uint seen_id;

void main() {
  color = vec4(shade, float(id) / 255.0);
  seen_id = id;
}
)";

/// Horizontal direction to the usual light, by which sides that look there are brighter.
constexpr std::array<double, 2> kToBrightSide{-0.05, -0.17};

constexpr std::uint32_t kMaxIdInAlpha = 255;

bool FitIntoAlpha(const std::vector<Piece>& pieces) {
  return std::ranges::all_of(
      pieces, [](const Piece& piece) { return piece.instance.object_id <= kMaxIdInAlpha; });
}

/// Returns what a picture depends on beside its pieces.
PictureKey KeyOf(const std::vector<Piece>& visible, const CameraView& view,
                 const RenderOptions& options, const scene::Lighting& lighting) {
  FramebufferLayout layout{.width_px = view.intrinsics.width_px,
                           .height_px = view.intrinsics.height_px,
                           .color_formats = {GL_RGBA8}};
  if (options.ids && !FitIntoAlpha(visible)) layout.color_formats.push_back(GL_R32UI);
  return {.view = view,
          .lighting = lighting,
          .background = options.background,
          .layouts = {layout},
          .color = options.color,
          .depth = options.depth,
          .ids = options.ids};
}

/// Clears color, ids and depth of the bound framebuffer.
void Clear(const Color& background, bool has_ids_of_their_own) {
  const GLfloat color[] = {static_cast<GLfloat>(background.red),
                           static_cast<GLfloat>(background.green),
                           static_cast<GLfloat>(background.blue), 0};
  // Id 0 is the background; the depth of the far plane is read back as 0 (no hit).
  const GLuint no_object[] = {0, 0, 0, 0};
  const GLfloat far_plane = 1;
  glClearBufferfv(GL_COLOR, 0, color);
  if (has_ids_of_their_own) glClearBufferuiv(GL_COLOR, 1, no_object);
  glClearBufferfv(GL_DEPTH, 0, &far_plane);
}

}  // namespace

EyePass::EyePass()
    : program_(std::string(kVertexShaderInputs) + kEyeVertexShader, kEyeFragmentShader),
      clip_from_world_(program_.Uniform("clip_from_world")),
      light_(program_.Uniform("light")),
      to_bright_side_(program_.Uniform("to_bright_side")) {}

void EyePass::SetLight(const scene::Lighting& lighting) {
  const Eigen::Vector3f light = LightColor(lighting).cast<float>();
  glUniform3fv(light_, 1, light.data());
  const double c = std::cos(lighting.turn), s = std::sin(lighting.turn);
  const auto [x, y] = kToBrightSide;
  glUniform2f(to_bright_side_, static_cast<float>(c * x - s * y),
              static_cast<float>(s * x + c * y));
}

const Framebuffer& EyePass::Draw(const std::vector<Piece>& pieces,
                                 const std::vector<Piece>& visible, const CameraView& view,
                                 const RenderOptions& options, const scene::Lighting& lighting,
                                 MeshStore* meshes, FramebufferPool* pool) {
  const PictureKey key = KeyOf(visible, view, options, lighting);
  const Eigen::Matrix4f clip_from_world = ClipFromWorld(view);
  if (!KeptPictures::MayKeep(view.intrinsics)) {
    const Framebuffer& picture = pool->Get(key.layouts.front());
    DrawInto(picture, visible, key, clip_from_world, clip_from_world, meshes);
    return picture;
  }
  KeptPicture& kept = kept_.Get(key);
  const Framebuffer& picture = kept.framebuffers.front();
  const PixelRectangle region = ChangedRegion(kept, pieces, nullptr, meshes);
  // Until it is complete, it is no picture of anything.
  kept.pieces.reset();
  if (!region.is_empty()) {
    const ScissorScope scissor(region);
    DrawInto(picture, visible, key, clip_from_world,
             ClipOfRegion(clip_from_world, region, view.intrinsics), meshes);
  }
  kept.pieces = pieces;
  return picture;
}

void EyePass::DrawInto(const Framebuffer& picture, const std::vector<Piece>& visible,
                       const PictureKey& key, const Eigen::Matrix4f& clip_from_world,
                       const Eigen::Matrix4f& cull, MeshStore* meshes) {
  picture.BindForDrawing();
  const bool ids_apart = HasIdsOfTheirOwn(picture);
  // Outputs that are not requested are not written, which saves bandwidth.
  const bool writes_first = key.color || (key.ids && !ids_apart);
  const GLenum outputs[] = {writes_first ? GLenum{GL_COLOR_ATTACHMENT0} : GLenum{GL_NONE},
                            GL_COLOR_ATTACHMENT1};
  glDrawBuffers(ids_apart ? 2 : 1, outputs);
  const Color background = key.lighting.background.value_or(Color{0, 0, 0});
  Clear(key.background.value_or(background), ids_apart);

  program_.Use();
  glUniformMatrix4fv(clip_from_world_, 1, GL_FALSE, clip_from_world.data());
  SetLight(key.lighting);
  meshes->Draw(visible, cull);
}

}  // namespace smile::camera::internal
