#include "task/goals.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "structure_maker.h"
#include "task/comparison.h"

namespace smile::task {
namespace {

using Ids = std::vector<std::string>;

constexpr double kMetersPerUnit = 0.1;

/// Two cubes on each other, all of another color, and one that stands apart.
Structure TowerAndLoner() {
  return {
      .objects = {CubeAt("a", {0.1, 0, 0.05}, {1, 0, 0}), CubeAt("b", {0.1, 0, 0.15}, {0, 1, 0}),
                  CubeAt("loner", {0.4, 0.1, 0.05}, {0, 0, 1})},
      .relations = {{"a", Relation::Kind::kOn, ""},
                    {"b", Relation::Kind::kOn, "a"},
                    {"loner", Relation::Kind::kOn, ""}},
      .order = {"a", "b", "loner"}};
}

/// The same, but the loner stands elsewhere.
Episode WithLonerAt(const Vector3& place) {
  std::vector<scene::ObjectSpec> outcome = TowerAndLoner().objects;
  outcome.back().whole.X_PE = RigidTransform(place);
  return EpisodeTo(outcome);
}

TEST(Goals, ArePlacesAndEffects) {
  Structure structure = TowerAndLoner();
  structure.effects.push_back(OrientedEffect{.object = "b", .angle = 1, .is_tilt = true});
  const std::vector<Goal> goals = GoalsOf(structure, kMetersPerUnit);
  ASSERT_EQ(goals.size(), 4u);
  EXPECT_EQ(goals[1], (Goal{"b", "b on a"}));
  EXPECT_EQ(goals[3].words, WordsOf(structure.effects.front(), kMetersPerUnit));
  EXPECT_FALSE(goals[3].is_place);
  const Structure rest = WithoutGoals(structure, {goals[3].id}, kMetersPerUnit);
  EXPECT_TRUE(rest.effects.empty());
  EXPECT_EQ(rest.objects.size(), 3u);
}

TEST(Goals, WhatDoesNotCountMayBeAnywhere) {
  const Episode apart = WithLonerAt({-0.4, 0.3, 0.05}), beside = WithLonerAt({0.2, 0, 0.05});
  EXPECT_FALSE(CompareWith(TowerAndLoner(), apart).is_achieved());
  const Structure tower = WithoutGoals(TowerAndLoner(), {"loner"}, kMetersPerUnit);
  EXPECT_EQ(tower.order, (Ids{"a", "b"}));
  EXPECT_TRUE(CompareWith(tower, apart).is_achieved());
  EXPECT_TRUE(CompareWith(tower, beside).is_achieved()) << "no intruder";
}

TEST(Goals, WithoutItsLandmarkAStructureMayStandAnywhere) {
  Structure structure = TowerAndLoner();
  structure.anchor = Anchor::kLandmark;
  structure.landmark = "loner";
  EXPECT_FALSE(structure.is_free());
  EXPECT_TRUE(WithoutGoals(structure, {"loner"}, kMetersPerUnit).is_free());
}

TEST(Goals, RefusesWhatIsNoGoal) {
  try {
    (void)WithoutGoals(TowerAndLoner(), {"lonar"}, kMetersPerUnit);
    FAIL() << "was accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(),
                 "goals: found \"lonar\", expected a, b or loner; did you mean \"loner\"?");
  }
  EXPECT_THROW((void)WithoutGoals(TowerAndLoner(), {"a", "b", "loner"}, kMetersPerUnit),
               std::invalid_argument);
}

}  // namespace
}  // namespace smile::task
