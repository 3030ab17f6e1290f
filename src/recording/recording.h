#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "model/model.h"
#include "recording/command_log.h"
#include "recording/demo_info.h"

namespace smile::recording {

/// Opened recording. It is self-contained: the scene file it was made from is not needed.
struct Recording {
  std::filesystem::path directory;
  DemoInfo info;
  /// Model of scene.xml and the robot, with which the simulation began. Never null, like `model`.
  std::shared_ptr<const model::Model> start_model;
  /// The same with all objects that were added on the recording's path; start_model if none was.
  /// It fits each tick of that path: objects not yet added are absent. Compiled once: shared by
  /// all that show or compare the recording, which may outlast this.
  std::shared_ptr<const model::Model> model;
  CommandLog log;  ///< the whole history
  /// The commands on the recording's path, from the first tick of the simulation on, in order.
  std::vector<LoggedCommand> commands;
  /// Messages about parts left out: a last line or tick that was incomplete when the program ended.
  std::vector<std::string> cuts;

  const scene::SceneSpec& start_scene() const { return start_model->scene(); }
  const scene::SceneSpec& scene() const { return model->scene(); }
  const std::optional<model::RobotPlacement>& robot() const { return model->robot_placement(); }
};

/// Returns the name of its directory.
std::string NameOf(const Recording& recording);
/// Returns its title; without one, its name.
std::string TitleOf(const Recording& recording);
/// Returns the title of a recording that corrects it.
std::string CorrectedTitleOf(const Recording& recording);

/// True if the directory looks like a recording.
bool IsRecording(const std::filesystem::path& directory);

/// Returns the recording whose directory contains a path (which need not exist); nullopt if there
/// is no such recording.
std::optional<std::filesystem::path> RecordingAround(const std::filesystem::path& path);

/// Returns the scene at a line of the log, with the objects that were added on the path to it.
/// @throws InputError if something can no longer be added.
scene::SceneSpec SceneAfter(const Recording& recording, std::size_t line);

/// Opens and validates a recording.
/// @throws InputError with all findings, each with its file.
Recording OpenRecording(const std::filesystem::path& directory);

}  // namespace smile::recording
