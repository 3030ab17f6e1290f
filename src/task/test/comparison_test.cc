#include "task/comparison.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include "base/diagnostic.h"
#include "base/uniform.h"
#include "structure_maker.h"
#include "task/neighbors.h"

namespace smile::task {
namespace {

const Color kRed{1, 0, 0}, kBlue{0, 0, 1};

/// Three high, and one that stands apart.
Structure Tower() {
  return {.objects = {CubeAt("a", {0.1, 0, 0.05}), CubeAt("b", {0.1, 0, 0.15}),
                      CubeAt("c", {0.1, 0, 0.25}), CubeAt("d", {0.4, 0.1, 0.05})},
          .order = {"a", "b", "c", "d"}};
}

/// Its members all look different.
Structure Colored(Structure structure) {
  double shade = 0;
  for (scene::ObjectSpec& object : structure.objects) object.whole.color.green = shade += 0.1;
  return structure;
}

TEST(StructureComparison, IsPerfectAfterAnyMotionAndExchangeOfEqualObjects) {
  std::mt19937_64 random(1);
  for (int trial = 0; trial < 60; ++trial) {
    Structure structure;
    for (int i = 0; i < 12; ++i) {
      const Vector3 p(Uniform(&random, -0.4, 0.4), Uniform(&random, -0.3, 0.3),
                      0.05 + 0.1 * (i % 3));
      structure.objects.push_back(CubeAt("b" + std::to_string(i), p, i < 6 ? kRed : kBlue));
    }
    std::vector<scene::ObjectSpec> outcome =
        Moved(structure.objects, Uniform(&random, -180, 180),
              {Uniform(&random, -0.5, 0.5), Uniform(&random, -0.5, 0.5), 0});
    std::vector<RigidTransform> poses;
    for (const auto& object : outcome) poses.push_back(object.pose_in_world());
    std::shuffle(poses.begin(), poses.begin() + 6, random);
    std::shuffle(poses.begin() + 6, poses.end(), random);
    for (std::size_t i = 0; i < outcome.size(); ++i) outcome[i].whole.X_PE = poses[i];
    outcome.push_back(CubeAt("distractor", {0, 0.9, 0.05}, kRed));

    const StructureComparison comparison = CompareWith(structure, EpisodeTo(outcome));
    ASSERT_TRUE(comparison.is_achieved()) << "trial " << trial;
    EXPECT_LT(comparison.mean_error().distance, 1e-9);
    EXPECT_LT(comparison.mean_error().angle, 1e-6);
    std::set<std::string> used;
    for (const auto& [id, counterpart] : comparison.match) used.insert(counterpart);
    EXPECT_EQ(used.size(), 12u);
  }
}

TEST(StructureComparison, SwappedColorsAreNotRebuilt) {
  Structure structure{.objects = {CubeAt("r", {0, 0, 0.05}, kRed), CubeAt("b", {0, 0, 0.15}, kBlue),
                                  CubeAt("s", {0.3, 0, 0.05}, kRed)}};
  std::vector<scene::ObjectSpec> outcome = structure.objects;
  std::swap(outcome[0].whole.X_PE, outcome[2].whole.X_PE);
  EXPECT_TRUE(CompareWith(structure, EpisodeTo(outcome)).is_achieved());
  std::swap(outcome[0].whole.X_PE, outcome[1].whole.X_PE);
  EXPECT_FALSE(CompareWith(structure, EpisodeTo(outcome)).is_achieved());
}

TEST(StructureComparison, TakesForAlikeWhatAgreesInTheAttendedProperties) {
  Structure structure{.objects = {CubeAt("r", {0, 0, 0.05}, kRed),
                                  CubeAt("b", {0.3, 0, 0.05}, kBlue),
                                  ObjectAt("p", scene::Block{{0.1, 0.3, 0.1}}, {0, 0.3, 0.05})}};
  std::vector<scene::ObjectSpec> outcome = structure.objects;
  std::swap(outcome[0].whole.X_PE, outcome[1].whole.X_PE);
  EXPECT_FALSE(CompareWith(structure, EpisodeTo(outcome)).is_achieved());
  structure.attention = {{"r", {"size", "position"}}, {"b", {"size"}}};
  EXPECT_TRUE(CompareWith(structure, EpisodeTo(outcome)).is_achieved());
  // Placing alone does not compare appearance.
  structure.attention = {{"r", {"position"}}, {"b", {"order"}}};
  EXPECT_FALSE(CompareWith(structure, EpisodeTo(outcome)).is_achieved());
}

TEST(StructureComparison, OneFallenBlockDoesNotAffectTheOthers) {
  std::vector<scene::ObjectSpec> outcome = Moved(Tower().objects, 20, {0.2, 0.1, 0});
  outcome[2].whole.X_PE = RigidTransform(Vector3(0.7, 0.7, 0.05));
  const StructureComparison comparison = CompareWith(Tower(), EpisodeTo(outcome));
  EXPECT_DOUBLE_EQ(comparison.score, 0.75);
  EXPECT_LT(comparison.errors.at("a").distance, 0.001);
  EXPECT_GT(comparison.errors.at("c").distance, 0.2);
}

TEST(StructureComparison, HeightsAreNotShifted) {
  const auto outcome = Moved(Tower().objects, 0, {0, 0, 0.4});
  EXPECT_EQ(CompareWith(Tower(), EpisodeTo(outcome)).score, 0);
}

TEST(StructureComparison, SmallErrorsAreMeasured) {
  std::vector<scene::ObjectSpec> outcome = Tower().objects;
  outcome[3].whole.X_PE = RigidTransform(Vector3(0.41, 0.1, 0.05));
  const StructureComparison comparison = CompareWith(Tower(), EpisodeTo(outcome));
  EXPECT_TRUE(comparison.is_achieved());
  EXPECT_GT(comparison.mean_error().distance, 0.001);
  EXPECT_LT(comparison.mean_error().distance, 0.005);
}

TEST(StructureComparison, ATurnOfAPartIsAnErrorUnlessItLooksTheSame) {
  const scene::Block plank{{0.4, 0.1, 0.1}};
  const Structure structure{.objects = {ObjectAt("p", plank, {0, 0, 0.05}),
                                        ObjectAt("q", plank, {0, 0, 0.15}, kRed),
                                        CubeAt("c", {0, 0, 0.25})}};
  const auto with_turns = [&](double q_deg, double c_deg) {
    std::vector<scene::ObjectSpec> outcome = structure.objects;
    outcome[1] = ObjectAt("q", plank, {0, 0, 0.15}, kRed, q_deg);
    outcome[2] = ObjectAt("c", scene::Block{}, {0, 0, 0.25}, {}, c_deg);
    return CompareWith(structure, EpisodeTo(Moved(outcome, 77, {0.1, 0.1, 0})));
  };
  EXPECT_LT(with_turns(180, 90).mean_error().angle, 1e-6);
  EXPECT_TRUE(with_turns(180, 90).is_achieved());
  const StructureComparison crossed = with_turns(90, 0);
  EXPECT_FALSE(crossed.is_achieved());
  EXPECT_NEAR(crossed.errors.at("q").angle + crossed.errors.at("p").angle, DegreesToRadians(90.0),
              1e-6);
}

TEST(StructureComparison, AStructureOnAFixedObjectHasOnePlace) {
  Structure structure{.objects = {ObjectAt("tray", scene::Block{{0.4, 0.3, 0.1}}, {0, 0, 0.05}),
                                  CubeAt("c", {0.1, 0, 0.15})}};
  structure.objects[0].mass = 0;
  EXPECT_TRUE(structure.is_fixed());
  std::vector<scene::ObjectSpec> outcome = Moved(structure.objects, 30, {0.2, 0, 0});
  EXPECT_TRUE(CompareWith(structure, EpisodeTo(outcome)).is_achieved());
  // A tray is the same the other way round, but its length and width differ.
  outcome[1].whole.X_PE = outcome[0].pose_in_world() * RigidTransform(Vector3(-0.1, 0, 0.1));
  EXPECT_TRUE(CompareWith(structure, EpisodeTo(outcome)).is_achieved());
  outcome[1].whole.X_PE = outcome[0].pose_in_world() * RigidTransform(Vector3(0, 0.1, 0.1));
  const StructureComparison aside = CompareWith(structure, EpisodeTo(outcome));
  EXPECT_EQ(aside.score, 0.5);
  EXPECT_EQ(aside.errors.at("tray").distance, 0);
}

TEST(StructureComparison, EachFixedObjectHasAPlaceOfItsOwn) {
  Structure structure{.objects = {ObjectAt("tray", scene::Block{{0.4, 0.3, 0.1}}, {0, 0, 0.05}),
                                  CubeAt("c", {0.1, 0, 0.15}), CubeAt("d", {0.1, 0, 0.25}),
                                  ObjectAt("bin", scene::Block{{0.2, 0.3, 0.1}}, {0.5, 0, 0.05}),
                                  CubeAt("e", {0.5, 0.1, 0.15})},
                      .relations = {{"tray", Relation::Kind::kOn, ""},
                                    {"c", Relation::Kind::kOn, "tray"},
                                    {"d", Relation::Kind::kOn, "c"},
                                    {"bin", Relation::Kind::kOn, ""},
                                    {"e", Relation::Kind::kOn, "bin"}}};
  structure.objects[0].mass = structure.objects[3].mass = 0;
  std::vector<scene::ObjectSpec> outcome = Moved(structure.objects, 10, {0.2, 0, 0});
  const RigidTransform X_moved(RotationFromFixedAxes({0, 0, -20}), Vector3(-0.1, 0.4, 0));
  for (std::size_t i : {3u, 4u}) {
    outcome[i].whole.X_PE = X_moved * structure.objects[i].pose_in_world();
  }
  EXPECT_TRUE(CompareWith(structure, EpisodeTo(outcome)).is_achieved());
  // The cubes look alike, so that any may be the one in the bin; one beside it is not.
  std::swap(outcome[1].whole.X_PE, outcome[4].whole.X_PE);
  EXPECT_TRUE(CompareWith(structure, EpisodeTo(outcome)).is_achieved());
  outcome[1].whole.X_PE = RigidTransform(Vector3(0, 0, 0.05));
  const StructureComparison beside = CompareWith(structure, EpisodeTo(outcome));
  EXPECT_EQ(beside.score, 0.8);
  EXPECT_FALSE(beside.errors.at("e").is_within());
}

TEST(StructureComparison, WhatWasNotMovedMayStandAnywhereWithWhatItCarries) {
  const scene::Block plate{{0.2, 0.2, 0.02}};
  Structure structure{
      .objects = {ObjectAt("p", plate, {0, 0, 0.01}, kBlue),
                  ObjectAt("q", plate, {0.4, 0, 0.01}, kRed), CubeAt("a", {0, 0, 0.07}, kBlue),
                  CubeAt("b", {0.4, 0, 0.07}, kRed)},
      .relations = {{"p", Relation::Kind::kOn, ""},
                    {"q", Relation::Kind::kOn, ""},
                    {"a", Relation::Kind::kOn, "p"},
                    {"b", Relation::Kind::kOn, "q"}}};
  std::vector<scene::ObjectSpec> outcome = structure.objects;
  const RigidTransform X_moved(RotationFromFixedAxes({0, 0, 70}), Vector3(0.1, 0.5, 0));
  for (std::size_t i : {1u, 3u}) {
    outcome[i].whole.X_PE = X_moved * structure.objects[i].pose_in_world();
  }
  EXPECT_EQ(CompareWith(structure, EpisodeTo(outcome)).score, 0.5);
  structure.foundations = {"p", "q"};
  const StructureComparison comparison = CompareWith(structure, EpisodeTo(outcome));
  EXPECT_TRUE(comparison.is_achieved());
  EXPECT_FALSE(comparison.turn) << "each may be turned otherwise";
  // Each cube belongs on its own plate.
  std::vector<scene::ObjectSpec> exchanged = outcome;
  std::swap(exchanged[2].whole.X_PE, exchanged[3].whole.X_PE);
  EXPECT_EQ(CompareWith(structure, EpisodeTo(exchanged)).score, 0.5);
  // What touches both plates, or stands on none, keeps them together.
  structure.neighbors = {{"b", "p"}};
  EXPECT_FALSE(CompareWith(structure, EpisodeTo(outcome)).is_achieved());
  structure.neighbors.clear();
  structure.objects.push_back(CubeAt("c", {0, 0.6, 0.05}));
  outcome.push_back(structure.objects.back());
  EXPECT_EQ(CompareWith(structure, EpisodeTo(outcome)).score, 0.6);
}

TEST(StructureComparison, OfEqualFoundationsEachIsTheOneThatCarriesAsMuch) {
  const scene::Block plate{{0.2, 0.2, 0.02}};
  Structure structure{.objects = {ObjectAt("p", plate, {0, 0, 0.01}),
                                  ObjectAt("q", plate, {0.4, 0, 0.01}), CubeAt("a", {0, 0, 0.07}),
                                  CubeAt("b", {0.4, 0, 0.07}), CubeAt("c", {0.4, 0, 0.17})},
                      .relations = {{"a", Relation::Kind::kOn, "p"},
                                    {"b", Relation::Kind::kOn, "q"},
                                    {"c", Relation::Kind::kOn, "b"}},
                      .foundations = {"p", "q"}};
  std::vector<scene::ObjectSpec> outcome = structure.objects;
  for (std::size_t i : {0u, 2u}) {
    outcome[i].whole.X_PE =
        RigidTransform(Vector3(0.005, 0.4, 0)) * structure.objects[i].pose_in_world();
  }
  EXPECT_TRUE(CompareWith(structure, EpisodeTo(outcome)).is_achieved());
}

TEST(StructureComparison, ARingHasItsPlaceWhereItsFixedPostIs) {
  const scene::Ring ring{.radius_outer = 0.1, .radius_inner = 0.08, .height = 0.05};
  const scene::Block post{{0.05, 0.05, 0.4}};
  Structure structure{
      .objects = {ObjectAt("p", post, {0, 0, 0.2}), ObjectAt("q", post, {0.4, 0, 0.2}),
                  ObjectAt("r", ring, {0, 0, 0.025}),
                  ObjectAt("s", ring, {0.4, 0, 0.025}, {1, 0, 0})},
      .around = {{"r", "p"}, {"s", "q"}}};
  structure.objects[0].mass = structure.objects[1].mass = 0;
  std::vector<scene::ObjectSpec> outcome = structure.objects;
  for (std::size_t i : {1u, 3u}) {
    outcome[i].whole.X_PE =
        RigidTransform(Vector3(0, 0.2, 0)) * structure.objects[i].pose_in_world();
  }
  EXPECT_TRUE(CompareWith(structure, EpisodeTo(outcome)).is_achieved());
  // Where the ring would be relative to the other post.
  outcome[3].whole.X_PE = structure.objects[3].pose_in_world();
  EXPECT_EQ(CompareWith(structure, EpisodeTo(outcome)).score, 0.75);
}

TEST(StructureComparison, AChainMayBeCutAnywhereButNoOtherChain) {
  Structure structure{.objects = {CubeAt("scissors", {0, 0, 0.05})},
                      .effects = {CutEffect{"rope-link0", "rope between link 0 and 1", "scissors"}},
                      .others = {CubeAt("rope-link0", {0.5, 0, 0.05}, kRed)}};
  const auto is_achieved_by = [&](const std::string& cut) {
    std::vector<scene::ObjectSpec> objects = structure.objects;
    for (const char* id : {"rope-link0", "rope-link1", "other-link0"}) {
      objects.push_back(CubeAt(id, {0.5, 0, 0.05}, kRed));
    }
    Episode episode = EpisodeTo(objects);
    episode.scene.chains = {{.id = "rope", .link_ids = {"rope-link0", "rope-link1"}},
                            {.id = "other", .link_ids = {"other-link0"}}};
    sim::Event used{.kind = sim::EventKind::kUsed, .object = cut, .state = "cut"};
    episode.contacts.push_back({used, 1, {}});
    return CompareWith(structure, episode).is_achieved();
  };
  EXPECT_TRUE(is_achieved_by("rope-link0"));
  EXPECT_TRUE(is_achieved_by("rope-link1"));
  EXPECT_FALSE(is_achieved_by("other-link0"));
}

TEST(StructureComparison, AnyOfEqualObjectsMayBeRemoved) {
  // The demonstration destroys `a` and puts `b` onto `c`; here, `a` is on `c` and `b` on the floor.
  const Structure structure{
      .objects = {CubeAt("b", {0.3, 0, 0.15}, kRed), CubeAt("c", {0.3, 0, 0.05}, kBlue)},
      .order = {"b"},
      .effects = {DestroyedEffect{"a"}},
      .others = {CubeAt("a", {0, 0, 0.05}, kRed)}};
  const std::vector<scene::ObjectSpec> outcome{CubeAt("a", {0.3, 0, 0.15}, kRed),
                                               CubeAt("b", {1.2, 0, -0.7}, kRed),
                                               CubeAt("c", {0.3, 0, 0.05}, kBlue)};
  const StructureComparison comparison = CompareWith(structure, EpisodeTo(outcome));
  EXPECT_TRUE(comparison.is_achieved());
  EXPECT_EQ(comparison.match, (Match{{"a", "b"}, {"b", "a"}, {"c", "c"}}));
  // With both on the table, one is too many.
  std::vector<scene::ObjectSpec> kept = outcome;
  kept[1].whole.X_PE = RigidTransform(Vector3(0.6, 0, 0.05));
  EXPECT_EQ(CompareWith(structure, EpisodeTo(kept)).achieved, std::vector<bool>{false});
}

TEST(StructureComparison, EndsSoonWithIdenticalObjects) {
  Structure structure;
  for (int i = 0; i < 200; ++i) {
    structure.objects.push_back(
        CubeAt("b" + std::to_string(i), {0.11 * (i % 15), 0.11 * (i / 15), 0.05}));
  }
  std::vector<scene::ObjectSpec> outcome = structure.objects;
  outcome[0].whole.X_PE = RigidTransform(Vector3(0.5, -0.5, 0.05));
  EXPECT_GE(CompareWith(structure, EpisodeTo(outcome)).score, 0.9);
}

TEST(StructureComparison, HeldObjectsDoNotCount) {
  using enum sim::EventKind;
  const Structure tower = Colored(Tower());
  Episode episode = EpisodeTo(tower.objects);
  const auto contact = [&episode](const sim::Event& event) {
    episode.contacts.push_back({event, 1, {}});
  };
  contact({.kind = kGripperHolds, .arm = "left", .object = "c"});
  contact({.kind = kGrasped, .hand = sim::HandName::kRight, .object = "d"});
  EXPECT_EQ(CompareWith(tower, episode).score, 0.5);
  EXPECT_TRUE(CompareWith(tower, episode).errors.at("c").is_held);
  contact({.kind = kGripperHolds, .arm = "right", .object = "c"});
  contact({.kind = kGripperReleased, .arm = "left", .object = "c"});
  EXPECT_EQ(CompareWith(tower, episode).score, 0.5) << "the other arm has it";
  contact({.kind = kGripperReleased, .arm = "right", .object = "c"});
  contact({.kind = kReleased, .hand = sim::HandName::kRight, .object = "d"});
  EXPECT_TRUE(CompareWith(tower, episode).is_achieved());
}

TEST(StructureComparison, AHeldObjectIsNotInAContainer) {
  Structure structure{.objects = {ObjectAt("box", scene::Box{}, {0.5, 0.3, 0.05})},
                      .effects = {ContainerEffect{"high", "box", true}},
                      .others = {CubeAt("high", {0.5, 0.3, 0.05})}};
  Episode episode = EpisodeBetween({structure.objects[0], CubeAt("high", {0, 0, 0.05})},
                                   {structure.objects[0], structure.others[0]});
  ASSERT_TRUE(CompareWith(structure, episode).is_achieved());
  episode.contacts.push_back(
      {{.kind = sim::EventKind::kGripperHolds, .arm = "left", .object = "high"}, 1, {}});
  EXPECT_EQ(CompareWith(structure, episode).score, 0.5);
}

TEST(StructureComparison, ReportsPlacementsInTheDemonstratedOrder) {
  const Structure tower = Colored(Tower());
  Episode episode = EpisodeTo(tower.objects);
  const auto carry = [&](std::size_t i) {
    Carry(tower.objects[i].id(), episode.begin.objects[i].pose_in_world(),
          tower.objects[i].pose_in_world(), &episode);
  };
  carry(1);
  carry(0);
  carry(2);
  carry(3);
  Order order = CompareWith(tower, episode).order;
  EXPECT_EQ(order.done, (std::vector<std::string>{"b", "a", "c", "d"}));
  EXPECT_FALSE(order.is_kept());
  EXPECT_DOUBLE_EQ(order.fraction, 5.0 / 6);
  // Only the last time counts.
  carry(1);
  carry(2);
  carry(3);
  EXPECT_TRUE(CompareWith(tower, episode).order.is_kept());
}

/// Three high; neighbors as a demonstration has them.
Structure Stack() {
  Structure stack = Colored({.objects = {CubeAt("a", {0.1, 0, 0.05}), CubeAt("b", {0.1, 0, 0.15}),
                                         CubeAt("c", {0.1, 0, 0.25})},
                             .order = {"a", "b", "c"}});
  stack.neighbors = NeighborsOf(stack);
  return stack;
}

TEST(StructureComparison, NeighborsAreThoseThatTouchOrAlmostDo) {
  EXPECT_EQ(Stack().neighbors, (std::vector<Neighbors>{{"b", "a"}, {"c", "b"}}));
  Structure row{.objects = {CubeAt("a", {0, 0, 0.05}), CubeAt("b", {0.11, 0, 0.05}),
                            CubeAt("c", {0.3, 0, 0.05})},
                .order = {"b", "a"}};
  EXPECT_EQ(NeighborsOf(row), (std::vector<Neighbors>{{"a", "b"}}));
}

TEST(StructureComparison, ATwistedTowerIsNotThatTower) {
  std::vector<scene::ObjectSpec> outcome = Stack().objects;
  const auto with_middle = [&](double x, double angle_deg) {
    outcome[1].whole.X_PE =
        RigidTransform(RotationFromFixedAxes({0, 0, angle_deg}), {0.1 + x, 0, 0.15});
    return CompareWith(Stack(), EpisodeTo(outcome));
  };
  EXPECT_TRUE(with_middle(0.012, 7).is_achieved());
  // Each block is within tolerance of its own place, but not on the one below.
  const StructureComparison shifted = with_middle(0.022, 0);
  for (const auto& [id, error] : shifted.errors) EXPECT_TRUE(error.is_pose_within()) << id;
  EXPECT_FALSE(shifted.is_achieved());
  EXPECT_FALSE(with_middle(0, 14).is_achieved());
}

TEST(StructureComparison, AnObjectTooManyCountsWhereItTouches) {
  std::vector<scene::ObjectSpec> outcome = Moved(Stack().objects, 30, {0.2, 0, 0});
  outcome.push_back(CubeAt("spare", {0.7, 0.5, 0.05}, kRed));
  EXPECT_TRUE(CompareWith(Stack(), EpisodeTo(outcome)).is_achieved());
  outcome[3].whole.X_PE = outcome[2].pose_in_world() * RigidTransform(Vector3(0, 0, 0.1));
  Episode brought = EpisodeTo(outcome);
  EXPECT_TRUE(CompareWith(Stack(), brought).is_achieved()) << "it fell there";
  Carry("spare", brought.begin.objects[3].pose_in_world(), outcome[3].pose_in_world(), &brought);
  const StructureComparison topped = CompareWith(Stack(), brought);
  EXPECT_EQ(topped.intruders, std::vector<std::string>{"spare"});
  EXPECT_EQ(topped.score, 0.75);
  // The same that was there when it was demonstrated does belong.
  Structure with_bystander = Stack();
  with_bystander.bystanders = {CubeAt("other", {0, 0, 0.05}, kRed)};
  EXPECT_TRUE(CompareWith(with_bystander, brought).is_achieved());
}

TEST(StructureComparison, AMirrorImageIsToldFromATurn) {
  // An L that lies on its back; of blocks, which are their own mirror images.
  const scene::Block plank{{0.4, 0.1, 0.1}};
  const Structure letter{
      .objects = {ObjectAt("long", plank, {0, 0, 0.05}), CubeAt("foot", {0.15, 0, 0.15}, kRed)}};
  const auto after = [&](double angle_deg) {
    return CompareWith(letter, EpisodeTo(Moved(letter.objects, angle_deg, {0.1, 0.2, 0})));
  };
  EXPECT_FALSE(after(20).is_mirrored);
  EXPECT_NEAR(*after(20).turn, DegreesToRadians(20.0), 1e-6);
  EXPECT_TRUE(after(180).is_achieved());
  EXPECT_TRUE(after(180).is_mirrored);
  // A tower looks the same from everywhere.
  const StructureComparison tower =
      CompareWith(Stack(), EpisodeTo(Moved(Stack().objects, 170, {0.1, 0.2, 0})));
  EXPECT_TRUE(tower.is_achieved());
  EXPECT_FALSE(tower.is_mirrored);
}

TEST(StructureComparison, ALandmarkDeterminesThePlace) {
  Structure beside{.objects = {CubeAt("post", {0, 0, 0.05}, kBlue), CubeAt("a", {0.2, 0, 0.05})},
                   .order = {"a"},
                   .anchor = Anchor::kLandmark,
                   .landmark = "post"};
  // In the other scene the landmark stands elsewhere, turned.
  const std::vector<scene::ObjectSpec> goal = Moved(beside.objects, 40, {0.3, -0.2, 0});
  std::vector<scene::ObjectSpec> start = goal;
  start[1].whole.X_PE = RigidTransform(Vector3(-0.5, 0.3, 0.05));
  EXPECT_TRUE(CompareWith(beside, EpisodeBetween(start, goal)).is_achieved());
  EXPECT_EQ(CompareWith(beside, EpisodeBetween(start, start)).score, 0.5);
  // To bring the landmark instead is not the task.
  std::vector<scene::ObjectSpec> brought = start;
  brought[0].whole.X_PE = start[1].pose_in_world() * RigidTransform(Vector3(-0.2, 0, 0));
  EXPECT_FALSE(CompareWith(beside, EpisodeBetween(start, brought)).is_achieved());
}

TEST(StructureComparison, ARoundLandmarkHasNoDirection) {
  const auto with_block_at = [](double angle_deg) {
    // A cylinder lies along y: it is put upright.
    scene::ObjectSpec post = ObjectAt("post", scene::Cylinder{0.05, 0.1}, {});
    post.whole.X_PE = RigidTransform(RotationFromFixedAxes({90, 0, 0}), {0, 0, 0.05});
    return std::vector{post, Moved({CubeAt("a", {0.2, 0, 0.05})}, angle_deg, {0, 0, 0}).front()};
  };
  const Structure beside{
      .objects = with_block_at(0), .order = {"a"}, .anchor = Anchor::kLandmark, .landmark = "post"};
  std::vector<scene::ObjectSpec> start = with_block_at(60);
  start[1].whole.X_PE = RigidTransform(Vector3(-0.5, 0.3, 0.05));
  EXPECT_TRUE(CompareWith(beside, EpisodeBetween(start, with_block_at(60))).is_achieved());
  EXPECT_FALSE(CompareWith(beside, EpisodeBetween(start, start)).is_achieved());
}

TEST(Order, ObjectsInPlaceFromTheStartComeFirst) {
  EXPECT_EQ(OrderOf({"a", "b"}, {"b"}, {"a"}).fraction, 1);
  EXPECT_EQ(OrderOf({"a", "b"}, {"a"}, {"b"}).fraction, 0);
  EXPECT_EQ(OrderOf({"a", "b"}, {"b"}, {}).fraction, 0);
  EXPECT_EQ(OrderOf({"a"}, {}, {}).fraction, 1);
}

TEST(MatchObjects, PrefersIdsThenAppearance) {
  const Structure structure{
      .objects = {CubeAt("a", {0, 0, 0}, kRed), CubeAt("b", {0, 0, 0}, kBlue)}};
  const scene::SceneSpec scene{
      .name = "new",
      .objects = {CubeAt("b", {0, 0, 0}, kRed), CubeAt("x", {0, 0, 0}, kBlue),
                  CubeAt("a", {0, 0, 0}, kRed)}};
  const Match match = MatchObjects(structure, scene);
  EXPECT_EQ(match.at("a"), "a");
  EXPECT_EQ(match.at("b"), "x");
  EXPECT_THROW(MatchObjects(structure, {.name = "empty"}), InputError);
}

}  // namespace
}  // namespace smile::task
