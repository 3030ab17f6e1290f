// What a reader has to take in at once stays small: functions and rooms.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>
#include <optional>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "base/files.h"

namespace smile::sizes {
namespace {

namespace fs = std::filesystem;

const fs::path kRoot = SMILE_SOURCE_DIR;
constexpr int kMaxFunctionLines = 80;
/// Of twenty functions one may be longer than this.
constexpr int kLongFunctionLines = 24;
constexpr std::size_t kMaxRoomLines = 5000;

bool IsSource(const fs::path& path) {
  return path.extension() == ".h" || path.extension() == ".cc";
}

bool IsOfThePage(const fs::path& path) {
  return path.extension() == ".ts" || path.extension() == ".tsx" || path.extension() == ".mjs";
}

std::size_t IndentOf(const std::string& line) {
  return std::min(line.find_first_not_of(' '), line.size());
}

/// Lines of code: explanations make no file harder to read, so lines of comments do not count.
std::vector<std::string> LinesOf(const fs::path& path) {
  std::vector<std::string> lines;
  std::istringstream text(ReadFile(path, 1 << 24));
  for (std::string line; std::getline(text, line);) {
    if (line.compare(IndentOf(line), 2, "//") != 0) lines.push_back(line);
  }
  return lines;
}

/// Code without the lines within raw strings, which have a layout of their own.
std::vector<std::string> WithoutRawStrings(std::vector<std::string> lines) {
  const std::regex begin(R"re(R"(\w*)\()re");
  std::optional<std::string> end;
  for (std::string& line : lines) {
    if (end) {
      const bool ends = line.find(*end) != std::string::npos;
      line.clear();
      if (ends) end.reset();
      continue;
    }
    std::smatch match;
    if (!std::regex_search(line, match, begin)) continue;
    const std::string close = ")" + match[1].str() + "\"";
    if (line.find(close, match.position() + match.length()) == std::string::npos) end = close;
  }
  return lines;
}

/// How long each block is that begins with a line of its own, as `… {`, and is no namespace or
/// type: functions, and blocks within them. clang-format puts the end of each below its begin.
/// @param only_outer  leaves out what is within another.
std::vector<int> BlockLengths(const std::vector<std::string>& lines, bool only_outer = false) {
  const std::regex no_function(
      R"(\s*(export\s+)?((namespace|struct|class|enum|union|template|extern|interface)\b.*|const \w+ = \{))");
  const std::regex one_line(R"(.*\)[^;{}]*\{.*\})");
  std::map<std::size_t, std::size_t> begins;  // lines of open blocks, by their indent
  std::vector<int> lengths;
  std::size_t statement = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string& line = lines[i];
    const std::size_t indent = IndentOf(line);
    if (line.compare(indent, 1, "}") == 0 && begins.contains(indent)) {
      const bool is_outer = begins.begin()->first == indent;
      if (is_outer || !only_outer) lengths.push_back(static_cast<int>(i - begins[indent] + 1));
      begins.erase(indent);
    }
    const bool is_continuation = i > 0 && indent >= IndentOf(lines[statement]) + 4 &&
                                 !lines[i - 1].ends_with(";") && !lines[i - 1].ends_with("{");
    if (!is_continuation) statement = i;
    if (begins.empty() && std::regex_match(line, one_line)) lengths.push_back(1);
    const bool opens = line.ends_with("{") && !std::regex_match(lines[statement], no_function);
    if (opens) begins[IndentOf(lines[statement])] = statement;
  }
  return lengths;
}

int Longest(const std::vector<int>& lengths) {
  return lengths.empty() ? 0 : std::ranges::max(lengths);
}

TEST(Size, FindsTheLongestFunction) {
  const std::vector<std::string> code = {"namespace a {",
                                         "struct B {",
                                         "  int C() {",
                                         "    return 1;",
                                         "  }",
                                         "  int D() const { return d; }",
                                         "};",
                                         "void E(int f,",
                                         "       int g) {",
                                         "  if (f) {",
                                         "    H();",
                                         "  }",
                                         "}",
                                         "}"};
  EXPECT_EQ(BlockLengths(code), (std::vector<int>{3, 1, 3, 6}));
  EXPECT_EQ(BlockLengths(code, /*only_outer=*/true), (std::vector<int>{3, 1, 6}));
  EXPECT_EQ(WithoutRawStrings({"a = R\"x(", "{", ")x\";", "b;"}),
            (std::vector<std::string>{"a = R\"x(", "", "", "b;"}));
}

TEST(Size, NoFunctionIsLongerThanAPage) {
  int num_files = 0;
  for (const char* folder :
       {"src", "tests", "python", "matlab", "examples", "web/src", "web/test"}) {
    for (const auto& entry : fs::recursive_directory_iterator(kRoot / folder)) {
      if (!IsSource(entry.path()) && !IsOfThePage(entry.path())) continue;
      ++num_files;
      EXPECT_LE(Longest(BlockLengths(WithoutRawStrings(LinesOf(entry.path())))), kMaxFunctionLines)
          << entry.path();
    }
  }
  EXPECT_GT(num_files, 600);
}

TEST(Size, FewFunctionsAreLong) {
  std::vector<int> lengths;
  for (const auto& entry : fs::recursive_directory_iterator(kRoot / "src")) {
    if (!IsSource(entry.path())) continue;
    std::ranges::copy(BlockLengths(WithoutRawStrings(LinesOf(entry.path())), /*only_outer=*/true),
                      std::back_inserter(lengths));
  }
  ASSERT_GT(lengths.size(), 3000u);
  const auto at_95_percent = lengths.begin() + static_cast<long>(lengths.size() * 95 / 100);
  std::ranges::nth_element(lengths, at_95_percent);
  EXPECT_LE(*at_95_percent, kLongFunctionLines);
}

TEST(Size, NoRoomIsLargerThanAnAfternoon) {
  std::size_t num_rooms = 0;
  for (const auto& room : fs::directory_iterator(kRoot / "src")) {
    if (!room.is_directory()) continue;
    std::size_t num_lines = 0;
    for (auto entry = fs::recursive_directory_iterator(room.path());
         entry != fs::recursive_directory_iterator(); ++entry) {
      if (entry->path().filename() == "test") entry.disable_recursion_pending();
      if (IsSource(entry->path())) num_lines += LinesOf(entry->path()).size();
    }
    num_rooms += num_lines > 0 ? 1 : 0;
    EXPECT_LE(num_lines, kMaxRoomLines) << room.path();
  }
  EXPECT_GT(num_rooms, 20u);
}

}  // namespace
}  // namespace smile::sizes
