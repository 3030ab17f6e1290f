#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "recorder/recording_controller.h"
#include "scene_xml/scene_reader.h"
#include "sim/eye.h"
#include "sim/simulation.h"
#include "studio/background_jobs.h"

namespace smile::studio {

struct SessionOptions {
  std::filesystem::path scene;  ///< loaded first
  scene_xml::SceneReaderOptions reader;
  std::optional<sim::RobotPlacement> robot;
  std::filesystem::path recordings = "recordings";
  recorder::RecorderOptions recording;
  sim::Eye* eye = nullptr;  ///< renders the recorded pictures; must outlive the session
  /// Folder of the scenes that clients load by name; empty: the shipped scenes.
  std::filesystem::path scene_folder;
  /// Folders of brains, searched before the shipped ones.
  std::vector<std::filesystem::path> brains;
  /// Executes slow requests, which require it; its deferred messages have to be taken in the thread
  /// of the session. Must outlive the session.
  BackgroundJobs* jobs = nullptr;
};

/// Returns the options with which worlds are recorded.
inline recorder::RecordingController::Options RecordingOptionsOf(const SessionOptions& options) {
  return {.root = options.recordings, .recording = options.recording, .eye = options.eye};
}

}  // namespace smile::studio
