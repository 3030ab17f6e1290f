#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "robot/kinematics.h"
#include "robot/test/robot_files.h"

namespace smile::robot {
namespace {

/// An arm with two jaws of 0.1 m that turn about x; the right one mimics the left one.
class Jaws : public RobotFiles {
 protected:
  static std::string Urdf(
      const std::string& mimic = R"(<mimic joint="l" multiplier="-1" offset="0.1"/>)") {
    std::string jaws;
    for (const std::string name : {"l", "r"}) {
      const bool is_left = name == "l";
      jaws += "<link name=\"" + name + "\">" + SmallRobot().inertial + "</link><joint name=\"" +
              name + "\" type=\"revolute\"><parent link=\"arm\"/><child link=\"" + name +
              "\"/><origin xyz=\"0 " + (is_left ? "0.03" : "-0.03") + " 0\" rpy=\"" +
              (is_left ? "0" : "0.1") + " 0 0\"/><axis xyz=\"-1 0 0\"/><limit velocity=\"" +
              (is_left ? "2" : "1") + "\" effort=\"20\" lower=\"-2\" upper=\"2\"/>" +
              (is_left ? "" : mimic) + "</joint>";
    }
    return SmallRobot{.extra = jaws}.Text();
  }
  static std::string SideFile(const std::string& arm, const std::string& more = "") {
    return R"({"format": 2, "frames": {"pl": {"on": "l", "xyz": [0, 0, 0.1]},
"pr": {"on": "r", "xyz": [0, 0, 0.1]}},
"arms": {"a": {"joints": ["turn"], "tool": "arm", )" +
           arm + "}}" + more + "}";
  }
  static constexpr const char* kJaws =
      R"("jaws": {"drive": "l", "left": "l", "right": "r"}, "pads": ["pl", "pr"])";
};

TEST_F(Jaws, OpenAsTheirPadsMove) {
  const RobotModel model = Read(Urdf(), SideFile(kJaws));
  const Gripper& gripper = model.arms[0].gripper.value();
  EXPECT_EQ(gripper.kind, GripperKind::kJaws);
  const int left = *FindJoint(model, "l"), right = *FindJoint(model, "r");
  EXPECT_EQ(JointsOf(model, gripper), (std::vector<int>{left, right}));
  // Closed where the pads meet, open where they are farthest apart: at a right angle.
  const OpeningRange range = OpeningRangeOf(model, gripper);
  EXPECT_NEAR(range.closed, 0, 0.01);
  EXPECT_NEAR(range.open, 0.06 + 2 * 0.1, 0.001);
  EXPECT_NEAR(model.links[left].upper, std::numbers::pi / 2, 0.05);
  for (double opening = range.closed; opening < range.open; opening += 0.01) {
    std::vector<double> q = model.q_start;
    SetOpening(model, gripper, opening, q);
    EXPECT_NEAR(OpeningOf(model, gripper, q), opening, 1e-12);
    const double y_left = FramePose(model, {}, q, *FindFrame(model, "pl")).translation().y();
    const double y_right = FramePose(model, {}, q, *FindFrame(model, "pr")).translation().y();
    // The arm is not turned, so the tool's y is that of the base.
    EXPECT_NEAR(y_left - y_right, opening, 2e-4);
    EXPECT_NEAR(MiddleAt(model, gripper, opening), (y_left + y_right) / 2, 2e-4);
    q[left] += 1e-6;
    EXPECT_NEAR(OpeningOf(model, gripper, q), opening + 1e-6 / DriveRateAt(model, gripper, q),
                1e-9);
  }
}

TEST_F(Jaws, HaveTheSpeedAndRangeThatTheirFollowersAllow) {
  const RobotModel model =
      Read(Urdf(R"(<mimic joint="l" multiplier="-2" offset="0.1"/>)"), SideFile(R"("payload": 1)"));
  const scene::LinkSpec& drive = model.links[*FindJoint(model, "l")];
  EXPECT_EQ(drive.max_velocity, 0.5);
  EXPECT_NEAR(drive.lower, -0.95, 1e-12);
  EXPECT_NEAR(drive.upper, 1.05, 1e-12);
}

TEST_F(Jaws, OfWhichOneIsFixedToThePalm) {
  const RobotModel model =
      Read(Urdf(), SideFile(R"("jaws": {"drive": "l", "left": "l", "right": "arm"},
"pads": ["pl", "arm"])"));
  const Gripper& gripper = model.arms[0].gripper.value();
  EXPECT_EQ(gripper.right_finger, *FindJoint(model, "turn"));
  EXPECT_NEAR(OpeningRangeOf(model, gripper).open, 0.03 + 0.1, 0.001);
  // The fixed one stays at 0, so the middle moves with the other one.
  for (const double opening : {0.04, 0.08, 0.12}) {
    EXPECT_NEAR(MiddleAt(model, gripper, opening), opening / 2, 1e-9);
  }
}

TEST_F(Jaws, OpenInPoses) {
  const RobotModel model = Read(
      Urdf(), SideFile(kJaws, R"(, "poses": {"p": {"opening": 0.1}, "o": {"opening": "open"}})"));
  const Gripper& gripper = model.arms[0].gripper.value();
  EXPECT_NEAR(OpeningOf(model, gripper, model.poses[0].q), 0.1, 1e-12);
  const std::vector<double>& open = model.poses[1].q;
  EXPECT_EQ(OpeningOf(model, gripper, open), OpeningRangeOf(model, gripper).open);
  EXPECT_EQ(open[*FindJoint(model, "r")], 0.1 - open[*FindJoint(model, "l")]);
}

TEST_F(Jaws, MayBeASuctionCup) {
  const RobotModel model = Read(Urdf(), SideFile(R"("suction": {"radius": 0.03, "capacity": 2})"));
  EXPECT_EQ(model.arms[0].gripper,
            (Gripper{.kind = GripperKind::kSuction, .cup_radius = 0.03, .cup_capacity = 2}));
}

TEST_F(Jaws, AreRefusedIfTheyDoNotOpen) {
  const std::string urdf = Urdf();
  const std::string at = "r.robot.json: <arms/a";
  EXPECT_EQ(Complaint(urdf, SideFile(R"("jaws": {"drive": "l", "left": "l", "right": "r"},
"pads": ["arm", "arm"])")),
            at + "/pads>: open from 0 to 0 m along y of the tool, expected from 0 or more by at "
                 "least 0.001 m, with the left one at +y");
  EXPECT_EQ(Complaint(urdf, SideFile(R"("jaws": {"drive": "r", "left": "l", "right": "r"},
"pads": ["pl", "pr"])")),
            at + "/jaws/drive>: joint \"r\" mimics \"l\", expected a joint that follows no other");
  EXPECT_EQ(Complaint(urdf, SideFile(R"("jaws": {"drive": "l", "left": "l", "right": "l"},
"pads": ["pl", "pr"])")),
            at + "/jaws>: left and right are the same rigid body, expected two");
  EXPECT_EQ(Complaint(urdf, SideFile(R"("jaws": {"drive": "l", "left": "l", "right": "r"})")),
            at + ">: has no member \"pads\"");
  EXPECT_EQ(Complaint(urdf, SideFile(R"("jaws": {"drive": "l", "left": "l", "right": "x"},
"pads": ["pl", "pr"])")),
            at + "/jaws/right>: found \"x\", expected the name of a link");
  EXPECT_EQ(Complaint(urdf, SideFile(R"("suction": {"radius": 0.03, "capacity": 2}, )" +
                                     std::string(kJaws))),
            at + ">: has several kinds of gripper, expected fingers, jaws or suction");
  EXPECT_EQ(Complaint(urdf, SideFile(R"("suction": {"radius": 2, "capacity": 2})")),
            at + "/suction/radius>: found 2, expected 0.001 to 1");
}

TEST_F(Jaws, AreRefusedIfTheirMimicsMakeNoSense) {
  const auto complaint = [&](const std::string& mimic) {
    return Complaint(Urdf(mimic), SideFile(R"("payload": 1)"));
  };
  EXPECT_EQ(complaint(R"(<mimic joint="r"/>)"),
            "r.robot.json: joint \"r\" mimics \"r\", which follows itself, expected no loop");
  EXPECT_EQ(complaint(R"(<mimic joint="x"/>)"),
            "r.robot.json: joint \"r\" mimics \"x\", expected a joint that moves");
  EXPECT_EQ(complaint(R"(<mimic joint="l" offset="9"/>)"),
            "r.robot.json: joint \"r\" mimics \"l\", and its limits allow that one only -11 to -7, "
            "expected a part of the range -2 to 2");
  EXPECT_EQ(complaint(R"(<mimic joint="l" multiplier="0"/>)"),
            "r.robot.json: joint \"r\" mimics \"l\" with the multiplier 0 and the offset 0, "
            "expected finite ones, the multiplier not 0");
  EXPECT_EQ(complaint(R"(<mimic joint="turn"/>)"),
            "r.robot.json: joint \"r\" mimics \"turn\", which belongs to an arm or is a finger, "
            "expected mimics of jaws and heads only");
}

TEST_F(Jaws, ArePartOfARobotWithAHeadOfAnyNumberOfJoints) {
  const std::string arm = R"("payload": 1)";
  const RobotModel none =
      Read(Urdf(), SideFile(arm, R"(, "head": {"joints": [], "camera": "base"})"));
  EXPECT_TRUE(none.head->joints.empty());
  const RobotModel one = Read(Urdf(), SideFile(arm, R"(, "head": {"joints": ["l"], "camera": "l"},
"poses": {"p": {"head": [0.5]}})"));
  EXPECT_EQ(one.head->joints, std::vector<int>{*FindJoint(one, "l")});
  EXPECT_EQ(one.poses[0].q[*FindJoint(one, "l")], 0.5);
  EXPECT_EQ(one.poses[0].q[*FindJoint(one, "r")], 0.1 - 0.5);
  EXPECT_EQ(Complaint(Urdf(), SideFile(arm, R"(, "head": {"joints": ["l"], "camera": "l"},
"poses": {"p": {"head": [0.5, 1]}})")),
            "r.robot.json: <poses/p/head>: length is 2, expected 1");
}

}  // namespace
}  // namespace smile::robot
