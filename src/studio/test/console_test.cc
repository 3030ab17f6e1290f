#include "studio/console.h"

#include <gtest/gtest.h>

namespace smile::studio {
namespace {

TEST(Console, FindsTheFileAndLineThatALineNames) {
  const auto place = [](const char* text) {
    const ConsoleLine line = ParseConsoleLine(text);
    return line.file + ":" + std::to_string(line.line);
  };
  EXPECT_EQ(place("wave/waveCallback.m:12: 'x' undefined"), "wave/waveCallback.m:12");
  EXPECT_EQ(place("  File \"wave.py\", line 7, in step"), "wave.py:7");
  EXPECT_EQ(place("    waveCallback at line 3 column 5"), "waveCallback.m:3");
  EXPECT_EQ(place("at 12:30 there were 5.0 blocks"), ":0");
  EXPECT_EQ(place("x.m:0 x.m:99999999999999 :"), ":0");
  EXPECT_EQ(place(""), ":0");
}

TEST(Console, KeepsTheNewestLinesOfAFlood) {
  Console console;
  for (std::size_t i = 0; i < Console::kMaxLines + 5; ++i) console.Write(std::to_string(i));
  const std::vector<ConsoleLine> lines = console.Take();
  EXPECT_EQ(lines.front().text, "... 5 lines omitted");
  EXPECT_EQ(lines.back().text, std::to_string(Console::kMaxLines + 4));
  EXPECT_TRUE(console.Take().empty());
}

}  // namespace
}  // namespace smile::studio
