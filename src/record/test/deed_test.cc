#include "record/deed.h"

#include <gtest/gtest.h>

namespace smile::record {
namespace {

using demonstrator::HandName;

Deed DeedOfRelease(HandName hand, const std::optional<Support>& support) {
  return *DeedOf({.kind = sim::EventKind::kReleased, .hand = hand, .object = "a"}, support);
}

TEST(Deed, TellsWhereSomethingWasLetGo) {
  const Support crate{.object = "crate", .is_container = true};
  EXPECT_EQ(WordsOf(DeedOfRelease(HandName::kBoth, crate)), "both hands put a into crate");
  EXPECT_EQ(WordsOf(DeedOfRelease(HandName::kLeft, Support{.height = 0.1})),
            "left hand drops a on the table");
  EXPECT_EQ(WordsOf(DeedOfRelease(HandName::kBoth, std::nullopt)), "both hands release a");
}

TEST(Deed, HasItsFieldsForOtherLanguages) {
  const Json in_crate =
      ToJson(DeedOfRelease(HandName::kLeft, Support{.object = "crate", .is_container = true}));
  EXPECT_EQ(in_crate, Json::parse(R"({"do":"put","hand":"left","what":"a","into":"crate",
                                      "words":"left hand puts a into crate"})"));
  const Json on_table = ToJson(DeedOfRelease(HandName::kLeft, Support{.height = 0.1}));
  EXPECT_EQ(on_table, Json::parse(R"({"do":"drop","hand":"left","what":"a","on":"",
                                      "words":"left hand drops a on the table"})"));
}

TEST(Deed, IsOfHandsOnly) {
  EXPECT_EQ(DeedOf({.kind = sim::EventKind::kCommandRefused}, std::nullopt), std::nullopt);
  const auto pointing = DeedOf(
      {.kind = sim::EventKind::kPointed, .hand = HandName::kRight, .part = "lid"}, std::nullopt);
  ASSERT_TRUE(pointing);
  EXPECT_EQ(WordsOf(*pointing), "right hand points at lid");
}

}  // namespace
}  // namespace smile::record
