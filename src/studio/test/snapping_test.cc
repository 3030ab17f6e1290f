#include "studio/snapping.h"

#include <random>

#include "math/angles.h"
#include "session_fixture.h"

namespace smile::studio {
namespace {

TEST(Snapping, NeverChangesMoreThanItMay) {
  std::mt19937_64 random(3);
  const auto number = [&random](double high) {
    return high * (static_cast<double>(random() >> 11) * 0x1.0p-52 - 1);
  };
  const auto point = [&](double high) { return Vector3(number(high), number(high), number(high)); };
  int num_changed = 0;
  for (int i = 0; i < 2000; ++i) {
    const SnapTo snap{.faces = random() % 2 == 0,
                      .edges = random() % 2 == 0,
                      .grid = random() % 2 == 0,
                      .angles = true};
    const auto bounds = [&] {
      const Vector3 half = point(0.1).cwiseAbs();
      return scene::Bounds{.low = -half, .high = half};
    };
    const Matrix3 R = RotationFromFixedAxes({0, 0, random() % 2 == 0 ? 0 : number(180)});
    const Carried carried{.bounds = bounds(),
                          .X_WB = {R, point(0.3)},
                          .plane_deg = number(180),
                          .is_level = random() % 2 == 0};
    const std::vector<Neighbour> neighbours = {{bounds(), RigidTransform(point(0.3))},
                                               {bounds(), RigidTransform(R, point(0.3))}};
    const Vector3 shift = SnapShift(snap, carried, neighbours, neighbours, 0.1);
    EXPECT_LE(shift.norm(), kSnapUnits * 0.1 + 1e-12);
    // It stays in its plane.
    const double angle = DegreesToRadians(carried.plane_deg);
    EXPECT_NEAR(shift.dot(carried.is_level ? Vector3(0, 0, 1)
                                           : Vector3(-std::sin(angle), std::cos(angle), 0)),
                0, 1e-12);
    if (shift != Vector3::Zero()) ++num_changed;
    const Matrix3 R_wanted = RotationFromFixedAxes(point(180));
    const Matrix3 R_snapped = SnapTurn(snap, R_wanted, std::array{Matrix3(Matrix3::Identity()), R});
    EXPECT_LE(Eigen::AngleAxisd(Matrix3(R_snapped.transpose() * R_wanted)).angle(),
              DegreesToRadians(kSnapDegrees) + 1e-9);
  }
  EXPECT_GT(num_changed, 200);
}

class SnappingTest : public SessionFixture {};

TEST_F(SnappingTest, DragsSnapToWhatIsNear) {
  Begin();
  Do(R"({"do":"snap","to":["faces","edges"]})");
  Command(R"({"do":"grasp","hand":"left","object":"a","point":[0,-2,0.5]})");
  // Through the plane at (3.1, 1.6): nearly flush on top of b.
  Command(R"({"do":"drag","hand":"left","origin":[3.1,-20,1.6],"direction":[0,1,0]})");
  const Json goal = State()["hands"]["left"]["goal"];
  EXPECT_NEAR(goal[0].get<double>(), 3, 1e-4);
  EXPECT_NEAR(goal[2].get<double>(), 1.5, 1e-4);
  Do(R"({"do":"snap","to":[]})");
  Command(R"({"do":"drag","hand":"left","origin":[3.1,-20,1.6],"direction":[0,1,0]})");
  EXPECT_NEAR(State()["hands"]["left"]["goal"][0].get<double>(), 3.1, 1e-4);
}

TEST_F(SnappingTest, LevelDragsSnapToTwoSidesAndKeepTheirHeight) {
  Begin();
  Do(R"({"do":"snap","to":["faces","edges"]})");
  Command(R"({"do":"grasp","hand":"left","object":"a","point":[0,-2,0.5]})");
  // Through the table at (3.1, -3.1): before b, nearly flush with it, nearly touching.
  Command(
      R"({"do":"drag","hand":"left","origin":[3.1,-3.1,9.5],"direction":[0,0,-1],"level":true})");
  const Json goal = State()["hands"]["left"]["goal"];
  EXPECT_NEAR(goal[0].get<double>(), 3, 1e-4);
  EXPECT_NEAR(goal[1].get<double>(), -3, 1e-4);
  EXPECT_EQ(goal[2], 0.5);
}

TEST_F(SnappingTest, HighOverANeighborItsSidesCountButNotItsTop) {
  Begin();
  Do(R"({"do":"snap","to":["faces","edges"]})");
  Command(R"({"do":"grasp","hand":"left","object":"a","point":[0,-2,0.5]})");
  const auto goal_of_drag = [this](const std::string& x, const std::string& z) {
    Command(R"({"do":"drag","hand":"left","origin":[)" + x + ",-20," + z +
            R"(],"direction":[0,1,0]})");
    const Json goal = State()["hands"]["left"]["goal"];
    return std::pair(goal[0].get<double>(), goal[2].get<double>());
  };
  const auto [flush_x, flush_z] = goal_of_drag("3.1", "4.1");
  EXPECT_NEAR(flush_x, 3, 1e-4);
  EXPECT_NEAR(flush_z, 4.1, 1e-4);
  // Let down there, it would touch b's side.
  EXPECT_NEAR(goal_of_drag("1.9", "4.1").first, 2, 1e-4);
}

TEST_F(SnappingTest, BetweenTheWallsOfASlotFacesLeadToItsMiddle) {
  WriteFile(root_ / "scenes/pair.xml",
            R"xml(<tabletop xmlns="http://synapse.cs.umd.edu/tabletop-xml">
  <composite id="Rack" location="(4,-2,0)">
    <block location="(0,0,0.1)" xspan="4" yspan="3" zspan="0.2"/>
    <block location="(-0.6,0,0.6)" xspan="0.1" yspan="3" zspan="0.8"/>
    <block location="(0.6,0,0.6)" xspan="0.1" yspan="3" zspan="0.8"/>
    <block location="(1.8,0,0.6)" xspan="0.1" yspan="3" zspan="0.8"/>
  </composite>
  <block id="a" location="(0,-2,0.5)"/>
</tabletop>)xml");
  Begin();
  Do(R"({"do":"snap","to":["faces"]})");
  Command(R"({"do":"grasp","hand":"left","object":"a","point":[0,-2,0.5]})");
  const auto x_of_drag = [this](const std::string& x) {
    Command(R"({"do":"drag","hand":"left","origin":[)" + x + R"(,-20,2.4],"direction":[0,1,0]})");
    return State()["hands"]["left"]["goal"][0].get<double>();
  };
  EXPECT_NEAR(x_of_drag("4.09"), 4, 1e-4);
  EXPECT_NEAR(x_of_drag("3.88"), 4, 1e-4);
  EXPECT_NEAR(x_of_drag("5.1"), 5.2, 1e-4) << "the next slot";
  EXPECT_NEAR(x_of_drag("4.6"), 4.6, 1e-4) << "on a wall";
}

TEST_F(SnappingTest, AHandThatIsKeptFromItsGoalSaysByWhat) {
  Begin();
  Command(R"({"do":"grasp","hand":"left","object":"a","point":[0,-2,0.5]})");
  Command(R"({"do":"move_to","hand":"left","position":[1.5,-2,0.5]})");
  TickSeconds(1);
  EXPECT_FALSE(State()["hands"]["left"].contains("stopped_by"));
  Command(R"({"do":"move_to","hand":"left","position":[1.5,-2,-1]})");
  TickSeconds(1);
  EXPECT_EQ(State()["hands"]["left"]["stopped_by"], Json::array({""})) << "the table";
}

TEST_F(SnappingTest, WhatIsStoppedBelowALidIsToldToSlideTheLidFirst) {
  WriteFile(root_ / "scenes/pair.xml",
            R"xml(<tabletop xmlns="http://synapse.cs.umd.edu/tabletop-xml">
  <sliderJoint location="(0,0,1)" rotation="(0,0,90)" max="2" init="1">
    <composite id="Case" location="(0,0,0)" rotation="(0,0,-90)" mass="30">
      <block xspan="3" yspan="3" zspan="0.2" location="(0,0,2)"/>
      <block xspan="3" yspan="3" zspan="0.2" location="(0,0,-0.9)"/>
      <block xspan="0.2" yspan="3" zspan="3" location="(-1.4,0,0.5)"/>
    </composite>
    <block id="Drawer" xspan="2" yspan="2" zspan="0.2" location="(0,0,0)"/>
  </sliderJoint>
  <block id="a" location="(0,-0.5,1.6)"/>
</tabletop>)xml");
  Begin();
  TickSeconds(0.5);
  Command(R"({"do":"grasp","hand":"left","object":"a","point":[0,-0.5,1.6]})");
  Command(R"({"do":"move_to","hand":"left","position":[0,-0.5,4]})");
  TickSeconds(1.5);
  Json hand = State()["hands"]["left"];
  EXPECT_EQ(hand["stopped_by"], Json::array({"Case"}));
  EXPECT_EQ(hand["slide_first"], "Drawer");
  // At the end of its rail, the drawer is no advice.
  Command(R"({"do":"release","hand":"left"})");
  TickSeconds(1);
  Command(R"({"do":"grasp","hand":"right","object":"Drawer"})");
  Command(R"({"do":"drag","hand":"right","origin":[9,-9,1],"direction":[-1,0,0]})");
  TickSeconds(2);
  Command(R"({"do":"release","hand":"right"})");
  Command(R"({"do":"grasp","hand":"left","object":"a"})");
  Command(R"({"do":"move_to","hand":"left","position":[0,-0.9,2]})");
  TickSeconds(1);
  Command(R"({"do":"move_to","hand":"left","position":[0,-0.9,4]})");
  TickSeconds(1.5);
  hand = State()["hands"]["left"];
  EXPECT_EQ(hand["stopped_by"], Json::array({"Case"}));
  EXPECT_FALSE(hand.contains("slide_first"));
}

TEST_F(SnappingTest, ALidStaysOnItsRailAndLeavesItsBoxAlone) {
  WriteFile(root_ / "scenes/pair.xml",
            R"xml(<tabletop xmlns="http://synapse.cs.umd.edu/tabletop-xml">
  <sliderJoint location="(0,0,1)" rotation="(0,0,90)" max="2">
    <box id="Chest" xspan="3" yspan="2" zspan="1" location="(0,0,-0.5)"/>
    <block id="Lid" xspan="3" yspan="2" zspan="0.2" location="(0,0,0.1)"/>
  </sliderJoint>
</tabletop>)xml");
  Begin();
  const Vector3 chest = PositionOf("Chest"), lid = PositionOf("Lid");
  EXPECT_EQ(State()["snap"], Json({"rails", "faces", "edges"})) << "from the start";
  Command(R"({"do":"grasp","hand":"left","object":"Lid","point":[0,0,1.2]})");
  EXPECT_EQ(State()["hands"]["left"]["on_rail"], true);
  // The rail is along y, across the hand's plane; the ray passes 1 unit from the start of the way.
  Command(R"({"do":"drag","hand":"left","origin":[9,-1,3],"direction":[-1,0,0]})");
  EXPECT_NEAR(State()["hands"]["left"]["goal"][0].get<double>(), 0, 1e-3);
  EXPECT_NEAR(State()["hands"]["left"]["goal"][1].get<double>(), -1, 1e-3);
  EXPECT_NEAR(State()["hands"]["left"]["goal"][2].get<double>(), 1.2, 1e-3);
  // Far beyond the end, and up into the sky: the rail ends at 2.
  Command(R"({"do":"drag","hand":"left","origin":[9,-8,3],"direction":[-1,0,1]})");
  TickSeconds(2);
  EXPECT_NEAR(PositionOf("Lid").y(), lid.y() - 2, 0.01);
  EXPECT_LT((PositionOf("Chest") - chest).norm(), 1e-3);
  // Along the rail, a ray tells nothing.
  Command(R"({"do":"drag","hand":"left","origin":[1,9,3],"direction":[0,-1,0]})");
  EXPECT_NEAR(State()["hands"]["left"]["goal"][1].get<double>(), -2, 1e-3);
  // Without rails, the hand goes where the plane is met.
  Do(R"({"do":"snap","to":[]})");
  Command(R"({"do":"drag","hand":"left","origin":[9,-20,3],"direction":[0,1,0]})");
  EXPECT_NEAR(State()["hands"]["left"]["goal"][0].get<double>(), 9, 1e-3);
}

TEST_F(SnappingTest, TurnsStickToARightAngleUntilTheyLeadAway) {
  Begin();
  Do(R"({"do":"snap","to":["angles"]})");
  Command(R"({"do":"grasp","hand":"left","object":"a"})");
  const auto yaw_after = [this](const std::string& degrees, const std::string& more = "") {
    Do(R"({"do":"command","command":{"do":"rotate","hand":"left","angles":[0,0,)" + degrees + "]}" +
       more + "}");
    return State()["hands"]["left"]["angles"][2].get<double>();
  };
  EXPECT_NEAR(yaw_after("80"), 80, 0.01);
  EXPECT_NEAR(yaw_after("6"), 90, 0.01) << "86 was wanted";
  EXPECT_NEAR(yaw_after("6"), 90, 0.01) << "92 was wanted";
  EXPECT_NEAR(yaw_after("6"), 98, 0.01);
  EXPECT_NEAR(yaw_after("-7"), 90, 0.01) << "91 was wanted";
  EXPECT_NEAR(yaw_after("1", R"(,"exact":true)"), 91, 0.01);
}

TEST_F(SnappingTest, TurnsSnapToWhatIsNear) {
  Begin();
  Command(R"({"do":"grasp","hand":"right","object":"b"})");
  Command(R"({"do":"rotate","hand":"right","angles":[0,0,20]})");
  TickSeconds(0.5);
  Command(R"({"do":"release","hand":"right"})");
  Do(R"({"do":"snap","to":["angles"]})");
  Command(R"({"do":"grasp","hand":"left","object":"a","point":[0,-2,0.5]})");
  const auto yaw = [this] { return State()["hands"]["left"]["angles"][2].get<double>(); };
  Command(R"({"do":"rotate","hand":"left","angles":[0,0,18]})");
  EXPECT_NEAR(yaw(), 18, 0.01) << "b is far";
  Command(R"({"do":"move_to","hand":"left","position":[1.7,-2,0.6]})");
  TickSeconds(0.5);
  Command(R"({"do":"rotate","hand":"left","angles":[0,0,-1]})");
  EXPECT_NEAR(yaw(), 20, 0.5) << "b is near, and turned by about 20 degrees";
}

}  // namespace
}  // namespace smile::studio
