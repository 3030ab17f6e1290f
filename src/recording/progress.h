#pragma once

#include <functional>

namespace smile::recording {

/// Told how far a run is, and of how much [s]; answers whether it shall go on.
using Progress = std::function<bool(double done, double total)>;

}  // namespace smile::recording
