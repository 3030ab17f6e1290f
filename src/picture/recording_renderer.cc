#include "picture/recording_renderer.h"

#include <algorithm>
#include <stdexcept>

#include "base/wording.h"
#include "image/png.h"
#include "picture/viewpoint.h"
#include "recording/view_sample.h"

// Renders recorded moments, through the robot's cameras or from views for people. Pictures for
// people may show markers and the demonstrator; pictures of the robot's cameras are those of the
// recording, except for the demonstrator on request.

namespace smile::picture {
namespace {

/// Returns `out/um.depth.png` for `out/um.png` and "depth".
std::filesystem::path WithTag(std::filesystem::path path, const std::string& tag) {
  return path.replace_extension("." + tag + path.extension().string());
}

}  // namespace

Channels ParseChannels(const std::string& text) {
  Channels channels{.rgb = false};
  // Reaches the end also for an empty name behind the last comma, which is refused.
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t end = std::min(text.find(',', start), text.size());
    const std::string name = text.substr(start, end - start);
    if (name == "rgb") {
      channels.rgb = true;
    } else if (name == "depth") {
      channels.depth = true;
    } else if (name == "id") {
      channels.id = true;
    } else {
      throw std::invalid_argument("channel is " + Quoted(name) + ", expected rgb, depth or id");
    }
    start = end + 1;
  }
  return channels;
}

RecordingRenderer::RecordingRenderer(const model::Model& model, RenderRequest request,
                                     const SeenDemonstrator* demonstrator)
    : model_(model),
      demonstrator_(demonstrator),
      request_(std::move(request)),
      eye_{.width_px = request_.width_px, .height_px = request_.height_px} {
  const std::vector<std::string> names = model::CameraNames(model);
  // Cameras of the model come first; other words are views for people.
  if (std::ranges::find(names, request_.camera) != names.end()) {
    // `eye` means the camera with which the recording was made, which may be the robot's head.
    eye_.camera = request_.camera == model::kEyeCamera ? request_.eye : request_.camera;
  } else {
    view_for_people_ =
        FindView(request_.camera, model.scene(), eye_, names, model.robot() != nullptr);
  }
}

const Image& RecordingRenderer::Take(const recording::TraceTick& moment,
                                     const std::vector<Vector3>& markers) {
  model::ViewSample sample = recording::ViewSampleAt(moment, model_, eye_);
  if (view_for_people_) {
    sample.view = *view_for_people_;
    // Only the eye does not see the head that contains it.
    if (moment.is_robot_shown) sample.hidden_frames.clear();
  }
  const bool is_somebody_there = demonstrator_ != nullptr;
  const bool is_ghost =
      is_somebody_there && demonstrator_->appearance() == DemonstratorAppearance::kGhost;
  // Opaque arms occlude and appear in depth and ids; a ghost is blended over the finished colors.
  if (is_somebody_there && !is_ghost) demonstrator_->AddTo(&sample.state, moment.tick);
  Render(opaque_model(), sample, request_.channels, &image_);
  if (is_ghost && request_.channels.rgb) AddGhost(sample, moment.tick);
  if (view_for_people_ && request_.channels.rgb && !markers.empty()) AddMarkers(sample, markers);
  return image_;
}

const scene::VisualModel& RecordingRenderer::opaque_model() const {
  const bool has_arms =
      demonstrator_ != nullptr && demonstrator_->appearance() == DemonstratorAppearance::kForearm;
  return has_arms ? demonstrator_->model() : model_.visual_model();
}

void RecordingRenderer::Render(const scene::VisualModel& model, const model::ViewSample& sample,
                               const Channels& channels, Image* image) {
  renderer_.Render(model, sample.state, sample.view,
                   {.color = channels.rgb,
                    .depth = channels.depth,
                    .ids = channels.id,
                    .style = view_for_people_ ? camera::RenderStyle::kPresentation
                                              : camera::RenderStyle::kRobotEye,
                    .excluded_frames = sample.hidden_frames},
                   image);
}

// Renders the scene a second time with solid hands, and takes the mean of both pictures.
void RecordingRenderer::AddGhost(model::ViewSample sample, std::uint64_t tick) {
  demonstrator_->AddTo(&sample.state, tick);
  Mix(demonstrator_->model(), sample);
}

void RecordingRenderer::AddMarkers(const model::ViewSample& sample,
                                   const std::vector<Vector3>& markers) {
  constexpr double kRadiusUnits = 0.15;
  scene::VisualModel model = opaque_model();
  scene::Visual marker;
  marker.shape = scene::Sphere{.radius = kRadiusUnits * model_.scene().meters_per_unit};
  marker.color = {.red = 1, .green = 0, .blue = 1};
  // Any object will do, as ids are not rendered here.
  marker.object_id = 1;
  marker.casts_shadow = false;
  for (const Vector3& p_WM : markers) {
    marker.X_FV = RigidTransform(p_WM);
    // Markers are drawn into a copy and mixed in, so that they are half transparent.
    model.visuals.push_back(marker);
  }
  Mix(model, sample);
}

void RecordingRenderer::Mix(const scene::VisualModel& model, const model::ViewSample& sample) {
  Render(model, sample, {}, &mixed_image_);
  for (std::size_t i = 0; i < image_.color.size(); ++i) {
    // Mean of both pictures, rounded: equal where they agree, half transparent elsewhere.
    image_.color[i] = static_cast<std::uint8_t>((image_.color[i] + mixed_image_.color[i] + 1) / 2);
  }
}

std::vector<std::filesystem::path> WriteChannels(const std::filesystem::path& png,
                                                 const Image& image, const Channels& channels) {
  std::vector<std::filesystem::path> written;
  const auto write = [&](auto writer, const std::filesystem::path& path) {
    writer(path, image);
    written.push_back(path);
  };
  if (channels.rgb) write(&WritePng, png);
  if (channels.depth) write(&WriteDepthPng, WithTag(png, "depth"));
  if (channels.id) write(&WriteIdPng, WithTag(png, "id"));
  return written;
}

}  // namespace smile::picture
