#pragma once

#include <string>
#include <vector>

namespace smile::app {

/// Continues this process as `python3 -m smile.datasets` with the arguments; does not return. If a
/// Python package is missing, the program says how to get it and ends with exit code 3.
/// @throws std::runtime_error if there is no Python.
[[noreturn]] void ContinueAsPythonDatasets(const std::vector<std::string>& arguments);

/// The same for `python3 -m smile.ros`.
[[noreturn]] void ContinueAsPythonRos(const std::vector<std::string>& arguments);

}  // namespace smile::app
