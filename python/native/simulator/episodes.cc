// Goals and episodes of tasks, for environments of reinforcement learning.

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <exception>
#include <functional>
#include <numeric>

#include "base/files.h"
#include "bindings.h"
#include "catalog/placed_robot.h"
#include "experiment/task_experiment.h"
#include "recording/recording.h"
#include "task/demonstrated_structure.h"
#include "task/structure_json.h"
#include "task_episode.h"
#include "thread_team.h"

namespace smile::python {

namespace py = pybind11;

namespace {

using GoalSpacePointer = std::shared_ptr<task::GoalSpace>;

GoalSpacePointer GoalsOf(const recording::Recording& demonstration) {
  const py::gil_scoped_release release;
  return std::make_shared<task::GoalSpace>(task::StructureOf(demonstration));
}

void DemandRows(const char* name, const Array& goals, py::ssize_t columns) {
  if (goals.ndim() == 2 && goals.shape(1) == columns) return;
  throw std::invalid_argument(std::string(name) + " has shape " + ShapeText(goals) +
                              ", expected (n, " + std::to_string(columns) + ")");
}

/// Compares goals row by row.
/// @returns (n, 3): score, relations, closeness.
Array CompareRows(const task::GoalSpace& space, const Array& achieved, const Array& desired) {
  const auto columns = static_cast<py::ssize_t>(space.size());
  DemandRows("achieved_goal", achieved, columns);
  DemandRows("desired_goal", desired, columns);
  if (achieved.shape(0) != desired.shape(0)) {
    throw std::invalid_argument("achieved_goal has shape " + ShapeText(achieved) +
                                " and desired_goal " + ShapeText(desired) +
                                ", expected equal shapes");
  }
  const py::ssize_t rows = achieved.shape(0);
  Array scores({rows, py::ssize_t{3}});
  double* out = scores.mutable_data();
  const double *from = achieved.data(), *to = desired.data();
  const py::gil_scoped_release release;
  task::GoalComparer comparer(&space);
  for (py::ssize_t i = 0; i < rows; ++i, from += columns, to += columns, out += 3) {
    const task::GoalScore score = comparer.Compare({from, space.size()}, {to, space.size()});
    out[0] = score.score;
    out[1] = score.relations;
    out[2] = score.closeness;
  }
  return scores;
}

/// Copies numbers of each result into a row of an array.
template <typename Numbers>
Array RowsOf(const std::vector<StepResult>& results, Numbers&& numbers_of) {
  const auto columns = static_cast<py::ssize_t>(std::size(numbers_of(results.front())));
  Array rows({static_cast<py::ssize_t>(results.size()), columns});
  double* out = rows.mutable_data();
  for (const StepResult& result : results) out = std::ranges::copy(numbers_of(result), out).out;
  return rows;
}

/// @returns a row for each result: observations (n, k), achieved and desired goals (n, g), scores
/// (n, 3) of score, relations and closeness; and the refusals, a text or None each.
py::tuple TupleOf(const std::vector<StepResult>& results) {
  if (results.empty()) throw std::invalid_argument("episodes is empty, expected one or more");
  std::vector<std::optional<std::string>> refusals;
  for (const StepResult& result : results) refusals.push_back(result.refusal);
  return py::make_tuple(
      RowsOf(
          results, [](const StepResult& r) -> auto& { return r.observation; }),
      RowsOf(
          results, [](const StepResult& r) -> auto& { return r.achieved; }),
      RowsOf(
          results, [](const StepResult& r) -> auto& { return r.desired; }),
      RowsOf(results,
             [](const StepResult& r) {
               return std::array{r.score.score, r.score.relations, r.score.closeness};
             }),
      refusals);
}

/// Performs an action in each of several episodes, which share nothing: so the results do not
/// depend on the number of threads.
/// @throws what the first failing episode throws, after all have ended.
std::vector<StepResult> StepAll(const std::vector<TaskEpisode*>& episodes, const double* actions,
                                std::size_t action_size, ThreadTeam& team) {
  std::vector<StepResult> results(episodes.size());
  std::vector<std::exception_ptr> failures(episodes.size());
  // Those that took the longest begin: a step in contact takes several times as long as one in the
  // air, and the last ones should be short, so that no thread waits for another.
  std::vector<std::size_t> order(episodes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, std::greater(),
                           [&](std::size_t i) { return episodes[i]->last_step_time; });
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t k = next++; k < episodes.size(); k = next++) {
      const std::size_t i = order[k];
      const auto start = std::chrono::steady_clock::now();
      try {
        results[i] = episodes[i]->Step({actions + i * action_size, action_size});
      } catch (...) {
        failures[i] = std::current_exception();
      }
      episodes[i]->last_step_time = std::chrono::steady_clock::now() - start;
    }
  };
  team.Run(work);
  for (const std::exception_ptr& failure : failures) {
    if (failure) std::rethrow_exception(failure);
  }
  return results;
}

py::tuple StepEpisodes(const std::vector<TaskEpisode*>& episodes, const Array& actions,
                       ThreadTeam& team) {
  if (actions.ndim() != 2 || actions.shape(0) != static_cast<py::ssize_t>(episodes.size())) {
    throw std::invalid_argument("actions has shape " + ShapeText(actions) + ", expected (" +
                                std::to_string(episodes.size()) + ", n)");
  }
  if (std::ranges::find(episodes, nullptr) != episodes.end()) {
    throw std::invalid_argument("episodes has None, expected episodes");
  }
  std::vector<StepResult> results;
  {
    const double* numbers = actions.data();
    const auto size = static_cast<std::size_t>(actions.shape(1));
    const py::gil_scoped_release release;
    results = StepAll(episodes, numbers, size, team);
  }
  return TupleOf(results);
}

void BindGoals(py::module_& m) {
  py::class_<task::GoalSpace, GoalSpacePointer>(m, "GoalSpace")
      .def(py::init(&GoalsOf))
      .def_property_readonly("size", &task::GoalSpace::size)
      .def("names", &task::GoalSpace::Names)
      .def("words", [](const task::GoalSpace& space,
                       double unit) { return task::WordsOf(space.structure(), unit); })
      .def("compare", &CompareRows);
  m.def("shipped_tasks", [] {
    std::vector<std::pair<std::string, std::string>> tasks;
    for (const experiment::ShippedTask& task : experiment::kTasks) {
      tasks.emplace_back(task.name,
                         layout::kLayoutLevelWords[static_cast<std::size_t>(task.level)]);
    }
    return tasks;
  });
  m.def("data_file", [](const std::string& path) { return DataFile(path); });
  m.def("record_demonstration", [](const std::string& task, const std::string& robot,
                                   const std::filesystem::path& directory) {
    if (experiment::FindTask(task) == nullptr) {
      throw std::invalid_argument("there is no task '" + task + "'");
    }
    const py::gil_scoped_release release;
    experiment::RecordDemonstration(task, catalog::PlaceRobot(robot, {}).placement, directory,
                                    /*has_pictures=*/false);
  });
}

std::unique_ptr<TaskEpisode> MakeEpisode(Handle* handle, const GoalSpacePointer& space,
                                         ControlKind kind, std::vector<std::string> arms, int ticks,
                                         double speed, double displacement, double rotation,
                                         const Array& lowest, const Array& highest,
                                         const std::vector<std::string>& objects) {
  if (handle == nullptr || space == nullptr) {
    throw std::invalid_argument("expected a simulation and a goal space, found None");
  }
  ControlOptions options{.kind = kind,
                         .arms = std::move(arms),
                         .ticks = ticks,
                         .speed = speed,
                         .displacement = displacement,
                         .rotation = rotation,
                         .lowest = Vector3From("lowest", lowest),
                         .highest = Vector3From("highest", highest)};
  const py::gil_scoped_release release;
  return std::make_unique<TaskEpisode>(handle, space, std::move(options), objects);
}

}  // namespace

void BindEpisode(py::module_& m) {
  BindGoals(m);
  py::enum_<ControlKind>(m, "ControlKind")
      .value("joint_velocities", ControlKind::kJointVelocities)
      .value("joint_positions", ControlKind::kJointPositions)
      .value("end_effector", ControlKind::kEndEffector)
      .value("waypoints", ControlKind::kWaypoints);
  py::class_<TaskEpisode>(m, "TaskEpisode")
      .def(py::init(&MakeEpisode), py::keep_alive<1, 2>())
      .def_property_readonly("observation_names", &TaskEpisode::observation_names)
      .def_property_readonly("num_robot_numbers", &TaskEpisode::num_robot_numbers)
      .def_property_readonly("action_names",
                             [](const TaskEpisode& episode) { return episode.control().names(); })
      .def("now", [](TaskEpisode& episode) { return TupleOf({episode.Now()}); });
  py::class_<ThreadTeam>(m, "ThreadTeam").def(py::init([](int num_threads) {
    if (num_threads < 1) {
      throw std::invalid_argument("num_threads is " + std::to_string(num_threads) +
                                  ", expected 1 or more");
    }
    return std::make_unique<ThreadTeam>(num_threads);
  }));
  m.def("step_episodes", &StepEpisodes);
}

}  // namespace smile::python
