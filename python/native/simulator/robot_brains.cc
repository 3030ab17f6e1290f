// Brains that drive a robot outside of the simulator.

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <stdexcept>
#include <tuple>

#include "../standard_errors.h"
#include "arrays.h"
#include "bindings.h"
#include "robot_brain.h"
#include "scene/units.h"

namespace smile::python {
namespace {

namespace py = pybind11;

using Pixels = py::array_t<std::uint8_t, py::array::c_style | py::array::forcecast>;
using Depths = py::array_t<float, py::array::c_style | py::array::forcecast>;
/// Width, height [px], intrinsics (3, 3) with pixels that begin at 0, X_WC (4, 4) [m].
using CameraTuple = std::tuple<int, int, Array, Array>;

Array MatrixFrom(const char* name, const Array& matrix, py::ssize_t size) {
  if (matrix.ndim() == 2 && matrix.shape(0) == size && matrix.shape(1) == size) return matrix;
  throw std::invalid_argument(std::string(name) + " has shape " + ShapeText(matrix));
}

RobotCamera CameraFrom(const CameraTuple& camera, bool has_depth, double meters_per_unit) {
  const Array K = MatrixFrom("K", std::get<2>(camera), 3);
  const Array X = MatrixFrom("X_WC", std::get<3>(camera), 4);
  RobotCamera result{.description = {.width_px = std::get<0>(camera),
                                     .height_px = std::get<1>(camera),
                                     .fx = K.at(0, 0),
                                     .fy = K.at(1, 1),
                                     .cx = K.at(0, 2),
                                     .cy = K.at(1, 2)},
                     .has_depth = has_depth};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 4; ++j) {
      result.description.X_WC(i, j) =
          j < 3 ? X.at(i, j) : scene::ToFileUnits(X.at(i, j), meters_per_unit);
    }
  }
  return result;
}

/// Returns the picture that a function of Python returns: (rgb, depth or None).
Image PictureFrom(const py::object& look) {
  const auto [rgb, depth] = look().cast<std::tuple<Pixels, std::optional<Depths>>>();
  if (rgb.ndim() != 3 || rgb.shape(2) != 3) {
    throw std::invalid_argument("rgb has another shape than (height, width, 3)");
  }
  Image image{.width_px = static_cast<int>(rgb.shape(1)),
              .height_px = static_cast<int>(rgb.shape(0)),
              .color = std::vector<std::uint8_t>(rgb.data(), rgb.data() + rgb.size())};
  if (depth) {
    if (depth->size() * 3 != rgb.size()) {
      throw std::invalid_argument("depth has another size than rgb");
    }
    image.depth.assign(depth->data(), depth->data() + depth->size());
  }
  return image;
}

/// A RobotBrain that can be closed. For one thread.
class ClosableBrain {
 public:
  ClosableBrain(const model::Model& model, const std::filesystem::path& brain,
                const std::optional<CameraTuple>& camera, bool has_depth, py::object look,
                const std::filesystem::path& demonstration, double timeout)
      : look_(std::move(look)) {
    RobotBrainOptions options{.demonstration = demonstration, .timeout = timeout};
    options.look = [this] {
      const py::gil_scoped_acquire locked;
      return PictureFrom(look_);
    };
    if (camera) options.camera = CameraFrom(*camera, has_depth, model.scene().meters_per_unit);
    const py::gil_scoped_release release;
    brain_ = std::make_unique<RobotBrain>(model, brain, options);
  }
  ~ClosableBrain() { Close(); }

  RobotBrain& operator*() const {
    if (brain_ == nullptr) throw std::runtime_error("the brain is closed, expected an open one");
    return *brain_;
  }
  RobotBrain* operator->() const { return &**this; }
  void Close() {
    const py::gil_scoped_release release;
    brain_.reset();
  }

 private:
  py::object look_;
  std::unique_ptr<RobotBrain> brain_;  ///< null once it is closed
};

void Sense(const ClosableBrain& brain,
           const std::vector<std::tuple<std::vector<double>, std::vector<double>,
                                        std::optional<double>, bool>>& arms) {
  std::vector<MeasuredArm> measured;
  for (const auto& [joints, velocities, opening, holds] : arms) {
    measured.push_back({joints, velocities, opening, holds});
  }
  brain->Sense(std::move(measured));
}

}  // namespace

void BindRobotBrain(py::module_& m) {
  using Release = py::call_guard<py::gil_scoped_release>;
  py::class_<ClosableBrain>(m, "RobotBrain")
      .def(py::init<const model::Model&, const std::filesystem::path&,
                    const std::optional<CameraTuple>&, bool, py::object,
                    const std::filesystem::path&, double>(),
           py::arg("model"), py::arg("brain"), py::arg("camera"), py::arg("has_depth"),
           py::arg("look"), py::arg("demonstration"), py::arg("timeout"))
      .def("sense", &Sense, py::arg("arms"))
      .def(
          "ask", [](const ClosableBrain& brain) { return brain->Ask(); }, Release())
      .def(
          "take", [](const ClosableBrain& brain, double seconds) { return brain->Take(seconds); },
          py::arg("seconds"), Release())
      .def(
          "tick", [](const ClosableBrain& brain) { brain->Tick(); }, Release())
      .def("touch",
           [](const ClosableBrain& brain, const std::vector<std::vector<double>>& joints) {
             return brain->Touch(joints);
           })
      .def("initial_joints",
           [](const ClosableBrain& brain, int arm) { return brain->InitialJoints(arm); })
      .def("velocities",
           [](const ClosableBrain& brain, int arm) { return ArrayOf(brain->Velocities(arm)); })
      .def("opening_rate",
           [](const ClosableBrain& brain, int arm) { return brain->OpeningRate(arm); })
      .def("lines",
           [](const ClosableBrain& brain) {
             py::list lines;
             for (const std::string& line : brain->TakeLines()) lines.append(MessageText(line));
             return lines;
           })
      .def_property_readonly("seconds", [](const ClosableBrain& brain) { return brain->seconds(); })
      .def_property_readonly(
          "status", [](const ClosableBrain& brain) { return brain::ToString(brain->status()); })
      .def_property_readonly("error",
                             [](const ClosableBrain& brain) -> py::object {
                               const auto error = brain->error();
                               return error ? MessageText(brain::ToString(*error))
                                            : py::object(py::none());
                             })
      .def_property_readonly("claim",
                             [](const ClosableBrain& brain) -> py::object {
                               const auto claim = brain->claim();
                               if (!claim) return py::none();
                               return py::make_tuple(claim->is_done, MessageText(claim->reason));
                             })
      .def("close", &ClosableBrain::Close);
}

}  // namespace smile::python
