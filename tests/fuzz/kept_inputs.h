#pragma once

#include <cstddef>
#include <filesystem>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace smile::fuzz {

/// The files in and below a folder, in alphabetical order.
/// @throws std::runtime_error naming the folder if it is missing or contains fewer than `at_least`
///         files, at least one.
std::vector<std::filesystem::path> FilesBelow(const std::filesystem::path& folder,
                                              std::size_t at_least = 1);

/// A reader of untrusted input, and the inputs kept for it in `tests/fuzz/corpus/NAME`: `good` ones
/// that it accepts, `bad` ones that it refuses.
struct HostileReader {
  const char* name;
  /// "" when the input was handled well, accepted or refused; else what went wrong.
  std::string (*fault)(std::string_view input);
  /// "" when the input was accepted, else why it was refused.
  std::string (*refusal)(std::string_view input);
  std::size_t num_good, num_bad;  ///< so many are kept, at least
  /// Files of the project that the reader handles well, too: folder and extension ("": any).
  const char* shipped_folder = nullptr;
  const char* shipped_extension = "";
};
/// Lets GoogleTest print the name instead of the bytes.
inline void PrintTo(const HostileReader& reader, std::ostream* out) { *out << reader.name; }

}  // namespace smile::fuzz
