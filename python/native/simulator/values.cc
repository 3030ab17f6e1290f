#include "values.h"

#include <pybind11/stl.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "camera/renderer.h"
#include "picture/viewpoint.h"
#include "thread_renderer.h"

namespace smile::python {
namespace {

CameraView ViewOf(const model::Model& model, std::span<const double> q, bool is_robot_shown,
                  const sim::EyeSpec& spec, camera::RenderOptions* options) {
  const std::vector<std::string> cameras = model::CameraNames(model);
  if (std::ranges::find(cameras, spec.camera) != cameras.end()) {
    options->excluded_frames = model::FramesHiddenFromEye(model, is_robot_shown, spec.camera);
    return model::EyeView(model, q, spec);
  }
  options->style = camera::RenderStyle::kPresentation;
  return picture::FindView(spec.camera, model.scene(), spec, cameras, model.robot() != nullptr);
}

}  // namespace

py::dict EventDict(const DatedEvent& dated) {
  py::dict event;
  event["tick"] = dated.tick;
  event["kind"] = std::string(ToString(dated.event.kind));
  if (dated.event.hand) event["hand"] = std::string(ToString(*dated.event.hand));
  for (const auto& [name, text] :
       {std::pair("arm", &dated.event.arm), std::pair("object", &dated.event.object),
        std::pair("part", &dated.event.part), std::pair("control", &dated.event.control),
        std::pair("state", &dated.event.state), std::pair("by", &dated.event.by),
        std::pair("reason", &dated.event.reason)}) {
    if (!text->empty()) event[name] = *text;
  }
  if (!dated.event.objects.empty()) event["objects"] = dated.event.objects;
  return event;
}

py::tuple Render(const model::Model& model, const std::function<scene::VisualState()>& state,
                 std::span<const double> q, bool is_robot_shown, const PictureRequest& request) {
  const auto& [spec, channels] = request;
  Image image;
  CameraView view;
  {
    const py::gil_scoped_release release;
    camera::RenderOptions options{
        .color = channels.rgb, .depth = channels.depth, .ids = channels.id};
    view = ViewOf(model, q, is_robot_shown, spec, &options);
    RendererOfThread().Render(model.visual_model(), state(), view, options, &image);
  }
  const py::ssize_t h = spec.height_px, w = spec.width_px;
  const auto channel = [](bool is_wanted, auto& values, std::vector<py::ssize_t> shape) {
    return is_wanted ? py::object(OwnedArray(std::move(values), std::move(shape)))
                     : py::object(py::none());
  };
  const CameraIntrinsics& k = view.intrinsics;
  Array matrix({py::ssize_t{3}, py::ssize_t{3}});
  const double entries[9] = {k.fx, 0, k.cx, 0, k.fy, k.cy, 0, 0, 1};
  std::copy(entries, entries + 9, matrix.mutable_data());
  return py::make_tuple(channel(channels.rgb, image.color, {h, w, 3}),
                        channel(channels.depth, image.depth, {h, w}),
                        channel(channels.id, image.ids, {h, w}), matrix, MatrixOf(view.X_WC));
}

}  // namespace smile::python
