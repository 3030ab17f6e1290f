#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "app/options.h"
#include "recording/time_range.h"

namespace smile::app {

/// Export of a scene or a recording to another simulator or a viewer.
struct WorldExport {
  RobotOptions robot;
  PathOptions path;
  double after = 0;  ///< simulated time before what is exported of a scene [s]

  bool operator==(const WorldExport&) const = default;
};

/// Adds the options of such an export, in a group of their own.
void AddWorldExportOptions(CLI::App* command, WorldExport* options);

/// Writes a scene, or the motion of a recording, for another simulator, and says what is left out.
/// @param range, rate  of a recording, see interchange::SceneOf(); a scene file has neither.
/// @returns the exit code.
int ExportWorld(const std::string& source, const std::string& format, const std::string& out,
                const WorldExport& options, const recording::TimeRange& range,
                std::optional<double> rate);

}  // namespace smile::app
