#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>

#include "experiment/callbacks.h"
#include "experiment/imitation.h"
#include "layout/layout_choice.h"

namespace smile::experiment {

/// A shipped task: it has `scenes/NAME.xml`, `examples/NAME.jsonl` and `scenes/NAME_robot.xml`.
struct ShippedTask {
  std::string_view name;
  /// Level of layouts that vary what matters: of tasks on or in something fixed, or with a pile,
  /// its place, too.
  layout::LayoutLevel level = layout::LayoutLevel::kScattered;
};

inline constexpr std::array<ShippedTask, 21> kTasks{{{"um"},
                                                     {"tower"},
                                                     {"row"},
                                                     {"bridge"},
                                                     {"box"},
                                                     {"sizes"},
                                                     {"pyramid"},
                                                     {"bricks"},
                                                     {"pieces"},
                                                     {"ball"},
                                                     {"plank"},
                                                     {"pedestal", layout::LayoutLevel::kFixtures},
                                                     {"unstack", layout::LayoutLevel::kPiles},
                                                     {"swap", layout::LayoutLevel::kFixtures},
                                                     {"beside", layout::LayoutLevel::kFixtures},
                                                     {"hanoi", layout::LayoutLevel::kFixtures},
                                                     {"lid", layout::LayoutLevel::kPiles},
                                                     {"hatch", layout::LayoutLevel::kFixtures},
                                                     {"drive", layout::LayoutLevel::kFixtures},
                                                     {"scissors", layout::LayoutLevel::kFixtures},
                                                     {"cover", layout::LayoutLevel::kFixtures}}};

/// Returns the shipped task of this name, or nullptr.
const ShippedTask* FindTask(std::string_view name);

/// Performs the script of a shipped task with the hands of the demonstrator, at the table of a
/// robot, and records it into a new directory.
/// @throws std::runtime_error if a file cannot be read or written.
void RecordDemonstration(std::string_view task, const sim::RobotPlacement& robot,
                         const std::filesystem::path& directory, bool has_pictures,
                         const Callbacks& callbacks = {});

/// Speed of the films: four seconds in one.
inline constexpr double kFilmSpeed = 4;

/// A shipped task, demonstrated by hands and imitated by the robot elsewhere.
struct TaskExperimentPlan {
  std::string task{kTasks.front().name};
  std::filesystem::path out;    ///< folder; earlier results in it move aside
  sim::RobotPlacement robot;    ///< stands at both tables
  std::filesystem::path brain;  ///< empty: the shipped learner
  layout::LayoutChoice layout;  ///< of the robot's scene
  bool is_analyzed = false;     ///< and the brain is given the result
  bool has_films = true;
};

/// Demonstrates the task, imitates it, and writes into the plan's folder: `demonstration/`,
/// `imitation/`, `result.json`, films and `report.html` (docs/experiments.md). Cancelled during
/// the imitation, it writes the result without films and report.
/// @throws std::runtime_error if a file cannot be written, or it is cancelled before the
///         imitation; everything recorded until then is kept.
ImitationResult RunTaskExperiment(const TaskExperimentPlan& plan, const Callbacks& callbacks = {});

}  // namespace smile::experiment
