#include "kept_inputs.h"

#include <algorithm>
#include <stdexcept>

namespace smile::fuzz {

std::vector<std::filesystem::path> FilesBelow(const std::filesystem::path& folder,
                                              std::size_t at_least) {
  if (!std::filesystem::is_directory(folder)) {
    throw std::runtime_error(folder.string() + ": no such folder");
  }
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) files.push_back(entry.path());
  }
  at_least = std::max<std::size_t>(at_least, 1);
  if (files.size() < at_least) {
    throw std::runtime_error(folder.string() + ": found " + std::to_string(files.size()) +
                             " files, expected at least " + std::to_string(at_least));
  }
  std::ranges::sort(files);
  return files;
}

}  // namespace smile::fuzz
