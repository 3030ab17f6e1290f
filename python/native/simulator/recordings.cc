// Recordings as arrays.

#include "recording/recording.h"

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "arrays.h"
#include "bindings.h"
#include "classic/frame_index.h"
#include "image/png.h"
#include "recording/recording_history.h"
#include "recording/time_range.h"
#include "recording/trace_reader.h"
#include "recording/view_sample.h"
#include "replay/replay.h"
#include "values.h"

namespace smile::python {
namespace {

using recording::Recording;

/// All ticks of a recording, tick by tick.
struct Ticks {
  std::vector<std::uint64_t> ticks, hashes;
  std::vector<double> poses, joints;
};

Ticks ReadTicks(const Recording& recording) {
  Ticks all;
  recording::TraceReader trace(recording);
  while (const auto moment = trace.Next()) {
    all.ticks.push_back(moment->tick);
    all.hashes.push_back(moment->hash);
    for (const recording::TracePose& pose : moment->objects) {
      const std::size_t at = all.poses.size();
      all.poses.resize(at + 7, std::numeric_limits<double>::quiet_NaN());
      if (!pose.is_present) continue;
      for (int i = 0; i < 3; ++i) all.poses[at + i] = pose.position[i];
      for (int i = 0; i < 4; ++i) all.poses[at + 3 + i] = pose.rotation[i];
    }
    all.joints.insert(all.joints.end(), moment->joints.begin(), moment->joints.end());
  }
  return all;
}

/// (ticks, hashes, poses, joints)
py::tuple ArraysOf(const Recording& recording) {
  Ticks all;
  {
    const py::gil_scoped_release release;
    all = ReadTicks(recording);
  }
  const auto rows = static_cast<py::ssize_t>(all.ticks.size());
  const auto objects = static_cast<py::ssize_t>(recording.model->objects().size());
  const py::ssize_t joints = rows > 0 ? static_cast<py::ssize_t>(all.joints.size()) / rows : 0;
  return py::make_tuple(OwnedArray(std::move(all.ticks), {rows}),
                        OwnedArray(std::move(all.hashes), {rows}),
                        OwnedArray(std::move(all.poses), {rows, objects, 7}),
                        OwnedArray(std::move(all.joints), {rows, joints}));
}

py::list EventsOf(const Recording& recording) {
  py::list events;
  for (const recording::TracedEvent& traced : recording::TraceReader(recording).Events()) {
    events.append(EventDict({traced.tick, traced.event}));
  }
  return events;
}

/// Of each event, as EventsOf() lists them: of a release, the support of the object: its id, empty
/// for the table; whether the object lies in it; whether it rests there already. None for other
/// events, and beyond the table's edge.
py::list PlacesOfEvents(const Recording& recording) {
  using enum sim::EventKind;
  py::list places;
  recording::TraceReader trace(recording);
  for (const auto& [tick, event] : recording::TraceReader(recording).Events()) {
    std::optional<model::Support> support;
    if (event.kind == kReleased || event.kind == kGripperReleased) {
      if (const auto moment = trace.At(tick)) {
        support = SupportAt(*moment, event.object, recording.scene());
      }
    }
    if (support) {
      places.append(py::make_tuple(support->object, support->is_inside, support->is_near()));
    } else {
      places.append(py::none());
    }
  }
  return places;
}

/// The actions on the recording's path: (tick at begin, tick at end, words).
py::list ActionsOf(const Recording& recording) {
  py::list actions;
  for (const recording::Segment& segment : recording::OnPath(recording::HistoryOf(recording))) {
    if (!segment.summary) continue;  // the start
    actions.append(
        py::make_tuple(segment.begin.tick, segment.end.tick, recording::WordsOf(segment)));
  }
  return actions;
}

/// The frames of the classic view: (tick, file of its picture or empty).
std::vector<std::pair<std::uint64_t, std::string>> FramesOf(const Recording& recording) {
  const py::gil_scoped_release release;
  std::vector<std::pair<std::uint64_t, std::string>> frames;
  for (const auto& frame : classic::ReadFrameIndex(recording.directory / "frames.csv")) {
    frames.emplace_back(frame.tick, frame.image);
  }
  return frames;
}

py::array_t<std::uint8_t> ReadPicture(const std::filesystem::path& png) {
  Image image;
  {
    const py::gil_scoped_release release;
    image = ReadPng(png);
  }
  return OwnedArray(std::move(image.color), {image.height_px, image.width_px, 3});
}

/// The first difference of a replay, in words; None if there is none.
std::optional<std::string> FirstDifference(const Recording& recording) {
  const py::gil_scoped_release release;
  const replay::ReplayReport report = replay::Replay(recording, {.stops_at_difference = true});
  const auto& first = report.first_difference;
  if (!first) return std::nullopt;
  return "tick " + std::to_string(first->tick) + ": " + first->object + ": " + first->quantity +
         ": recorded " + first->recorded + ", replayed " + first->replayed;
}

py::tuple RenderAt(const Recording& recording, std::uint64_t tick, const std::string& camera,
                   int width, int height, bool rgb, bool depth, bool id) {
  const auto moment = recording::MomentAt(recording, tick);
  if (!moment) {
    throw std::invalid_argument("tick " + std::to_string(tick) +
                                " is not in the recording, expected one of its ticks");
  }
  const model::Model& model = *recording.model;
  return Render(model, [&] { return recording::VisualStateAt(*moment, model); }, moment->joints,
                moment->is_robot_shown,
                {.spec = {.width_px = width, .height_px = height, .camera = camera},
                 .channels = {.rgb = rgb, .depth = depth, .id = id}});
}

}  // namespace

void BindRecording(py::module_& m) {
  py::class_<Recording>(m, "Recording")
      .def_property_readonly("directory", [](const Recording& one) { return one.directory; })
      .def_property_readonly("title", [](const Recording& one) { return one.info.title; })
      .def_property_readonly("notes", [](const Recording& one) { return one.info.notes; })
      .def_property_readonly("cuts", [](const Recording& one) { return one.cuts; })
      .def_property_readonly("start_tick", [](const Recording& one) { return one.info.start.tick; })
      .def_property_readonly(
          "model",
          [](const Recording& one) { return std::const_pointer_cast<model::Model>(one.model); })
      .def_property_readonly(
          "joint_names",
          [](const Recording& one) { return recording::TraceReader(one).joint_names(); })
      .def("arrays", &ArraysOf)
      .def("events", &EventsOf)
      .def("actions", &ActionsOf)
      .def("frames", &FramesOf)
      .def("first_difference", &FirstDifference)
      .def("render", &RenderAt);
  m.def("places_of_events", &PlacesOfEvents);
  m.def("read_picture", &ReadPicture);
  m.def("open", [](const std::filesystem::path& directory) {
    const py::gil_scoped_release release;
    return recording::OpenRecording(directory);
  });
}

}  // namespace smile::python
