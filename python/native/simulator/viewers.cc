// Viewers: the studio's page on a simulation.

#include "studio/viewer.h"

#include <pybind11/pybind11.h>
#include <pybind11/stl/filesystem.h>

#include <stdexcept>

#include "bindings.h"
#include "handle.h"

namespace smile::python {

namespace py = pybind11;

namespace {

/// A viewer that can be closed.
class ClosableViewer {
 public:
  ClosableViewer(Handle* handle, const std::filesystem::path& page, int port, double speed)
      : speed_(speed),
        viewer_(std::make_unique<studio::Viewer>(page::ServerOptions{.port = port, .page = page},
                                                 Watch(handle))) {}

  std::string link() const { return open().link(); }
  void Show(Handle* handle) { open().Show(Watch(handle)); }
  bool is_closed() const { return viewer_ == nullptr; }
  void Close() { viewer_.reset(); }

 private:
  studio::Viewer& open() const {
    if (viewer_ == nullptr) throw std::runtime_error("the studio is closed, expected an open one");
    return *viewer_;
  }
  std::shared_ptr<studio::WatchedSimulation> Watch(Handle* handle) const {
    auto watched = handle->Watch();
    watched->SetSpeed(speed_);
    return watched;
  }

  double speed_;
  std::unique_ptr<studio::Viewer> viewer_;  ///< null once it is closed
};

}  // namespace

void BindViewer(py::module_& m) {
  using Release = py::call_guard<py::gil_scoped_release>;
  py::class_<ClosableViewer>(m, "Viewer")
      .def(py::init<Handle*, const std::filesystem::path&, int, double>(),
           py::arg("simulation").none(false), py::arg("page"), py::arg("port"), py::arg("speed"),
           Release())
      .def_property_readonly("link", &ClosableViewer::link)
      .def_property_readonly("is_closed", &ClosableViewer::is_closed)
      .def("show", &ClosableViewer::Show, py::arg("simulation").none(false), Release())
      .def("close", &ClosableViewer::Close, Release());
}

}  // namespace smile::python
