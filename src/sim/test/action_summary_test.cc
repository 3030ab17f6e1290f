#include "sim/action_summary.h"

#include <gtest/gtest.h>

namespace smile::sim {
namespace {

ActionSummary SummaryOfARelease(HandName hand, const std::optional<model::Support>& support) {
  return *SummaryOf({.kind = EventKind::kReleased, .hand = hand, .object = "a"}, support);
}

TEST(ActionSummary, ReportsWhereAnObjectWasReleased) {
  const model::Support crate{.object = "crate", .is_inside = true};
  EXPECT_EQ(WordsOf(SummaryOfARelease(HandName::kBoth, crate)), "both hands put a into crate");
  EXPECT_EQ(WordsOf(SummaryOfARelease(HandName::kLeft, model::Support{.height = 0.1})),
            "left hand drops a on the table");
  EXPECT_EQ(WordsOf(SummaryOfARelease(HandName::kBoth, std::nullopt)), "both hands release a");
}

TEST(ActionSummary, HasItsFieldsForOtherLanguages) {
  const Json in_crate = ToJson(
      SummaryOfARelease(HandName::kLeft, model::Support{.object = "crate", .is_inside = true}));
  EXPECT_EQ(
      in_crate,
      Json::parse(
          R"({"do":"put","hand":"left","what":"a","into":"crate","words":"left hand puts a into crate"})"));
  const Json on_table = ToJson(SummaryOfARelease(HandName::kLeft, model::Support{.height = 0.1}));
  EXPECT_EQ(
      on_table,
      Json::parse(
          R"({"do":"drop","hand":"left","what":"a","on":"","words":"left hand drops a on the table"})"));
}

TEST(ActionSummary, DescribesOnlyActionsOfHands) {
  EXPECT_EQ(SummaryOf({.kind = EventKind::kCommandRefused}, std::nullopt), std::nullopt);
  const auto pointing = SummaryOf(
      {.kind = EventKind::kPointed, .hand = HandName::kRight, .part = "lid"}, std::nullopt);
  ASSERT_TRUE(pointing);
  EXPECT_EQ(WordsOf(*pointing), "right hand points at lid");
}

TEST(ActionSummary, EachActionHasAnEventOfAHand) {
  EXPECT_TRUE(IsAction(Grasp()));
  EXPECT_TRUE(IsAction(Loosen()));
  EXPECT_FALSE(IsAction(MoveTo()));
  EXPECT_FALSE(IsAction(Attend()));
  EXPECT_TRUE(BeginsAction({.kind = EventKind::kGrasped, .hand = HandName::kBoth}));
  EXPECT_TRUE(BeginsAction({.kind = EventKind::kLoosened, .hand = HandName::kAny}));
  EXPECT_FALSE(BeginsAction({.kind = EventKind::kLoosened})) << "came free by itself";
  EXPECT_FALSE(BeginsAction({.kind = EventKind::kAttended, .hand = HandName::kLeft}));
}

}  // namespace
}  // namespace smile::sim
