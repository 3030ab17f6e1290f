#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "app/options.h"

namespace smile::app {

/// Export of a scene to another simulator.
struct WorldExport {
  RobotOptions robot;
  PathOptions path;
  double after = 0;  ///< simulated time before what is exported [s]
};

/// Adds the options of such an export, in a group of their own.
void AddWorldExportOptions(CLI::App* command, WorldExport* options);

/// Writes a scene for another simulator, and says what is left out.
/// @returns the exit code.
int ExportWorld(const std::string& scene, const std::string& format, const std::string& out,
                const WorldExport& options);

}  // namespace smile::app
