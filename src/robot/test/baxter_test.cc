#include "robot/test/baxter.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <map>
#include <set>

#include "math/angles.h"
#include "robot/test/solid_overlap.h"

namespace smile::robot {
namespace {

/// Place of the robot in the 2015 program: behind the near edge of a table 1.2 m deep, facing away
/// from the viewer.
RigidTransform ClassicBasePose() {
  return {RotationFromFixedAxes({0, 0, 90}), Vector3(0, -0.9, 0.2)};
}

RigidTransform AtStart(const char* frame) {
  return FramePose(Baxter(), ClassicBasePose(), Baxter().q_start,
                   FindFrame(Baxter(), frame).value());
}

TEST(Baxter, HasTwoArmsOfSevenJointsInTheirUsualOrder) {
  const RobotModel& model = Baxter();
  EXPECT_EQ(model.name, "baxter");
  EXPECT_EQ(model.num_joints(), 19);
  ASSERT_EQ(model.arms.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    const std::string side = i == 0 ? "left" : "right";
    EXPECT_EQ(model.arms[i].name, side);
    std::vector<std::string> names;
    for (int joint : model.arms[i].joints) names.push_back(model.links[joint].joint_name);
    const std::vector<std::string> expected{side + "_s0", side + "_s1", side + "_e0", side + "_e1",
                                            side + "_w0", side + "_w1", side + "_w2"};
    EXPECT_EQ(names, expected);
    EXPECT_EQ(model.frames[model.arms[i].tool].name, side + "_gripper");
  }
  EXPECT_EQ(model.links[model.head->joints.front()].joint_name, "head_pan");
  EXPECT_EQ(model.frames[model.head->camera].name, "eye");
}

TEST(Baxter, HasTheLimitsOfTheRealRobot) {
  struct Limit {
    double lower, upper, velocity, effort;
  };
  const std::vector<Limit> limits{{-1.70167993878, 1.70167993878, 1.5, 50},
                                  {-2.147, 1.047, 1.5, 50},
                                  {-3.05417993878, 3.05417993878, 1.5, 50},
                                  {-0.05, 2.618, 1.5, 50},
                                  {-3.059, 3.059, 4, 15},
                                  {-1.57079632679, 2.094, 4, 15},
                                  {-3.059, 3.059, 4, 15}};
  for (const Arm& arm : Baxter().arms) {
    for (std::size_t i = 0; i < limits.size(); ++i) {
      const scene::LinkSpec& link = Baxter().links[arm.joints[i]];
      EXPECT_EQ(link.joint_type, scene::JointType::kRevolute);
      EXPECT_EQ(link.lower, limits[i].lower) << link.joint_name;
      EXPECT_EQ(link.upper, limits[i].upper) << link.joint_name;
      EXPECT_EQ(link.max_velocity, limits[i].velocity) << link.joint_name;
      EXPECT_EQ(link.max_effort, limits[i].effort) << link.joint_name;
    }
  }
  const scene::LinkSpec& head = Baxter().links[Baxter().head->joints.front()];
  EXPECT_EQ(head.lower, -1.3963);
  EXPECT_EQ(head.upper, 1.3963);
}

TEST(Baxter, AnArmHasTheMassOfItsDescription) {
  constexpr double kArm = 19.71082, kPalm = 0.3;  // [kg]
  for (const Arm& arm : Baxter().arms) {
    double mass = 0;
    for (int joint : arm.joints) mass += Baxter().links[joint].mass;
    EXPECT_NEAR(mass, kArm + kPalm, 1e-9);
    EXPECT_EQ(Baxter().links[arm.gripper->left_finger].mass, 0.1);
    EXPECT_EQ(Baxter().links[arm.gripper->right_finger].mass, 0.1);
  }
}

TEST(Baxter, EveryLinkCanSpinLikeARealBody) {
  for (const scene::LinkSpec& link : Baxter().links) {
    EXPECT_TRUE(link.inertia.isApprox(link.inertia.transpose())) << link.name;
    const Vector3 moments = Eigen::SelfAdjointEigenSolver<Matrix3>(link.inertia).eigenvalues();
    EXPECT_GT(moments[0], 1e-6) << link.name;
    // No principal moment exceeds the sum of the other two, for any distribution of mass.
    EXPECT_LE(moments[2], moments[0] + moments[1]) << link.name;
    EXPECT_LT(link.p_LLcm.norm(), 0.25) << link.name;
  }
}

TEST(Baxter, BothArmsAreBuiltAlike) {
  const Arm& left = Baxter().arms[0];
  const Arm& right = Baxter().arms[1];
  for (std::size_t i = 0; i < left.joints.size(); ++i) {
    const scene::LinkSpec& a = Baxter().links[left.joints[i]];
    const scene::LinkSpec& b = Baxter().links[right.joints[i]];
    // The shoulders are mounted apart; from there on, the arms are the same part.
    EXPECT_TRUE(i == 0 || a.X_PJ == b.X_PJ) << a.joint_name;
    EXPECT_EQ(a.solids, b.solids) << a.joint_name;
    EXPECT_EQ(a.inertia, b.inertia) << a.joint_name;
    EXPECT_EQ(a.p_LLcm, b.p_LLcm) << a.joint_name;
  }
}

TEST(Baxter, NamedPosesStayWithinLimits) {
  std::vector<std::string> names;
  for (const NamedPose& pose : Baxter().poses) {
    names.push_back(pose.name);
    EXPECT_TRUE(IsWithinLimits(Baxter(), pose.q)) << pose.name;
  }
  EXPECT_EQ(names, (std::vector<std::string>{"zero", "neutral", "tucked", "untucked", "ready",
                                             "parked", "smile_start"}));
  EXPECT_EQ(Baxter().q_start, FindPose(Baxter(), "smile_start")->q);
}

TEST(Baxter, AConfigurationOutsideTheLimitsIsNoticed) {
  std::vector<double> q = Baxter().q_start;
  const int s0 = FindJoint(Baxter(), "left_s0").value();
  q[s0] = 1.702;
  EXPECT_FALSE(IsWithinLimits(Baxter(), q));
  EXPECT_TRUE(IsWithinLimits(Baxter(), q, 0.001));
  q[s0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(IsWithinLimits(Baxter(), q, 10));
  q.pop_back();
  EXPECT_FALSE(IsWithinLimits(Baxter(), q));
}

TEST(Baxter, FingersMeetInTheMiddleAndOpenTwoDecimeters) {
  for (const Arm& arm : Baxter().arms) {
    for (int finger : {arm.gripper->left_finger, arm.gripper->right_finger}) {
      const scene::LinkSpec& link = Baxter().links[finger];
      EXPECT_EQ(link.joint_type, scene::JointType::kPrismatic);
      EXPECT_EQ(link.lower, 0.0);
      EXPECT_EQ(link.upper, 0.1);
      // With q = 0 the box's inner face lies in the tool frame's plane y = 0.
      ASSERT_EQ(link.solids.size(), 1u);
      const scene::Solid& box = link.solids[0];
      const double outward = link.axis.y();
      EXPECT_EQ(std::get<scene::Block>(box.shape).size, Vector3(0.04, 0.03, 0.15));
      EXPECT_NEAR(box.X_BS.translation().y() * outward, 0.015, 1e-15);
    }
    const scene::LinkSpec& left = Baxter().links[arm.gripper->left_finger];
    EXPECT_EQ(left.axis, Vector3(0, 1, 0));
    EXPECT_TRUE(left.X_PJ == Baxter().frames[arm.tool].X_LF);
    EXPECT_NEAR(left.X_PJ.translation().z(), 0.19535, 1e-12);
  }
}

// The 2015 program's own numbers; its arms are 15.6 mm off the true Baxter's, everywhere.
TEST(Baxter, StartsWhereTheOriginalDid) {
  constexpr double kClassicOffset = 0.016;  // [m]
  const auto distance = [](const RigidTransform& X, const Vector3& classic) {
    return (X.translation() - classic).norm();
  };
  EXPECT_LT(distance(AtStart("right_gripper"), {0.19976, -0.57805, 0.25766}), kClassicOffset);
  EXPECT_LT(distance(AtStart("left_gripper"), {-0.21505, -0.59370, 0.25796}), kClassicOffset);

  // At the right arm, the finger called left is the one nearer to the robot.
  const RigidTransform X_near(Vector3(0, 0.015, -0.075)), X_far(Vector3(0, 0.015, 0.075));
  const RigidTransform X_WLeft = AtStart("right_gripper_left_finger");
  EXPECT_LT(distance(X_WLeft * X_near, {0.20461, -0.68667, 0.34149}), kClassicOffset);
  EXPECT_LT(distance(X_WLeft * X_far, {0.19746, -0.69868, 0.19215}), kClassicOffset);
}

TEST(Baxter, GrippersPointDownAndOpenAcrossTheTableAtStart) {
  for (const char* frame : {"left_gripper", "right_gripper"}) {
    const Matrix3 R_WG = AtStart(frame).rotation();
    EXPECT_LT(R_WG(2, 2), -0.99) << "approach direction";
    EXPECT_GT(std::abs(R_WG(1, 1)), 0.99) << "opening direction";
  }
}

TEST(Baxter, TheEyeSitsWhereTheOriginalCameraDid) {
  const RigidTransform X_WC = AtStart("eye");
  EXPECT_LT((X_WC.translation() - Vector3(0, -0.71168, 1.15921)).norm(), 1e-4);
  EXPECT_LT((X_WC.rotation().col(2) - Vector3(0, 0.5584, -0.8296)).norm(), 5e-4) << "forward";
  EXPECT_LT((X_WC.rotation().col(0) - Vector3::UnitX()).norm(), 1e-9) << "right in the image";
}

TEST(Baxter, TheRealHeadCameraLooksTenDegreesDown) {
  const RigidTransform X_BaseC =
      FramePose(Baxter(), {}, Baxter().q_start, FindFrame(Baxter(), "head_camera").value());
  EXPECT_LT((X_BaseC.translation() - Vector3(0.18839, 0, 0.74968)).norm(), 1e-5);
  EXPECT_LT((X_BaseC.rotation().col(2) - Vector3(0.98388, 0, -0.17881)).norm(), 1e-5);
  EXPECT_LT((X_BaseC.rotation().col(0) + Vector3::UnitY()).norm(), 1e-9) << "right in the image";
}

TEST(Baxter, BecomesAnArticulation) {
  const RobotModel& model = Baxter();
  const scene::ArticulationSpec spec = MakeArticulationSpec(model, ClassicBasePose());
  EXPECT_TRUE(spec.X_WBase == ClassicBasePose());
  EXPECT_EQ(spec.links, model.links);
  EXPECT_EQ(spec.base_solids, model.base_solids);
  EXPECT_EQ(spec.never_collide, model.never_collide);
  for (std::size_t i = 0; i < spec.links.size(); ++i) {
    EXPECT_LT(spec.links[i].parent, static_cast<int>(i));
    EXPECT_FALSE(spec.links[i].solids.empty()) << spec.links[i].name;
  }
}

/// Returns pairs of links, -1 the base, whose solids overlap although they may collide.
std::set<std::pair<int, int>> UnexpectedTouches(const std::vector<double>& q) {
  constexpr double kDepth = 0.0005;  // [m]
  const RobotModel& model = Baxter();
  const std::set<std::pair<int, int>> allowed(model.never_collide.begin(),
                                              model.never_collide.end());
  const std::vector<RigidTransform> X_BaseL = LinkPoses(model, {}, q);
  const auto touches = [&](int a, int b) {
    const auto& solids = a < 0 ? model.base_solids : model.links[a].solids;
    const RigidTransform X_BaseA = a < 0 ? RigidTransform() : X_BaseL[a];
    for (const scene::Solid& s : solids) {
      for (const scene::Solid& t : model.links[b].solids) {
        if (Overlap(s, X_BaseA * s.X_BS, t, X_BaseL[b] * t.X_BS, kDepth)) return true;
      }
    }
    return false;
  };
  std::set<std::pair<int, int>> pairs;
  for (int a = -1; a < model.num_joints(); ++a) {
    for (int b = a + 1; b < model.num_joints(); ++b) {
      if (!allowed.contains({a, b}) && touches(a, b)) pairs.insert({a, b});
    }
  }
  return pairs;
}

TEST(Baxter, TouchesItselfInNoNamedPose) {
  for (const NamedPose& pose : Baxter().poses) {
    for (double finger : {0.0, 0.1}) {
      std::vector<double> q = pose.q;
      for (const Arm& arm : Baxter().arms) {
        q[arm.gripper->left_finger] = q[arm.gripper->right_finger] = finger;
      }
      EXPECT_TRUE(UnexpectedTouches(q).empty()) << pose.name << ", fingers at " << finger;
    }
  }
}

TEST(Baxter, NoPairThatMayCollideTouchesMostOfTheTime) {
  constexpr int kTrials = 200;
  std::mt19937 random(3);
  std::map<std::pair<int, int>, int> counts;
  for (int trial = 0; trial < kTrials; ++trial) {
    for (const auto& pair : UnexpectedTouches(RandomConfiguration(Baxter(), &random))) {
      ++counts[pair];
    }
  }
  for (const auto& [pair, count] : counts) {
    EXPECT_LT(count, kTrials / 4) << "links " << pair.first << " and " << pair.second;
  }
}

}  // namespace
}  // namespace smile::robot
