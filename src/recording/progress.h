#pragma once

#include <functional>

namespace smile::recording {

/// Progress callback (done, total) [s]; returns false to cancel.
using Progress = std::function<bool(double done, double total)>;

}  // namespace smile::recording
