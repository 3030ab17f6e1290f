// The compiled half of the simulator in Python: a thin door; what people see is in python/smile/.

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "../standard_errors.h"
#include "base/diagnostic.h"
#include "base/files.h"
#include "base/version.h"
#include "bindings.h"

namespace smile::python {
namespace {

namespace py = pybind11;

/// Raises SceneError with the attribute `diagnostics`: a list of (file, line, element, message).
void RaiseInputError(const py::object& type, const InputError& error) {
  py::list diagnostics;
  for (const Diagnostic& one : error.diagnostics()) {
    diagnostics.append(py::make_tuple(MessageText(one.file), one.line, MessageText(one.element),
                                      MessageText(one.message)));
  }
  const py::object value = type(MessageText(error.what()));
  value.attr("diagnostics") = diagnostics;
  PyErr_SetObject(type.ptr(), value.ptr());
}

}  // namespace
}  // namespace smile::python

PYBIND11_MODULE(smile_simulator_native, m) {
  namespace py = pybind11;
  smile::python::RegisterStandardErrors();
  // The type outlives the module: exceptions may be translated until the interpreter ends.
  static const py::object* scene_error = nullptr;
  const py::object errors = py::module_::import("smile.errors");
  scene_error = new py::object(errors.attr("SceneError"));
  py::register_local_exception_translator([](std::exception_ptr pointer) {
    try {
      if (pointer) std::rethrow_exception(pointer);
    } catch (const smile::InputError& error) {
      smile::python::RaiseInputError(*scene_error, error);
    }
  });
  m.def("program_name", &smile::ProgramName);
  m.def("data_file", &smile::DataFile, py::arg("relative_path"));
  smile::python::BindModel(m);
  smile::python::BindSimulation(m);
  smile::python::BindRecording(m);
  smile::python::BindTask(m);
  smile::python::BindExperiments(m);
  smile::python::BindFilms(m);
  smile::python::BindRobotMotion(m);
  smile::python::BindEpisode(m);
  smile::python::BindViewer(m);
  smile::python::BindHands(m);
  smile::python::BindPages(m);
  smile::python::BindRobotBrain(m);
}
