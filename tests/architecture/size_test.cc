// What a reader has to take in at once stays small: functions and rooms.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
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
constexpr std::size_t kMaxRoomLines = 5000;

bool IsSource(const fs::path& path) {
  return path.extension() == ".h" || path.extension() == ".cc";
}

std::vector<std::string> LinesOf(const fs::path& path) {
  std::vector<std::string> lines;
  std::istringstream text(ReadFile(path, 1 << 24));
  for (std::string line; std::getline(text, line);) lines.push_back(line);
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

std::size_t IndentOf(const std::string& line) {
  return std::min(line.find_first_not_of(' '), line.size());
}

/// How long the longest block is that begins with a line of its own, as `… {`, and is no namespace
/// or type: a function, or a part of one. clang-format puts its end below its begin.
int LongestBlock(const std::vector<std::string>& lines) {
  const std::regex no_function(R"(\s*(namespace|struct|class|enum|union|template|extern)\b.*)");
  std::map<std::size_t, std::size_t> begins;  // lines of open blocks, by their indent
  std::size_t longest = 0, statement = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string& line = lines[i];
    const std::size_t indent = IndentOf(line);
    if (line.compare(indent, 1, "}") == 0 && begins.contains(indent)) {
      longest = std::max(longest, i - begins[indent] + 1);
      begins.erase(indent);
    }
    const bool goes_on = i > 0 && indent >= IndentOf(lines[statement]) + 4 &&
                         !lines[i - 1].ends_with(";") && !lines[i - 1].ends_with("{");
    if (!goes_on) statement = i;
    const bool opens = line.ends_with("{") && !std::regex_match(lines[statement], no_function);
    if (opens) begins[IndentOf(lines[statement])] = statement;
  }
  return static_cast<int>(longest);
}

TEST(Size, FindsTheLongestFunction) {
  EXPECT_EQ(LongestBlock({"namespace a {", "struct B {", "  int C() {", "    return 1;", "  }",
                          "  int d = 0;", "};", "void E(int f,", "       int g) {", "  if (f) {",
                          "    H();", "  }", "}", "}"}),
            6);
  EXPECT_EQ(WithoutRawStrings({"a = R\"x(", "{", ")x\";", "b;"}),
            (std::vector<std::string>{"a = R\"x(", "", "", "b;"}));
}

TEST(Size, NoFunctionIsLongerThanAPage) {
  int num_files = 0;
  for (const char* folder : {"src", "tests", "python", "matlab", "examples"}) {
    for (const auto& entry : fs::recursive_directory_iterator(kRoot / folder)) {
      if (!IsSource(entry.path())) continue;
      ++num_files;
      EXPECT_LE(LongestBlock(WithoutRawStrings(LinesOf(entry.path()))), kMaxFunctionLines)
          << entry.path();
    }
  }
  EXPECT_GT(num_files, 500);
}

TEST(Size, NoRoomIsLargerThanAnAfternoon) {
  std::size_t num_rooms = 0;
  for (const auto& room : fs::directory_iterator(kRoot / "src")) {
    if (!room.is_directory()) continue;
    std::size_t num_lines = 0;
    for (const auto& entry : fs::directory_iterator(room.path())) {
      if (IsSource(entry.path())) num_lines += LinesOf(entry.path()).size();
    }
    num_rooms += num_lines > 0 ? 1 : 0;
    EXPECT_LE(num_lines, kMaxRoomLines) << room.path();
  }
  EXPECT_GT(num_rooms, 20u);
}

}  // namespace
}  // namespace smile::sizes
