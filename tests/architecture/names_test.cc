// Names that were left for standard ones do not come back: tools/retired_names.txt.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <string_view>

#include "base/files.h"

namespace smile::names {
namespace {

namespace fs = std::filesystem;

const fs::path kRoot = SMILE_SOURCE_DIR;

/// The retired names, each with the one that is used instead.
std::map<std::string, std::string> RetiredNames() {
  std::map<std::string, std::string> names;
  std::istringstream lines(ReadFile(kRoot / "tools/retired_names.txt", 1 << 20));
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("#")) continue;
    std::istringstream words(line);
    std::string retired, standard;
    EXPECT_TRUE(words >> retired >> standard) << line;
    names[retired] = standard;
  }
  return names;
}

bool IsText(const fs::path& path) {
  static constexpr std::array<std::string_view, 8> kExtensions{".cc", ".h",   ".ts", ".tsx",
                                                               ".m",  ".mjs", ".py", ".md"};
  return std::ranges::find(kExtensions, path.extension().string()) != kExtensions.end();
}

/// All identifiers in a text, and words that could be some.
std::set<std::string> IdentifiersIn(std::string_view text) {
  const auto is_letter = [](unsigned char c) { return c == '_' || std::isalnum(c) != 0; };
  std::set<std::string> found;
  for (auto begin = text.begin(); begin != text.end();) {
    begin = std::find_if(begin, text.end(), is_letter);
    const auto end = std::find_if_not(begin, text.end(), is_letter);
    if (begin != end) found.emplace(begin, end);
    begin = end;
  }
  return found;
}

TEST(Names, RetiredOnesStayAway) {
  EXPECT_EQ(IdentifiersIn("a_b(C2).d"), (std::set<std::string>{"a_b", "C2", "d"}));
  const auto retired = RetiredNames();
  ASSERT_GT(retired.size(), 20u);
  int num_files = 0;
  for (const char* folder :
       {"src", "tests", "docs", "web/src", "web/test", "python", "matlab", "examples"}) {
    for (const auto& entry : fs::recursive_directory_iterator(kRoot / folder)) {
      if (!IsText(entry.path())) continue;
      ++num_files;
      const auto identifiers = IdentifiersIn(ReadFile(entry.path(), 1 << 24));
      for (const auto& [name, standard] : retired) {
        EXPECT_FALSE(identifiers.contains(name))
            << entry.path() << " says " << name << "; expected " << standard;
      }
    }
  }
  EXPECT_GT(num_files, 700);
}

}  // namespace
}  // namespace smile::names
