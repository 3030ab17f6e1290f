// Moving and copying several objects together, without a hand.

#include "everything_scene.h"
#include "random_hands.h"
#include "sim/duplicate.h"
#include "simulation_fixture.h"

namespace smile::sim {
namespace {

class DisplaceTest : public SimulationFixture {
 protected:
  std::optional<Refusal> Move(const std::vector<std::string>& objects, const Vector3& by) {
    return simulation_->Apply(Displace{.objects = objects, .by = by});
  }
  /// Returns the reason why nothing was moved.
  std::string RefusalOf(const std::vector<std::string>& objects, const Vector3& by) {
    const std::uint64_t before = simulation_->state_hash();
    const auto refusal = Move(objects, by);
    EXPECT_EQ(simulation_->state_hash(), before);
    return refusal.value_or("they were moved");
  }
  Vector3 Place(std::string_view id) const { return PositionOf(*simulation_, id); }

  /// Two blocks, one on the other, a third one beside them, and a fixed one.
  std::unique_ptr<Simulation> simulation_ =
      MakeSimulation({BlockAt("low", {0, 0, 0.05}), BlockAt("high", {0.02, 0, 0.15}),
                      BlockAt("other", {0.3, 0, 0.05}), BlockAt("wall", {-0.5, 0, 0.05}, 0)},
                     false);
};

TEST_F(DisplaceTest, ObjectsKeepTheirPlacesToEachOther) {
  TickSeconds(*simulation_, 0.5);
  const Vector3 between = Place("high") - Place("low"), other = Place("other");
  ASSERT_EQ(Move({"low", "high"}, {0, 0.2, 0}), std::nullopt);
  EXPECT_EQ(WordsOf(*simulation_->history().current().summary), "moved 2 objects");
  EXPECT_NEAR(Place("low").y(), 0.2, 1e-3);
  EXPECT_LT((Place("high") - Place("low") - between).norm(), 1e-12);
  TickSeconds(*simulation_, 0.5);
  EXPECT_LT((Place("high") - Place("low") - between).norm(), 1e-4) << "they still stand";
  EXPECT_LT((Place("other") - other).norm(), 1e-4);
}

TEST_F(DisplaceTest, WhatStoodOnThemFalls) {
  TickSeconds(*simulation_, 1);
  ASSERT_EQ(Move({"low"}, {0, 0.3, 0}), std::nullopt);
  EXPECT_EQ(WordsOf(*simulation_->history().current().summary), "moved low");
  TickSeconds(*simulation_, 1);
  EXPECT_NEAR(Place("high").z(), 0.05, 1e-3);
}

TEST_F(DisplaceTest, UndoAndRedoAreExact) {
  TickSeconds(*simulation_, 0.1);
  const std::uint64_t before = simulation_->state_hash();
  ASSERT_EQ(Move({"high", "other"}, {0.1, 0.3, 0.2}), std::nullopt);
  TickSeconds(*simulation_, 0.2);
  const std::uint64_t after = simulation_->state_hash();
  ASSERT_EQ(simulation_->Apply(Undo()), std::nullopt);
  EXPECT_EQ(simulation_->state_hash(), before);
  TickSeconds(*simulation_, 0.3);
  ASSERT_EQ(simulation_->Apply(Redo()), std::nullopt);
  EXPECT_EQ(simulation_->state_hash(), after);
}

TEST_F(DisplaceTest, ReportsWhyNothingMoves) {
  EXPECT_EQ(RefusalOf({"low", "none"}, {0, 1, 0}), "there is no object 'none'");
  EXPECT_EQ(RefusalOf({"low", "other", "low"}, {0, 1, 0}), "'low' is named twice");
  EXPECT_EQ(RefusalOf({"wall"}, {0, 0.1, 0}), "'wall' is fixed");
  EXPECT_EQ(RefusalOf({"low"}, {0.3, 0, 0}), "there is no room for 'low': 'other' is in the way");
  EXPECT_EQ(RefusalOf({"other"}, {0, 0, -0.05}),
            "there is no room for 'other': the table is in the way");
  ASSERT_EQ(simulation_->Apply(Grasp{.hand = HandName::kLeft, .object = "high"}), std::nullopt);
  EXPECT_EQ(RefusalOf({"low", "high"}, {0, 0.2, 0}), "'high' is held; release it first");
  simulation_ = MakeSimulation({BlockAt("low", {0, 0, 0.05})}, /*with_robot=*/true);
  EXPECT_NE(RefusalOf({"low"}, {0, -0.95, 0.3}).find("the robot is in the way"), std::string::npos);
}

TEST_F(DisplaceTest, WhatIsConnectedMovesToo) {
  Simulation simulation(EverythingScene::Make());
  const Vector3 screw = PositionOf(simulation, "screw"), drawer = PositionOf(simulation, "drawer");
  const Vector3 by(0, 0.1, 0.3);
  ASSERT_EQ(simulation.Apply(Displace{.objects = {"nut", "case"}, .by = by}), std::nullopt);
  EXPECT_LT((PositionOf(simulation, "screw") - screw - by).norm(), 1e-9) << "it is in the nut";
  EXPECT_LT((PositionOf(simulation, "drawer") - drawer - by).norm(), 1e-9);
}

class DisplaceProperty : public SimulationFixture,
                         public ::testing::WithParamInterface<unsigned> {};

INSTANTIATE_TEST_SUITE_P(Seeds, DisplaceProperty, testing::Range(41u, 44u));

TEST_P(DisplaceProperty, MovingSeveralObjectsReplaysAndIsUndoneExactly) {
  Simulation simulation(EverythingScene::Make());
  RandomHands hands(GetParam());
  const auto& objects = simulation.tabletop().objects();
  int num_moved = 0;
  for (int i = 0; i < 250; ++i) {
    const auto id_at = [&](int place) {
      return objects[static_cast<std::size_t>(place) % objects.size()].id();
    };
    const Command command = i % 4 != 0
                                ? hands.Next(simulation)
                                : Displace{.objects = {id_at(i / 4), id_at(i / 4 + 1)},
                                           .by = {0.01 * (i % 7 - 3), 0.02 * (i % 5 - 2), 0.3}};
    const std::uint64_t before = simulation.state_hash();
    if (simulation.Apply(command)) {
      ASSERT_EQ(simulation.state_hash(), before) << "a refused command changed something";
    } else if (std::holds_alternative<Displace>(command)) {
      ++num_moved;
      const std::uint64_t after = simulation.state_hash();
      ASSERT_EQ(simulation.Apply(Undo()), std::nullopt);
      EXPECT_EQ(simulation.state_hash(), before);
      ASSERT_EQ(simulation.Apply(Redo()), std::nullopt);
      EXPECT_EQ(simulation.state_hash(), after);
    }
    if (i % 3 == 0) simulation.Tick();
  }
  EXPECT_GT(num_moved, 2);
  Simulation again(simulation.start_model());
  for (const TimedCommand& timed : simulation.history().CommandsDone()) {
    while (again.tick() < timed.tick) again.Tick();
    ASSERT_EQ(again.Apply(timed.command), std::nullopt);
  }
  while (again.tick() < simulation.tick()) again.Tick();
  EXPECT_EQ(again.state_hash(), simulation.state_hash());
}

class DuplicateTest : public DisplaceTest {
 protected:
  /// Adds copies; returns the reason if there are none.
  std::optional<Refusal> Copy(const Duplicate& duplicate) {
    Refusal refusal;
    const auto spawn = SpawnOf(duplicate, *simulation_, &refusal);
    return spawn ? simulation_->Apply(*spawn) : refusal;
  }
};

TEST_F(DuplicateTest, CopiesStandToEachOtherAsTheObjectsDo) {
  TickSeconds(*simulation_, 0.5);
  const Vector3 between = Place("high") - Place("low");
  ASSERT_EQ(Copy({.objects = {"low", "high"}, .by = Vector3(0, 0.3, 0)}), std::nullopt);
  EXPECT_EQ(WordsOf(*simulation_->history().current().summary), "added 2 objects");
  EXPECT_LT((Place("low_2") - Place("low") - Vector3(0, 0.3, 0)).norm(), 1e-9);
  EXPECT_LT((Place("high_2") - Place("low_2") - between).norm(), 1e-9);
  ASSERT_EQ(Copy({.objects = {"low_2"}, .by = Vector3(0.3, 0, 0)}), std::nullopt);
  EXPECT_NE(simulation_->tabletop().Find("low_3"), nullptr) << "numbers go on";
}

TEST_F(DuplicateTest, WithoutAPlaceCopiesStandBesideTheObjects) {
  for (int i = 0; i < 5; ++i) {
    ASSERT_EQ(Copy({.objects = {"low", "high"}, .by = std::nullopt}), std::nullopt) << i;
  }
  TickSeconds(*simulation_, 1);
  for (const char* id : {"low_2", "low_6"}) EXPECT_NEAR(Place(id).z(), 0.05, 1e-3) << id;
  for (const char* id : {"high", "high_6"}) EXPECT_NEAR(Place(id).z(), 0.15, 1e-3) << id;
}

TEST_F(DuplicateTest, ReportsWhyNothingIsCopied) {
  EXPECT_EQ(Copy({.objects = {"none"}, .by = std::nullopt}), "there is no object 'none'");
  EXPECT_EQ(Copy({.objects = {"low", "low"}, .by = std::nullopt}), "'low' is named twice");
  EXPECT_EQ(Copy({.objects = {"low"}, .by = Vector3(0.3, 0, 0)}),
            "there is no room for 'low_2': 'other' is in the way");
  simulation_ = std::make_unique<Simulation>(EverythingScene::Make());
  for (const char* id : {"panel", "nut", "screw", "drawer"}) {
    EXPECT_EQ(Copy({.objects = {"ball", id}, .by = std::nullopt}),
              "'" + std::string(id) + "' cannot be copied: it has mechanisms or a mesh of its own");
  }
  EXPECT_EQ(Copy({.objects = {"ball"}, .by = Vector3(0, 0.3, 0)}), std::nullopt);
}

TEST_F(DuplicateTest, IsWrittenLikeACommand) {
  const Json json = Json::parse(R"({"do":"duplicate","objects":["low"],"by":[1,2,3]})");
  ASSERT_TRUE(IsDuplicate(json));
  EXPECT_EQ(ParseDuplicate(json, 0.1),
            (Duplicate{.objects = {"low"}, .by = Vector3(0.1, 0.2, 0.3)}));
  EXPECT_THROW(ParseDuplicate(Json::parse(R"({"do":"duplicate","objects":[]})"), 0.1),
               std::invalid_argument);
  EXPECT_THROW(ParseDuplicate(Json::parse(R"({"do":"duplicate","object":"low"})"), 0.1),
               std::invalid_argument);
}

}  // namespace
}  // namespace smile::sim
