#pragma once

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "base/files.h"

namespace smile::fuzz {

/// Feeds kept inputs; one that asks for all memory there is fails here, not on the whole machine.
class KeptInputs : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    // Under the address sanitizer, whose shadow is larger than any limit, CMakeLists.txt sets one.
#ifndef SMILE_ADDRESS_SANITIZED
    constexpr rlimit kLimit{2'000'000'000, 2'000'000'000};
    ASSERT_EQ(setrlimit(RLIMIT_AS, &kLimit), 0);
#endif
  }
};

/// The files in and below a folder of the project, in alphabetical order; none when it is not
/// there.
inline std::vector<std::filesystem::path> FilesBelow(const std::string& folder) {
  const std::filesystem::path path = std::filesystem::path(SMILE_SOURCE_DIR) / folder;
  std::vector<std::filesystem::path> files;
  if (!std::filesystem::exists(path)) return files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(path)) {
    if (entry.is_regular_file()) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

inline std::string InputIn(const std::filesystem::path& file) { return ReadFile(file, 1 << 24); }

}  // namespace smile::fuzz
