// Pictures for people in linear light: colors are decoded from sRGB in the vertex shader, and the
// framebuffer encodes them again. Multisampling smooths edges, which needs a second framebuffer to
// resolve into. Order: shadow map, pieces, background.

#include "camera/internal_presentation_pass.h"

#include <algorithm>
#include <utility>

#include "camera/internal_light.h"

namespace smile::camera::internal {
namespace {

// Decoding of sRGB to linear light (IEC 61966-2-1).
constexpr char kLightOfScreen[] = R"(
vec3 LightOfScreen(vec3 color) {
  return mix(pow((color + 0.055) / 1.055, vec3(2.4)), color / 12.92,
             lessThan(color, vec3(0.04045)));
}
)";

// One triangle that covers the picture behind everything; +y in clip space is down in the picture.
constexpr char kBackgroundVertexShader[] = R"(
uniform vec3 top, bottom;
out vec3 light;
void main() {
  vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  light = mix(LightOfScreen(bottom), LightOfScreen(top), 0.5 - 0.5 * corner.y);
  gl_Position = vec4(corner, 1.0, 1.0);
}
)";

constexpr char kBackgroundFragmentShader[] = R"(
in vec3 light;
out vec4 color;
void main() { color = vec4(light, 1.0); }
)";

constexpr char kPresentationVertexShader[] = R"(
uniform mat4 clip_from_world, map_from_world;
uniform float normal_offset;
out vec3 position_W, normal_W, position_map;
flat out vec3 own_color;
flat out uint is_glowing;

void main() {
  is_glowing = glows;
  position_W = PositionInWorld();
  normal_W = NormalInWorld();
  position_map = (map_from_world * vec4(position_W + normal_offset * normal_W, 1.0)).xyz;
  own_color = LightOfScreen(screen_color);
  gl_Position = clip_from_world * vec4(position_W, 1.0);
}
)";

// Shading with a lamp and soft shadows, a bright sky above and a dimmer floor below (hemisphere
// lighting), and Blinn-Phong highlights.
constexpr char kPresentationFragmentShader[] = R"(
uniform vec3 p_WC, to_lamp, light;
uniform sampler2DShadow shadow_map;
in vec3 position_W, normal_W, position_map;
flat in vec3 own_color;
flat in uint is_glowing;
out vec4 color;

// The mean of four neighboring texels, weighted by nearness.
float Sample(float x, float y) {
  vec2 offset = vec2(x, y) / vec2(textureSize(shadow_map, 0));
  return texture(shadow_map, position_map + vec3(offset, 0.0));
}

// The visible fraction of the lamp: the mean of 4 x 4 samples. The outermost four suffice where all
// is light or all is shadow.
float SeenOfLamp() {
  float corners = Sample(-1.5, -1.5) + Sample(1.5, -1.5) + Sample(-1.5, 1.5) + Sample(1.5, 1.5);
  if (corners == 0.0 || corners == 4.0) return 0.25 * corners;
  float rest = 0.0;
  for (float k = -0.5; k < 1.0; k += 1.0) {
    rest += Sample(k, -1.5) + Sample(k, 1.5) + Sample(-1.5, k) + Sample(1.5, k);
    rest += Sample(k, -0.5) + Sample(k, 0.5);
  }
  return (corners + rest) / 16.0;
}

void main() {
  if (is_glowing == 1u) {
    color = vec4(own_color, 1.0);
    return;
  }
  vec3 n = normalize(normal_W);
  float facing = dot(n, to_lamp);
  float lamp = facing > 0.0 ? facing * SeenOfLamp() : 0.0;
  vec3 sky = mix(vec3(0.17, 0.165, 0.16), vec3(0.36, 0.38, 0.41), 0.5 + 0.5 * n.z);
  vec3 halfway = normalize(to_lamp + normalize(p_WC - position_W));
  float gloss = 0.10 * pow(max(dot(n, halfway), 0.0), 48.0) * min(4.0 * lamp, 1.0);
  color = vec4((own_color * (sky + vec3(0.62, 0.60, 0.56) * lamp) + gloss) * light, 1.0);
}
)";

void SetVector(const Program& program, const char* name, const Vector3& value) {
  const Eigen::Vector3f floats = value.cast<float>();
  glUniform3fv(program.Uniform(name), 1, floats.data());
}

void SetMatrix(const Program& program, const char* name, const Eigen::Matrix4f& value) {
  glUniformMatrix4fv(program.Uniform(name), 1, GL_FALSE, value.data());
}

/// Averages the samples of each pixel (multisample resolve).
void Resolve(const Framebuffer& picture, const Framebuffer& resolved) {
  const auto [width, height] = std::pair(picture.layout().width_px, picture.layout().height_px);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, picture.name());
  glReadBuffer(GL_COLOR_ATTACHMENT0);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved.name());
  glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

/// Returns the shadows of the lamp, as far as they may be seen.
ShadowSweep SweepOf(const std::vector<Piece>& visible, const Vector3& to_lamp, double texel_span) {
  // Samples lie up to 2.5 texels away along each axis of the map, and half a texel below.
  constexpr double kTexels = 5;
  ShadowSweep sweep{.to_lamp = to_lamp, .margin = kTexels * texel_span};
  for (const Piece& piece : visible) {
    sweep.lowest = std::min(sweep.lowest, piece.p_WV.dot(to_lamp) - piece.bounding_radius);
  }
  return sweep;
}

}  // namespace

PresentationPass::PresentationPass()
    : background_program_(std::string(kLightOfScreen) + kBackgroundVertexShader,
                          kBackgroundFragmentShader),
      program_(std::string(kVertexShaderInputs) + kLightOfScreen + kPresentationVertexShader,
               kPresentationFragmentShader) {
  // Some drivers offer fewer; the picture then has rougher edges but is the same otherwise.
  constexpr int kSamples = 4;
  glGetIntegerv(GL_MAX_SAMPLES, &samples_);
  samples_ = std::min(samples_, kSamples);
}

PictureKey PresentationPass::KeyOf(const CameraView& view, const RenderOptions& options,
                                   const scene::Lighting& lighting) const {
  const FramebufferLayout layout{.width_px = view.intrinsics.width_px,
                                 .height_px = view.intrinsics.height_px,
                                 .color_formats = {GL_SRGB8_ALPHA8},
                                 .samples = samples_};
  const FramebufferLayout resolved_layout{.width_px = layout.width_px,
                                          .height_px = layout.height_px,
                                          .color_formats = {GL_SRGB8_ALPHA8},
                                          .has_depth = false};
  return {.view = view,
          .lighting = lighting,
          .background = options.background,
          .layouts = {layout, resolved_layout},
          .map_from_world = shadow_map_.map_from_world()};
}

const Framebuffer& PresentationPass::Draw(const std::vector<Piece>& pieces,
                                          const std::vector<Piece>& visible, const CameraView& view,
                                          const RenderOptions& options,
                                          const scene::Lighting& lighting, MeshStore* meshes,
                                          FramebufferPool* pool) {
  // Shadows first, since drawing the pieces reads the map.
  const Vector3 to_lamp = DirectionToLamp(lighting);
  shadow_map_.Draw(pieces, visible, to_lamp, meshes);
  const PictureKey key = KeyOf(view, options, lighting);
  const Eigen::Matrix4f clip_from_world = ClipFromWorld(view);
  if (!KeptPictures::MayKeep(view.intrinsics)) {
    const Framebuffer& picture = pool->Get(key.layouts.front());
    const Framebuffer& resolved = pool->Get(key.layouts.back());
    DrawInto(picture, resolved, visible, key, clip_from_world, meshes);
    return resolved;
  }
  KeptPicture& kept = kept_.Get(key);
  const ShadowSweep sweep = SweepOf(visible, to_lamp, shadow_map_.texel_span());
  const PixelRectangle region = ChangedRegion(kept, pieces, &sweep, meshes);
  // Until it is complete, it is no picture of anything.
  kept.pieces.reset();
  if (!region.is_empty()) {
    const ScissorScope scissor(region);
    DrawInto(kept.framebuffers.front(), kept.framebuffers.back(), visible, key,
             ClipOfRegion(clip_from_world, region, view.intrinsics), meshes);
  }
  kept.pieces = pieces;
  return kept.framebuffers.back();
}

void PresentationPass::DrawInto(const Framebuffer& picture, const Framebuffer& resolved,
                                const std::vector<Piece>& visible, const PictureKey& key,
                                const Eigen::Matrix4f& cull, MeshStore* meshes) {
  picture.BindForDrawing();
  glEnable(GL_FRAMEBUFFER_SRGB);  // shaders compute linear light, the card encodes it
  const GLfloat far_plane = 1;
  glClearBufferfv(GL_DEPTH, 0, &far_plane);
  DrawPieces(visible, key.view, key.lighting, cull, meshes);
  // Last, where no piece was drawn.
  DrawBackground(key.background ? key.background : key.lighting.background);
  Resolve(picture, resolved);
  glDisable(GL_FRAMEBUFFER_SRGB);
}

void PresentationPass::DrawBackground(const std::optional<Color>& background) {
  const auto set = [&](const char* name, const Color& color) {
    SetVector(background_program_, name, {color.red, color.green, color.blue});
  };
  background_program_.Use();
  set("top", background.value_or(Color{0.72, 0.78, 0.85}));
  set("bottom", background.value_or(Color{0.88, 0.90, 0.92}));
  // The vertex shader makes the corners from gl_VertexID, but the core profile demands a vertex
  // array.
  glBindVertexArray(no_vertices_.name());
  // The triangle lies on the far plane, which passes only with LEQUAL; it is drawn in either
  // orientation.
  glDepthFunc(GL_LEQUAL);
  glDisable(GL_CULL_FACE);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glEnable(GL_CULL_FACE);
  glDepthFunc(GL_LESS);
}

void PresentationPass::DrawPieces(const std::vector<Piece>& visible, const CameraView& view,
                                  const scene::Lighting& lighting, const Eigen::Matrix4f& cull,
                                  MeshStore* meshes) {
  program_.Use();
  const Eigen::Matrix4f clip_from_world = ClipFromWorld(view);
  SetMatrix(program_, "clip_from_world", clip_from_world);
  SetMatrix(program_, "map_from_world", shadow_map_.map_from_world());
  SetVector(program_, "p_WC", view.X_WC.translation());
  SetVector(program_, "to_lamp", DirectionToLamp(lighting));
  SetVector(program_, "light", LightColor(lighting));
  // Looks up the shadow slightly below the surface. Otherwise light would leak in where a block
  // stands on the table: its far side, which casts the shadow, lies on the table too.
  glUniform1f(program_.Uniform("normal_offset"),
              static_cast<float>(-0.5 * shadow_map_.texel_span()));
  shadow_map_.BindTexture();
  meshes->Draw(visible, cull);
}

}  // namespace smile::camera::internal
