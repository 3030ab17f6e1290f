#include "experiment/move_aside.h"

#include <stdexcept>
#include <string>
#include <system_error>

namespace smile::experiment {

void MoveAside(const std::filesystem::path& named, const Callbacks& callbacks) {
  // `out/` stands for `out`.
  const std::filesystem::path path = named.has_filename() ? named : named.parent_path();
  std::error_code error;
  if (!std::filesystem::exists(path, error)) return;
  for (int i = 1;; ++i) {
    const std::filesystem::path aside = path.string() + "." + std::to_string(i);
    if (std::filesystem::exists(aside, error)) continue;
    // Not atomic with the check before it: a folder that appears in between is replaced only if it
    // is empty.
    std::filesystem::rename(path, aside, error);
    if (error) {
      throw std::runtime_error(path.string() + ": cannot be moved aside: " + error.message());
    }
    callbacks.Say(path.string() + ": the earlier result is now " + aside.string());
    return;
  }
}

}  // namespace smile::experiment
