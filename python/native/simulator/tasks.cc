// Tasks: what a demonstration achieved, and how much of it a simulation has achieved.

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "bindings.h"
#include "handle.h"
#include "recording/recording.h"
#include "task/comparison.h"
#include "task/imitation_result.h"

namespace smile::python {

namespace py = pybind11;

namespace {

/// The task of a demonstration in the scene of a simulation.
class Task {
 public:
  /// @throws InputError if it is impossible there, or true before anything is done.
  Task(const recording::Recording& demonstration, Handle* handle) : handle_(*handle) {
    {
      const Handle::Use use(&handle_);
      task_ = task::MakeImitationTask(use->scene().name, demonstration, use->scene());
    }
    observer_ = handle_.Observe();
  }

  task::StructureComparison Compare() {
    const Handle::Use use(&handle_);
    const task::Episode episode = handle_.EpisodeOf(observer_);
    const py::gil_scoped_release release;
    return task::CompareWith(task_.structure, episode);
  }

  std::vector<std::string> objects() const {
    std::vector<std::string> ids;
    for (const scene::ObjectSpec& object : task_.structure.objects) ids.push_back(object.id());
    return ids;
  }

 private:
  Handle& handle_;
  std::size_t observer_ = 0;
  task::ImitationTask task_;
};

py::dict DictOf(const task::StructureComparison& comparison) {
  py::dict errors, match;
  for (const auto& [id, error] : comparison.errors) {
    errors[py::str(id)] = py::make_tuple(error.distance, error.angle, error.is_within());
  }
  for (const auto& [id, counterpart] : comparison.match) match[py::str(id)] = counterpart;
  py::dict result;
  result["score"] = comparison.score;
  result["errors"] = errors;
  result["match"] = match;
  result["intruders"] = comparison.intruders;
  return result;
}

}  // namespace

void BindTask(py::module_& m) {
  py::class_<Task>(m, "Task")
      .def(py::init<const recording::Recording&, Handle*>(), py::keep_alive<1, 3>())
      .def_property_readonly("object_ids", &Task::objects)
      .def("compare", [](Task& task) { return DictOf(task.Compare()); });
}

}  // namespace smile::python
