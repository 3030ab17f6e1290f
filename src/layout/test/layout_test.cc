#include "layout/layout.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include "base/files.h"
#include "math/angles.h"
#include "motion/inverse_kinematics.h"
#include "robot/urdf_reader.h"
#include "scene/bounds.h"
#include "scene_xml/scene_reader.h"
#include "scene_xml/scene_writer.h"
#include "sim/eye.h"
#include "sim/simulation.h"

namespace smile::layout {
namespace {

constexpr int kNumLevels = static_cast<int>(kLayoutLevelWords.size());

scene::SceneSpec Shipped(const std::string& name) {
  return scene_xml::LoadScene(DataFile("scenes/" + name + ".xml"));
}

Footprint FootprintNow(const scene::ObjectSpec& object) {
  return FootprintOf(object, object.pose_in_world());
}

scene::Bounds BoundsNow(const scene::ObjectSpec& object) {
  return scene::BoundsOf(scene::SolidsOf(object.whole), object.pose_in_world());
}

bool StandsOnTable(const scene::ObjectSpec& object) {
  return std::abs(BoundsNow(object).low.z()) < 1e-6;
}

/// Returns the least distance between two objects on the table [m].
double LeastGap(const scene::SceneSpec& scene) {
  double least = 1;
  for (const scene::ObjectSpec& a : scene.objects) {
    for (const scene::ObjectSpec& b : scene.objects) {
      if (&a == &b || !StandsOnTable(a) || !StandsOnTable(b)) continue;
      least = std::min(least, GapBetween(FootprintNow(a), FootprintNow(b)));
    }
  }
  return least;
}

bool IsInStrip(const scene::SceneSpec& scene, const scene::ObjectSpec& object) {
  return GapBetween(FootprintNow(object), LayoutRegion().StripOn(scene.table)) == 0;
}

int NumStacked(const scene::SceneSpec& scene) {
  return static_cast<int>(std::ranges::count_if(
      scene.objects, [](const auto& object) { return !StandsOnTable(object); }));
}

/// Returns the number of pairs on the table that are closer than the thickness of a sheet of paper.
int NumContacts(const scene::SceneSpec& scene) {
  int count = 0;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const auto &a = scene.objects[i], &b = scene.objects[j];
      if (!StandsOnTable(a) || !StandsOnTable(b)) continue;
      count += GapBetween(FootprintNow(a), FootprintNow(b)) < 0.0005;
    }
  }
  return count;
}

TEST(Footprint, GapIsTheDistanceOfTheNearestPoints) {
  const Footprint square{.half_size = {0.05, 0.05}};
  Footprint other = square;
  other.center = {0.15, 0};
  EXPECT_NEAR(GapBetween(square, other), 0.05, 1e-12);
  other.yaw_deg = 45;  // a corner towards it
  EXPECT_NEAR(GapBetween(square, other), 0.15 - 0.05 - 0.05 * std::sqrt(2), 1e-12);
  other.center = {0.13, 0.13};  // side against corner
  EXPECT_NEAR(GapBetween(square, other), 0.13 * std::sqrt(2) - 0.05 - 0.05 * std::sqrt(2), 1e-12);
  other.center = {0.08, 0.08};
  EXPECT_EQ(GapBetween(square, other), 0);
  // A cross: no corner lies within the other.
  EXPECT_EQ(GapBetween({.half_size = {0.2, 0.01}}, {.yaw_deg = 90, .half_size = {0.2, 0.01}}), 0);
}

TEST(LayoutLevel, WordsAreReadBack) {
  EXPECT_EQ(ParseLayoutLevel("scattered"), LayoutLevel::kScattered);
  EXPECT_EQ(ParseLayoutLevel("mixed"), LayoutLevel::kMixed);
  EXPECT_EQ(ParseLayoutLevel("Mixed"), std::nullopt);
}

TEST(RandomLayout, IsTheSameForTheSameSeedAndLevel) {
  const scene::SceneSpec scene = Shipped("um_robot");
  for (int level = 0; level < kNumLevels; ++level) {
    const scene::SceneSpec layout = RandomLayout(scene, 4, LayoutLevel(level));
    EXPECT_EQ(layout, RandomLayout(scene, 4, LayoutLevel(level)));
    EXPECT_FALSE(layout == RandomLayout(scene, 5, LayoutLevel(level)));
    EXPECT_EQ(RandomLayout(layout, 4, LayoutLevel::kScattered).table, scene.table);
  }
}

TEST(RandomLayout, RemovingASmallObjectKeepsTheOthers) {
  scene::SceneSpec scene = Shipped("tower_robot");
  const scene::SceneSpec all = RandomLayout(scene, 7);
  scene.objects.pop_back();
  const scene::SceneSpec fewer = RandomLayout(scene, 7);
  for (std::size_t i = 0; i < fewer.objects.size(); ++i) {
    EXPECT_EQ(fewer.objects[i], all.objects[i]);
  }
  const scene::SceneSpec more = RandomLayout(Shipped("tower_robot"), 7, LayoutLevel::kDistractors);
  for (std::size_t i = 0; i < all.objects.size(); ++i) EXPECT_EQ(more.objects[i], all.objects[i]);
}

class LayoutProperty : public ::testing::TestWithParam<int> {
 protected:
  LayoutLevel level() const { return static_cast<LayoutLevel>(GetParam()); }
};

TEST_P(LayoutProperty, EverythingIsReachedSeenAndApart) {
  const scene::SceneSpec scene = Shipped("um_robot");
  const sim::Simulation empty(scene::SceneSpec{.name = "eye"});
  const CameraView eye = sim::EyeView(empty, {});
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    const scene::SceneSpec layout = RandomLayout(scene, seed, level());
    const bool has_contacts = level() == LayoutLevel::kTouching || level() == LayoutLevel::kMixed;
    EXPECT_GE(LeastGap(layout), has_contacts ? 0.0001 : kFingerGap - 1e-9) << seed;
    for (const scene::ObjectSpec& object : layout.objects) {
      if (level() == LayoutLevel::kScattered) {
        EXPECT_FALSE(IsInStrip(layout, object)) << object.id();
      }
      const scene::Bounds bounds = BoundsNow(object);
      for (const Vector2& corner : FootprintNow(object).corners()) {
        for (double z : {bounds.low.z(), bounds.high.z()}) {
          const Eigen::Vector2d pixel = ProjectToPixel(
              eye.intrinsics, eye.X_WC.inverse() * Vector3(corner.x(), corner.y(), z));
          EXPECT_TRUE(pixel.x() > 0 && pixel.x() < 640 && pixel.y() > 0 && pixel.y() < 480)
              << object.id() << " at " << pixel.transpose() << ", seed " << seed;
        }
        EXPECT_LT(std::abs(corner.y()), scene.table.y_span / 2);
      }
    }
  }
}

TEST_P(LayoutProperty, EachBlockOfAGroupIsInReach) {
  constexpr double kTolerance = 1e-6;  // [m]
  const scene::SceneSpec scene = Shipped("um_robot");
  const LayoutRegion region;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const scene::SceneSpec layout = RandomLayout(scene, seed, level());
    for (const scene::ObjectSpec& object : layout.objects) {
      const Vector2 center = FootprintNow(object).center;
      const double from_shoulder =
          std::hypot(std::abs(center.x()) - region.shoulder_x,
                     center.y() + layout.table.y_span / 2 - region.shoulder_depth);
      EXPECT_LE(from_shoulder, region.reach + kTolerance) << object.id() << ", seed " << seed;
    }
  }
}

TEST_P(LayoutProperty, ObjectsStayAtRest) {
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    const scene::SceneSpec layout = RandomLayout(Shipped("um_robot"), seed, level());
    sim::Simulation simulation(layout);
    for (int i = 0; i < sim::kTicksPerSecond; ++i) simulation.Tick();
    for (const scene::ObjectSpec& object : layout.objects) {
      const RigidTransform X_WB =
          simulation.physics().body(simulation.tabletop().Find(object.id())->body).pose_in_world();
      EXPECT_LT((X_WB.translation() - object.pose_in_world().translation()).norm(), 0.002)
          << object.id() << ", seed " << seed;
    }
  }
}

TEST_P(LayoutProperty, FilesGiveItBack) {
  const scene::SceneSpec layout = RandomLayout(Shipped("um_robot"), 11, level());
  const auto reading =
      scene_xml::ReadSceneText(scene_xml::WriteScene(layout), layout.name + ".xml");
  ASSERT_TRUE(reading.scene);
  EXPECT_EQ(*reading.scene, layout);
}

INSTANTIATE_TEST_SUITE_P(Levels, LayoutProperty, ::testing::Range(0, kNumLevels),
                         [](const auto& parameter) {
                           return std::string(kLayoutLevelWords[parameter.param]);
                         });

/// Returns true if an arm can take an object there vertically, at a tool height of z.
bool IsReached(const motion::ArmKinematics& arm, const std::vector<double>& start,
               const Footprint& place, double z) {
  for (double turn_deg : {0.0, 180.0}) {
    const RigidTransform X_WG(RotationFromFixedAxes({180, 0, place.yaw_deg + turn_deg}),
                              Vector3(place.center.x(), place.center.y(), z));
    if (motion::SolveInverseKinematics(arm, X_WG, start, {.max_iterations = 400})) return true;
  }
  return false;
}

TEST(RandomLayout, AnArmReachesEverythingFromAbove) {
  const robot::RobotModel model = robot::ReadRobot(DataFile("robots/baxter.urdf"));
  const sim::RobotPlacement usual;
  const scene::SceneSpec scene = Shipped("um_robot");
  const RigidTransform X_WBase = model::RobotBasePose(scene.table, usual.gap, usual.height);
  const motion::ArmKinematics left(model, *robot::FindArm(model, "left"), X_WBase);
  const motion::ArmKinematics right(model, *robot::FindArm(model, "right"), X_WBase);
  // The pose `untucked`: hands over the table, fingers down.
  const std::vector<double> left_start{-0.08, -1.0, -1.19, 1.94, 0.67, 1.03, -0.5};
  const std::vector<double> right_start{0.08, -1.0, 1.19, 1.94, -0.67, 1.03, 0.5};
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    for (const auto& object : RandomLayout(scene, seed, LayoutLevel::kEdges).objects) {
      for (double z : {0.08, 0.25}) {
        const Footprint place = FootprintNow(object);
        EXPECT_TRUE(IsReached(left, left_start, place, z) ||
                    IsReached(right, right_start, place, z))
            << object.id() << " at " << place.center.transpose() << ", seed " << seed;
      }
    }
  }
}

TEST(RandomLayout, LevelsMatchTheirNames) {
  const scene::SceneSpec scene = Shipped("um_robot");
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const scene::SceneSpec touching = RandomLayout(scene, seed, LayoutLevel::kTouching);
    EXPECT_GE(NumContacts(touching), 3);
    EXPECT_EQ(NumStacked(touching), 0);
    EXPECT_EQ(NumStacked(RandomLayout(scene, seed, LayoutLevel::kStacked)), 3);

    const scene::SceneSpec more = RandomLayout(scene, seed, LayoutLevel::kDistractors);
    ASSERT_EQ(more.objects.size(), scene.objects.size() + 3);
    for (std::size_t i = scene.objects.size(); i < more.objects.size(); ++i) {
      const scene::Part& extra = more.objects[i].whole;
      EXPECT_TRUE(std::ranges::none_of(scene.objects, [&](const auto& object) {
        return object.whole.color == extra.color && object.whole.shape == extra.shape;
      }));
    }

    const scene::SceneSpec mixed = RandomLayout(scene, seed, LayoutLevel::kMixed);
    EXPECT_GE(NumContacts(mixed), 1);
    EXPECT_GE(NumStacked(mixed), 1);
    EXPECT_EQ(mixed.objects.size(), scene.objects.size() + 3);
  }
}

/// Returns the ids of the objects that a layout moves.
std::set<std::string> MovedIn(const std::string& name) {
  const scene::SceneSpec scene = Shipped(name), layout = RandomLayout(scene, 3);
  std::set<std::string> moved;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    if (layout.objects[i] != scene.objects[i]) moved.insert(scene.objects[i].id());
  }
  return moved;
}

TEST(RandomLayout, FollowsTheNearEdgeOfTheTable) {
  scene::SceneSpec scene = Shipped("um_robot");
  const scene::SceneSpec usual = RandomLayout(scene, 2);
  scene.table.y_span += 0.4;
  const scene::SceneSpec deeper = RandomLayout(scene, 2);
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const Vector3 shift = deeper.objects[i].pose_in_world().translation() -
                          usual.objects[i].pose_in_world().translation();
    EXPECT_LT((shift - Vector3(0, -0.2, 0)).norm(), 1e-6) << scene.objects[i].id();
  }
}

TEST(RandomLayout, OurRobotScenesAreWithinTheRegion) {
  for (const char* name : {"tower", "row", "bridge", "box", "hatch", "drive", "scissors"}) {
    const scene::SceneSpec scene = Shipped(std::string(name) + "_robot");
    for (const scene::ObjectSpec& object : scene.objects) {
      EXPECT_TRUE(
          LayoutRegion().Holds(scene.table, FootprintNow(object), BoundsNow(object).high.z()))
          << name << ": " << object.id();
    }
  }
}

TEST(RandomLayout, FindsRoomBesideWhatStandsFast) {
  for (const char* name : {"box_robot", "drive_robot"}) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      EXPECT_GE(LeastGap(RandomLayout(Shipped(name), seed, LayoutLevel::kMixed)), 0.0001) << name;
    }
  }
}

TEST(RandomLayout, MovesOnlyWhatStandsLooseOnTheTable) {
  EXPECT_EQ(MovedIn("containers"), (std::set<std::string>{"Can4", "Stray"}))
      << "not what is in one";
  EXPECT_EQ(MovedIn("lidbox"), std::set<std::string>{"Lemon"}) << "not what slides";
  EXPECT_EQ(MovedIn("screws"), (std::set<std::string>{"Plate", "SteelScrew"}))
      << "not what is bound";
  EXPECT_THROW(MovedIn("dial"), std::invalid_argument) << "no controls";
}

bool AreEqual(const RigidTransform& a, const RigidTransform& b) {
  const RigidTransform X_ab = a.inverse() * b;
  return X_ab.translation().norm() < 1e-6 && (X_ab.rotation() - Matrix3::Identity()).norm() < 1e-6;
}

TEST(RandomLayout, FixturesMoveWithEverythingOnThem) {
  const scene::SceneSpec scene = Shipped("drive_robot");
  const auto pose = [](const scene::SceneSpec& of, std::size_t i) {
    return of.objects[i].pose_in_world();
  };
  // Rack, two drives in it, spare, bin.
  ASSERT_EQ(scene.objects.size(), 5u);
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const scene::SceneSpec layout = RandomLayout(scene, seed, LayoutLevel::kFixtures);
    const RigidTransform X_moved = pose(layout, 0) * pose(scene, 0).inverse();
    EXPECT_FALSE(AreEqual(X_moved, RigidTransform())) << seed;
    for (std::size_t drive : {1u, 2u}) {
      EXPECT_TRUE(AreEqual(pose(layout, drive), X_moved * pose(scene, drive))) << seed;
    }
    EXPECT_FALSE(AreEqual(pose(layout, 4), X_moved * pose(scene, 4))) << "the bin";
    for (std::size_t fixture : {0u, 4u}) {
      const scene::ObjectSpec& object = layout.objects[fixture];
      EXPECT_TRUE(
          LayoutRegion().Holds(scene.table, FootprintNow(object), BoundsNow(object).high.z()));
      const Vector3 offset =
          pose(layout, fixture).translation() - pose(scene, fixture).translation();
      EXPECT_LE(offset.cwiseAbs().maxCoeff(), 0.05 + 1e-9);
      EXPECT_GE(GapBetween(FootprintNow(object), FootprintNow(layout.objects[3])),
                kFingerGap - 1e-9)
          << "the spare, seed " << seed;
    }
  }
}

TEST(RandomLayout, PilesArePlacedAnywhereAsAWhole) {
  for (const char* name : {"unstack_robot", "lid_robot"}) {
    const scene::SceneSpec scene = Shipped(name);
    double most_x = -1, least_x = 1;
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
      const scene::SceneSpec layout = RandomLayout(scene, seed, LayoutLevel::kPiles);
      const RigidTransform X_WFirst = layout.objects[0].pose_in_world();
      const RigidTransform X_moved = X_WFirst * scene.objects[0].pose_in_world().inverse();
      // The tower, and the pot with its lid; the block of the latter is loose.
      for (std::size_t i = 1; i < (name == std::string("lid_robot") ? 2u : 3u); ++i) {
        EXPECT_TRUE(
            AreEqual(layout.objects[i].pose_in_world(), X_moved * scene.objects[i].pose_in_world()))
            << name << ", seed " << seed;
      }
      for (const scene::ObjectSpec& object : layout.objects) {
        EXPECT_TRUE(
            LayoutRegion().Holds(scene.table, FootprintNow(object), BoundsNow(object).high.z()))
            << name << ", seed " << seed << ", " << object.id();
      }
      most_x = std::max(most_x, X_WFirst.translation().x());
      least_x = std::min(least_x, X_WFirst.translation().x());
    }
    EXPECT_GT(most_x - least_x, 0.6) << name;
  }
  // Discs on a fixed plate are no pile.
  EXPECT_THROW(RandomLayout(Shipped("hanoi_robot"), 1, LayoutLevel::kPiles), std::invalid_argument);
}

TEST(RandomLayout, ChainsAndSlidersMoveAsAWhole) {
  for (const char* name : {"strings", "lidbox", "hatch_robot", "screws"}) {
    const scene::SceneSpec scene = Shipped(name);
    const scene::SceneSpec layout = RandomLayout(scene, 1, LayoutLevel::kFixtures);
    EXPECT_FALSE(layout == scene) << name;
    const auto reading =
        scene_xml::ReadSceneText(scene_xml::WriteScene(layout), layout.name + ".xml");
    ASSERT_TRUE(reading.scene) << name;
    EXPECT_EQ(*reading.scene, layout) << name;
    for (const scene::ChainSpec& chain : layout.chains) {
      EXPECT_LT((chain.p_WStart - layout.objects[chain.first_object].pose_in_world().translation())
                    .norm(),
                1e-9);
    }
  }
}

TEST(RandomLayout, ReportsFailure) {
  EXPECT_THROW(RandomLayout({.name = "bare"}, 1, LayoutLevel::kFixtures), std::invalid_argument);
  EXPECT_THROW(RandomLayout({.name = "bare"}, 1), std::invalid_argument);
  try {
    RandomLayout(Shipped("um_robot"), 1, LayoutLevel::kScattered, {.most_depth = 0.15});
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("there is no room for '"), std::string::npos)
        << error.what();
  }
}

TEST(ReachMap, ContainsWhatIsReachedUpToAMargin) {
  ReachMap map{.cell = 0.1, .most_x = 0.3, .most_depth = 0.3};
  ASSERT_EQ(map.num_columns(), 6);
  map.is_reached.assign(18, true);
  map.is_reached[5] = false;  // x from 0.2 to 0.3, depth from 0 to 0.1
  EXPECT_TRUE(map.Contains({0.15, 0.05}));
  EXPECT_FALSE(map.Contains({0.25, 0.05}));
  EXPECT_FALSE(map.Contains({0.15, 0.05}, 0.06)) << "the margin";
  EXPECT_FALSE(map.Contains({0, -0.01}));
  EXPECT_FALSE(map.Contains({-0.31, 0.1}));
}

TEST(Layout, KeepsToThePlacesOfAReachMap) {
  const scene::SceneSpec scene = Shipped("box");
  auto map = std::make_shared<ReachMap>();
  const auto is_near = [](const Vector2& p) { return (p - Vector2(0.2, 0.3)).norm() < 0.4; };
  for (int row = 0; row < map->num_rows(); ++row) {
    for (int column = 0; column < map->num_columns(); ++column) {
      map->is_reached.push_back(is_near(map->MiddleOf(column, row)));
    }
  }
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const scene::SceneSpec laid_out =
        RandomLayout(scene, seed, LayoutLevel::kScattered, {.reach_map = map});
    EXPECT_EQ(laid_out, RandomLayout(scene, seed, LayoutLevel::kScattered, {.reach_map = map}));
    for (const scene::ObjectSpec& object : laid_out.objects) {
      if (object.is_static() || !StandsOnTable(object)) continue;
      const Vector2 center = FootprintNow(object).center;
      EXPECT_TRUE(map->Contains({center.x(), center.y() + scene.table.y_span / 2}))
          << seed << " " << object.id();
    }
  }
}

}  // namespace
}  // namespace smile::layout
