// What the commands of the program do with recordings: replay, describe, analyze, edit, imitate.
// Results are texts in JSON, in the formats of the program.

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <chrono>
#include <optional>
#include <string>

#include "analysis/analysis.h"
#include "analysis/analysis_json.h"
#include "bindings.h"
#include "editing/edit_json.h"
#include "experiment/imitation.h"
#include "picture/rendered_eye.h"
#include "recording/demonstration.h"
#include "recording/recording.h"
#include "recording/view_sample.h"
#include "replay/replay.h"
#include "task/demonstrated_structure.h"
#include "task/structure_json.h"

namespace smile::python {
namespace {

namespace py = pybind11;
using recording::Recording;

/// Reports of long work to Python, some of them per second, for as long as this lives: Python's
/// lock is released meanwhile. Remembers a failure of Python, such as Ctrl-C, which ends the work.
class Reporter {
 public:
  /// @param on_progress  called with step, done and total [s]; or None.
  /// @param on_message   called with a text; or None.
  Reporter(const py::object& on_progress, const py::object& on_message)
      : on_progress_(on_progress), on_message_(on_message) {}

  experiment::Callbacks callbacks() {
    experiment::Callbacks callbacks{.is_cancelled = [this] { return IsCancelled(); }};
    if (!on_progress_.is_none()) {
      callbacks.on_progress = [this](const std::string& step, double done, double total) {
        if (IsDue(&last_report_)) Call([&] { on_progress_(step, done, total); });
      };
    }
    if (!on_message_.is_none()) {
      callbacks.on_message = [this](std::string_view message) {
        // The text is a program's own: any bytes.
        Call([&] {
          on_message_(py::reinterpret_steal<py::str>(PyUnicode_DecodeUTF8(
              message.data(), static_cast<Py_ssize_t>(message.size()), "replace")));
        });
      };
    }
    return callbacks;
  }
  recording::Progress progress() {
    return [this](double done, double total) {
      if (!on_progress_.is_none() && IsDue(&last_report_)) {
        Call([&] { on_progress_("simulating", done, total); });
      }
      return !IsCancelled();
    };
  }
  /// Raises the failure, if there was one.
  void ThrowFailure() {
    if (failure_) throw py::error_already_set(*failure_);
  }

 private:
  using Clock = std::chrono::steady_clock;

  static bool IsDue(Clock::time_point* last) {
    const auto now = Clock::now();
    if (now - *last < std::chrono::milliseconds(50)) return false;
    *last = now;
    return true;
  }
  bool IsCancelled() {
    if (!failure_ && IsDue(&last_check_)) {
      Call([] {
        if (PyErr_CheckSignals() != 0) throw py::error_already_set();
      });
    }
    return failure_.has_value();
  }
  template <class Function>
  void Call(Function function) {
    const py::gil_scoped_acquire locked;
    try {
      function();
    } catch (const py::error_already_set& failure) {
      if (!failure_) failure_ = failure;
    }
  }

  const py::object& on_progress_;
  const py::object& on_message_;
  Clock::time_point last_report_, last_check_;
  std::optional<py::error_already_set> failure_;
};

/// Returns a function that calls one of Python, which must outlive it.
brain::MessageFunction MessageFunctionOf(const py::object& function) {
  return [&function](std::span<const std::byte> question) {
    const py::gil_scoped_acquire locked;
    const py::bytes answer =
        function(py::bytes(reinterpret_cast<const char*>(question.data()), question.size()));
    const std::string_view view = answer;
    const auto bytes = std::as_bytes(std::span(view.data(), view.size()));
    return std::vector<std::byte>(bytes.begin(), bytes.end());
  };
}

/// @param brain  path, or a function from question to answer, both bytes.
/// @returns (result as JSON, the error of the brain in words or None)
py::tuple Imitate(const std::filesystem::path& demonstration, const model::Model& model,
                  const py::object& brain, const std::filesystem::path& out, double seconds,
                  double timeout, bool has_pictures, const std::tuple<int, int, std::string>& eye,
                  const std::tuple<double, double, double, std::uint64_t>& noise,
                  const py::object& on_progress, const py::object& on_message) {
  experiment::ImitationPlan plan{.task = model.scene().name,
                                 .demonstration = demonstration,
                                 .scene = model.scene(),
                                 .callback_seconds = timeout,
                                 .record = out / "imitation",
                                 .has_pictures = has_pictures,
                                 .max_seconds = seconds,
                                 .eye = {.width_px = std::get<0>(eye),
                                         .height_px = std::get<1>(eye),
                                         .camera = std::get<2>(eye)},
                                 .noise = {.joints = std::get<0>(noise),
                                           .image = std::get<1>(noise),
                                           .depth = std::get<2>(noise),
                                           .seed = std::get<3>(noise)},
                                 .robot = model.robot_placement()};
  if (PyCallable_Check(brain.ptr()) != 0) {
    plan.brain_function = MessageFunctionOf(brain);
  } else {
    plan.brain = brain.cast<std::filesystem::path>();
  }
  Reporter reporter(on_progress, on_message);
  const experiment::Callbacks callbacks = reporter.callbacks();
  const auto result = [&] {
    const py::gil_scoped_release released;
    return experiment::Imitate(plan, callbacks);
  }();
  reporter.ThrowFailure();
  return py::make_tuple(ToText(result.json),
                        result.brain_error ? py::object(py::str(ToString(*result.brain_error)))
                                           : py::object(py::none()));
}

/// (what it shows as JSON, the same in words)
py::tuple Describe(const Recording& recording) {
  const task::Structure structure = task::StructureOf(recording);
  const double unit = recording.scene().meters_per_unit;
  return py::make_tuple(ToText(task::ToJson(structure, unit)), task::WordsOf(structure, unit));
}

/// @param on_progress  called with the numbers of simulations.
/// @returns `analysis.json`.
std::string Analyze(const Recording& recording, std::size_t jobs, const py::object& on_progress) {
  Reporter reporter(on_progress, py::none());
  const recording::Progress progress = reporter.progress();
  try {
    const auto count = [&progress](std::size_t done, std::size_t at_most) {
      return progress(static_cast<double>(done), static_cast<double>(at_most));
    };
    const py::gil_scoped_release released;
    return ToText(ToJson(analysis::Analyze(recording, {.num_threads = jobs, .progress = count})));
  } catch (const std::runtime_error&) {
    reporter.ThrowFailure();  // the reason why it ended
    throw;
  }
}

/// @param out  new directory, or nullopt only to report.
/// @returns the report as JSON.
std::string Edit(const Recording& recording, const std::string& edits,
                 const std::optional<std::filesystem::path>& out, bool has_pictures,
                 const py::object& on_progress) {
  const auto edited = editing::EditedByAll(recording::DemonstrationOf(recording),
                                           editing::ParseEdits(ParseJson(edits)));
  Reporter reporter(on_progress, py::none());
  const recording::Progress progress = reporter.progress();
  std::optional<editing::EditReport> report;
  try {
    const py::gil_scoped_release released;
    std::optional<picture::RenderedEye> eye;
    const auto spec = recording::EyeOf(recording.info);
    if (out && has_pictures && spec) eye.emplace(*spec);
    report = out ? editing::MakeEdited(recording, edited,
                                       {.directory = *out, .eye = eye ? &*eye : nullptr}, progress)
                 : editing::ReSimulate(recording, edited, std::nullopt, progress);
  } catch (const std::runtime_error&) {
    reporter.ThrowFailure();  // the reason why it ended
    throw;
  }
  reporter.ThrowFailure();
  return ToText(editing::ToJson(*report));
}

py::object DifferenceTuple(const std::optional<replay::Difference>& difference) {
  if (!difference) return py::none();
  return py::make_tuple(difference->tick, difference->object, difference->quantity,
                        difference->recorded, difference->replayed);
}

/// (ticks, hash, first difference or None, deviations, refused): deviations are (id, distance [m],
/// angle [rad], tick), largest first; refused are (tick, line, reason).
py::tuple Replay(const Recording& recording, std::optional<double> from, std::optional<double> to,
                 const py::object& on_progress) {
  Reporter reporter(on_progress, py::none());
  const recording::Progress progress = reporter.progress();
  const replay::ReplayReport report = [&] {
    const py::gil_scoped_release released;
    return replay::Replay(recording, {.range = {.from = from, .to = to}}, progress);
  }();
  reporter.ThrowFailure();
  py::list deviations, refused;
  for (const replay::Deviation& one : report.deviations) {
    deviations.append(
        py::make_tuple(one.object, one.largest.distance, one.largest.angle, one.tick));
  }
  for (const replay::RefusedCommand& one : report.refused) {
    refused.append(py::make_tuple(one.tick, one.line, one.reason));
  }
  return py::make_tuple(report.ticks(), report.hash, DifferenceTuple(report.first_difference),
                        deviations, refused);
}

}  // namespace

void BindExperiments(py::module_& m) {
  m.def("imitate", &Imitate, py::arg("demonstration"), py::arg("model"), py::arg("brain"),
        py::arg("out"), py::kw_only(), py::arg("seconds"), py::arg("timeout"), py::arg("pictures"),
        py::arg("eye"), py::arg("noise"), py::arg("on_progress"), py::arg("on_message"));
  m.def("describe", &Describe, py::arg("recording"));
  m.def("analyze", &Analyze, py::arg("recording"), py::arg("jobs"), py::arg("on_progress"));
  m.def("edit", &Edit, py::arg("recording"), py::arg("edits"), py::arg("out"), py::arg("pictures"),
        py::arg("on_progress"));
  m.def("replay", &Replay, py::arg("recording"), py::arg("start"), py::arg("end"),
        py::arg("on_progress"));
}

}  // namespace smile::python
