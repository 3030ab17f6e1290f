#include "camera/renderer.h"

#include "camera/internal_eye_pass.h"
#include "camera/internal_gl_context.h"
#include "camera/internal_presentation_pass.h"
#include "camera/internal_read_back.h"

namespace smile::camera {

struct Renderer::State {
  internal::GlContext context;  // first, as everything below lives in it
  internal::MeshStore meshes;
  internal::FramebufferPool framebuffers;
  internal::ReadBack read_back;
  internal::EyePass eye_pass;
  std::optional<internal::PresentationPass> presentation_pass;  // made on first use

  // Members are deleted after this; OpenGL deletes objects of the current context.
  ~State() { context.MakeCurrent(); }
};

Renderer::Renderer() : state_(std::make_unique<State>()) {
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_CULL_FACE);
  glDisable(GL_DITHER);  // alpha may be an id
  glFrontFace(GL_CW);    // pictures are drawn top row first, which reverses orientation
  internal::CheckGl("setting up");
}

Renderer::~Renderer() = default;

Image Renderer::Render(const scene::VisualModel& model, const scene::VisualState& state,
                       const CameraView& view, const RenderOptions& options) {
  Image image;
  Render(model, state, view, options, &image);
  return image;
}

void Renderer::Render(const scene::VisualModel& model, const scene::VisualState& state,
                      const CameraView& view, const RenderOptions& options, Image* image) {
  internal::CheckIntrinsics(view.intrinsics);
  const auto pieces = internal::PlacePieces(model, state, options.excluded_frames);
  const auto visible = internal::VisiblePieces(pieces, view);
  image->width_px = view.intrinsics.width_px;
  image->height_px = view.intrinsics.height_px;
  // The memory of all channels is reused for the next picture of the same size.
  if (!options.color) image->color.clear();
  if (!options.depth) image->depth.clear();
  if (!options.ids) image->ids.clear();

  State& s = *state_;
  // Other renderers of this thread may have made their contexts current in between.
  s.context.MakeCurrent();
  // the presentation style provides color only; depth and ids come from the eye pass in either
  // style.
  RenderOptions eye_options = options;
  if (options.color && options.style == RenderStyle::kPresentation) {
    if (!s.presentation_pass) s.presentation_pass.emplace();
    s.read_back.ReadColor(s.presentation_pass->Draw(pieces, visible, view, options, model.lighting,
                                                    &s.meshes, &s.framebuffers),
                          image);
    eye_options.color = false;
  }
  if (eye_options.color || options.depth || options.ids) {
    const internal::Framebuffer& picture = s.eye_pass.Draw(
        pieces, visible, view, eye_options, model.lighting, &s.meshes, &s.framebuffers);
    if (options.ids && !internal::EyePass::HasIdsOfTheirOwn(picture)) {
      s.read_back.ReadColorAndIds(picture, eye_options.color, image);
    } else {
      if (eye_options.color) s.read_back.ReadColor(picture, image);
      if (options.ids) s.read_back.ReadIds(picture, image);
    }
    if (options.depth) {
      s.read_back.ReadDepth(picture, view.intrinsics.near, view.intrinsics.far, image);
    }
  }
  internal::CheckGl("drawing a picture");
}

std::string Renderer::device_name() const {
  state_->context.MakeCurrent();
  return state_->context.renderer_name();
}

}  // namespace smile::camera
