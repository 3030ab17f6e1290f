#include "task/rules.h"

#include <gtest/gtest.h>

#include "structure_maker.h"
#include "task/comparison.h"
#include "task/failure_reason.h"
#include "task/imitation_result.h"
#include "task/structure_json.h"

namespace smile::task {
namespace {

using Ids = std::vector<std::string>;

scene::ObjectSpec DiscAt(const std::string& id, double radius, const Vector3& p) {
  return ObjectAt(id, scene::Frustum{.radius_top = radius, .radius_bottom = radius, .height = 0.1},
                  p);
}

/// Two discs of a tower on its way from the left to the right.
class Rules : public ::testing::Test {
 protected:
  Rules() {
    structure_.objects = {DiscAt("large", 0.06, {0.3, 0, 0.05}),
                          DiscAt("small", 0.04, {0.3, 0, 0.15})};
    structure_.order = {"large", "small"};
    episode_ = EpisodeBetween(
        {DiscAt("large", 0.06, {-0.3, 0, 0.05}), DiscAt("small", 0.04, {-0.3, 0, 0.15})},
        structure_.objects);
  }

  void Put(const std::string& object, const Ids& supports_before, std::uint64_t seconds) {
    using enum sim::EventKind;
    const std::uint64_t tick = seconds * sim::kTicksPerSecond;
    episode_.contacts.push_back({{.kind = kGripperHolds, .arm = "left", .object = object},
                                 tick,
                                 RigidTransform(Vector3(0, 0, 1)),
                                 supports_before});
    episode_.contacts.push_back({{.kind = kGripperReleased, .arm = "left", .object = object},
                                 tick + sim::kTicksPerSecond,
                                 {}});
  }

  std::string ReasonOf(const StructureComparison& comparison) {
    const auto reason = FailureReasonOf(structure_, episode_, comparison, {.status = "exited"});
    return reason ? reason->code + ": " + reason->text : "";
  }

  Structure structure_;
  Episode episode_;
};

TEST_F(Rules, NothingStandsOnASmallerObject) {
  Put("small", {"large"}, 0);
  Put("large", {}, 2);
  Put("large", {"small"}, 4);
  Put("small", {}, 6);
  EXPECT_TRUE(CompareWith(structure_, episode_).is_achieved()) << "no rule was stated";

  structure_.attention = {{"large", {"support"}}};
  structure_.support_rules = SupportRulesOf(structure_.attention, AtBegin(episode_));
  const StructureComparison comparison = CompareWith(structure_, episode_);
  EXPECT_EQ(comparison.broken_rules,
            (std::vector<RuleBreak>{{RuleBreak::Rule::kSupport, "large", "small", 3}}));
  EXPECT_DOUBLE_EQ(comparison.score, 2.0 / 3);
  EXPECT_EQ(ReasonOf(comparison), "rule_broken: large was put on small, which is smaller, at 3 s");
  EXPECT_EQ(CompareWith(structure_, AtBegin(episode_)).broken_rules, std::vector<RuleBreak>());
}

TEST_F(Rules, WhatTheDemonstrationPutOnASmallerObjectMayStandThere) {
  Put("small", {"large"}, 0);
  Put("large", {}, 2);
  Put("large", {"small"}, 4);
  structure_.attention = {{"large", {"support"}}, {"small", {"support"}}};
  structure_.support_rules = SupportRulesOf(structure_.attention, episode_);
  EXPECT_EQ(WordsOf(structure_, 0.1).back(), "small must never stand on a smaller object");
  EXPECT_EQ(WordsOf(structure_, 0.1).end()[-2],
            "large must never stand on a smaller object, except on small");
  EXPECT_EQ(ToJson(structure_, 0.1)["rules"][0],
            Json({{"rule", "support"}, {"object", "large"}, {"except_on", {"small"}}}));
  EXPECT_EQ(CompareWith(structure_, episode_).broken_rules, std::vector<RuleBreak>());
}

TEST_F(Rules, AnOrderThatMattersIsPartOfSuccess) {
  Put("small", {"large"}, 0);
  Put("large", {}, 2);
  EXPECT_EQ(CompareWith(structure_, episode_).score, 1);
  structure_.attention = {{"small", {"order"}}};
  const StructureComparison comparison = CompareWith(structure_, episode_);
  EXPECT_LT(comparison.score, 1);
  EXPECT_EQ(ReasonOf(comparison),
            "rule_broken: large was placed after small, at 3 s, and demonstrated before it");
  Put("small", {}, 4);  // once more, now in the order of the demonstration
  EXPECT_EQ(CompareWith(structure_, episode_).score, 1);
}

}  // namespace
}  // namespace smile::task
