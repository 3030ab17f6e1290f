#include "base/wording.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace smile {
namespace {

constexpr std::array<std::string_view, 4> kShapes{"block", "box", "composite", "sphere"};

TEST(Quoted, KeepsAMessageReadable) {
  EXPECT_EQ(Quoted("red"), "\"red\"");
  EXPECT_EQ(Quoted("two\nlines\x01"), "\"two?lines?\"");
  EXPECT_EQ(Quoted(std::string(1000, 'x')), "\"" + std::string(60, 'x') + "…\"");
}

TEST(Quoted, NeverCutsALetterInTwo) {
  const std::string cut = Quoted(std::string(59, 'x') + "ü and more");
  EXPECT_EQ(cut, "\"" + std::string(59, 'x') + "…\"");
}

TEST(OneOf, ListsWordsAsInASentence) {
  EXPECT_EQ(OneOf({}), "");
  EXPECT_EQ(OneOf(std::span(kShapes).first(1)), "block");
  EXPECT_EQ(OneOf(std::span(kShapes).first(2)), "block or box");
  EXPECT_EQ(OneOf(kShapes), "block, box, composite or sphere");
}

TEST(DidYouMean, SuggestsTheNearestWord) {
  EXPECT_EQ(DidYouMean("blok", kShapes), "; did you mean \"block\"?");
  EXPECT_EQ(DidYouMean("Sphere", kShapes), "; did you mean \"sphere\"?");
  EXPECT_EQ(DidYouMean("bxo", kShapes), "; did you mean \"box\"?") << "a swap is one slip";
  EXPECT_EQ(DidYouMean("compositum", kShapes), "; did you mean \"composite\"?");
}

TEST(DidYouMean, SuggestsNothingWithoutANearWord) {
  for (const char* word : {"", "x", "chain", "def", "cylinder"}) {
    EXPECT_EQ(DidYouMean(word, kShapes), "") << word;
  }
  EXPECT_EQ(DidYouMean(std::string(10'000'000, 'b'), kShapes), "");
}

}  // namespace
}  // namespace smile
