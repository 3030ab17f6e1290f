#include "experiment/json_file.h"

#include <stdexcept>

#include "base/diagnostic.h"
#include "base/files.h"

namespace smile::experiment {

Json ReadJsonFile(const std::filesystem::path& file) {
  constexpr std::size_t kMaxJsonBytes = 16 << 20;
  try {
    return ParseJson(ReadFile(file, kMaxJsonBytes));
  } catch (const std::invalid_argument& error) {
    // Line 0: the file as a whole is no JSON.
    throw InputError({file.string(), 0, "", error.what()});
  }
}

}  // namespace smile::experiment
