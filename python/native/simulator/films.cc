// Pictures of recordings one after another, and films of them.

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <optional>

#include "arrays.h"
#include "bindings.h"
#include "mesh/primitives.h"
#include "picture/film.h"
#include "recording/trace_reader.h"
#include "recording/view_sample.h"
#include "values.h"
#include "video/video_writer.h"

namespace smile::python {
namespace {

/// Moments of a recording in increasing order, drawn: the trace is opened once.
class FrameReader {
 public:
  explicit FrameReader(const recording::Recording& recording)
      : recording_(recording), trace_(recording) {}

  py::tuple RenderAt(std::uint64_t tick, const PictureRequest& request) {
    GoTo(tick);
    const model::Model& model = *recording_.model;
    return Render(
        model, [&] { return recording::VisualStateAt(*moment_, model); }, moment_->joints,
        moment_->is_robot_shown, request);
  }

  /// @returns the poses (frames, 7) of the frames in which pieces are, see PiecesOf(), and the
  ///          variant of each choice.
  py::tuple StateAt(std::uint64_t tick) {
    GoTo(tick);
    const scene::VisualState state = recording::VisualStateAt(*moment_, *recording_.model);
    Array poses({static_cast<py::ssize_t>(state.poses.size()), py::ssize_t{7}});
    double* out = poses.mutable_data();
    for (const RigidTransform& X_WF : state.poses) {
      WritePose(X_WF, out);
      out += 7;
    }
    return py::make_tuple(poses, state.variants);
  }

 private:
  void GoTo(std::uint64_t tick) {
    if (!moment_ || moment_->tick != tick) {
      const py::gil_scoped_release release;
      moment_ = trace_.At(tick);
    }
    if (!moment_) {
      throw std::invalid_argument("tick " + std::to_string(tick) +
                                  " is not in the recording, expected one of its ticks");
    }
  }

  const recording::Recording& recording_;
  recording::TraceReader trace_;
  std::optional<recording::TraceTick> moment_;  ///< the last one
};

/// @returns what is drawn of a recording, a tuple each: the name of the object; its frame; the
/// choice
///          and the variant with which it is visible, -1 for always; its pose (7) in the frame; its
///          color (3); its corners (n, 3) [m] and triangles (m, 3).
py::list PiecesOf(const recording::Recording& recording) {
  const scene::VisualModel& model = recording.model->visual_model();
  py::list pieces;
  for (const scene::Visual& piece : model.visuals) {
    const mesh::TriangleMesh mesh = mesh::MeshOf(piece.shape);
    Array corners({static_cast<py::ssize_t>(mesh.positions.size()), py::ssize_t{3}});
    double* corner = corners.mutable_data();
    for (const Eigen::Vector3f& p : mesh.positions) corner = std::ranges::copy(p, corner).out;
    py::array_t<std::uint32_t> triangles(
        {static_cast<py::ssize_t>(mesh.triangles.size()), py::ssize_t{3}});
    std::uint32_t* index = triangles.mutable_data();
    for (const auto& triangle : mesh.triangles) index = std::ranges::copy(triangle, index).out;
    pieces.append(
        py::make_tuple(model.object_names[piece.object_id], piece.frame, piece.choice,
                       piece.variant, PoseArray(piece.X_FV),
                       ArrayOf(Vector3(piece.color.red, piece.color.green, piece.color.blue)),
                       corners, triangles));
  }
  return pieces;
}

using Pixels = py::array_t<std::uint8_t, py::array::c_style | py::array::forcecast>;

void Add(video::VideoWriter& film, const Pixels& rgb) {
  if (rgb.ndim() != 3 || rgb.shape(2) != 3) {
    throw std::invalid_argument("rgb has " + std::to_string(rgb.ndim()) +
                                " axes, expected (height, width, 3)");
  }
  const Image image{.width_px = static_cast<int>(rgb.shape(1)),
                    .height_px = static_cast<int>(rgb.shape(0)),
                    .color = {rgb.data(), rgb.data() + rgb.size()}};
  const py::gil_scoped_release release;
  film.Add(image);
}

using Levels = py::array_t<std::uint16_t, py::array::c_style | py::array::forcecast>;

void AddLevels(video::VideoWriter& film, const Levels& levels) {
  const py::gil_scoped_release release;
  film.AddLevels({levels.data(), static_cast<std::size_t>(levels.size())});
}

void FilmRecording(const recording::Recording& recording, const std::filesystem::path& mp4,
                   const std::string& camera, int width, int height, double rate, double speed) {
  const py::gil_scoped_release release;
  picture::Film(recording, mp4,
                {.request = {.camera = camera, .width_px = width, .height_px = height},
                 .frames_per_second = rate,
                 .speed = speed});
}

}  // namespace

void BindFilms(py::module_& m) {
  m.def("film", &FilmRecording);
  m.def("pieces_of", &PiecesOf);
  py::class_<FrameReader>(m, "FrameReader")
      .def(py::init<const recording::Recording&>(), py::keep_alive<1, 2>())
      .def("state", &FrameReader::StateAt)
      .def("render", [](FrameReader& frames, std::uint64_t tick, const std::string& camera,
                        int width, int height, bool rgb, bool depth, bool id) {
        return frames.RenderAt(tick,
                               {.spec = {.width_px = width, .height_px = height, .camera = camera},
                                .channels = {.rgb = rgb, .depth = depth, .id = id}});
      });
  py::class_<video::VideoWriter>(m, "VideoWriter")
      .def(py::init([](const std::filesystem::path& path, int width, int height, double rate,
                       bool has_levels) {
             return std::make_unique<video::VideoWriter>(
                 path, width, height, rate,
                 has_levels ? video::VideoCoding::kLevels : video::VideoCoding::kSeekable);
           }),
           py::arg("path"), py::arg("width"), py::arg("height"), py::arg("rate"),
           py::arg("has_levels") = false)
      .def("add", &Add)
      .def("add_levels", &AddLevels)
      .def("finish", &video::VideoWriter::Finish, py::call_guard<py::gil_scoped_release>())
      .def_property_readonly("num_frames", &video::VideoWriter::num_frames);
}

}  // namespace smile::python
