#include <unistd.h>

#include <filesystem>

#include "sim/test/simulation_fixture.h"

namespace smile::sim {
namespace {

/// A kind of gripper: the links and joints below a palm, and its members in the side file. The tool
/// looks down, 0.1 m below the palm; the left side is at -y of the palm.
struct Kind {
  std::string name, urdf, palm_shapes, frames, gripper;
};

void PrintTo(const Kind& kind, std::ostream* out) { *out << kind.name; }

std::string BoxAt(const std::string& xyz, const std::string& size) {
  return "<collision><origin xyz=\"" + xyz + "\"/><geometry><box size=\"" + size +
         "\"/></geometry></collision>";
}

constexpr const char* kInertial =
    R"(<inertial><mass value="0.1"/><inertia ixx="1e-3" iyy="1e-3" izz="1e-3" ixy="0" ixz="0" iyz="0"/></inertial>)";

/// A moving finger that hangs 0.1 m down from its joint.
std::string Finger(const std::string& name, const std::string& parent, const std::string& joint) {
  return "<link name=\"" + name + "\">" + kInertial + BoxAt("0 0 -0.05", "0.02 0.01 0.1") +
         "</link><joint name=\"" + name + "_joint\"" + joint + "<parent link=\"" + parent +
         "\"/><child link=\"" + name + "\"/></joint>";
}
std::string Slide(const std::string& y, const std::string& axis) {
  return " type=\"prismatic\"><origin xyz=\"0 " + y + " -0.02\"/><axis xyz=\"0 " + axis +
         " 0\"/><limit lower=\"0\" upper=\"0.05\" velocity=\"0.2\" effort=\"20\"/>";
}
std::string Turn(const std::string& origin, const std::string& axis, const std::string& limits,
                 const std::string& more = "") {
  return " type=\"revolute\"><origin " + origin + "/><axis xyz=\"" + axis + " 0 0\"/><limit " +
         limits + " velocity=\"2\" effort=\"5\"/>" + more;
}
std::string Mimic(const std::string& values) { return "<mimic joint=\"l_joint\" " + values + "/>"; }

constexpr const char* kFixedLeft = "0 -0.035 -0.07";
const std::string kFixedFinger = BoxAt(kFixedLeft, "0.02 0.01 0.1");
constexpr const char* kJawLimits = R"(lower="-0.25" upper="0.5")";
constexpr const char* kPads = R"(
"pad_l": {"on": "l", "xyz": [0, 0.005, -0.1]}, "pad_r": {"on": "r", "xyz": [0, -0.005, -0.1]},)";
constexpr const char* kPadsOnPalm = R"(
"pad_l": {"on": "palm", "xyz": [0, -0.03, -0.12]}, "pad_r": {"on": "r", "xyz": [0, -0.005, -0.1]},)";

std::vector<Kind> Kinds() {
  const std::string jaws =
      R"("jaws": {"drive": "l_joint", "left": "l", "right": "r"}, "pads": ["pad_l", "pad_r"])";
  const std::string one_jaw =
      R"("jaws": {"drive": "r_joint", "left": "palm", "right": "r"}, "pads": ["pad_l", "pad_r"])";
  return {
      {.name = "TwoSlides",
       .urdf = Finger("l", "palm", Slide("-0.005", "-1")) +
               Finger("r", "palm", Slide("0.005", "1") + "<mimic joint=\"l_joint\"/>"),
       .gripper = R"("fingers": ["l_joint", "r_joint"])"},
      {.name = "OneSlide",
       .urdf = Finger("r", "palm", Slide("-0.005", "1")),
       .palm_shapes = kFixedFinger,
       .frames = kPadsOnPalm,
       .gripper = one_jaw},
      {.name = "OneJawThatTurns",
       .urdf = Finger("r", "palm", Turn(R"(xyz="0 0.03 -0.02")", "1", kJawLimits)),
       .palm_shapes = kFixedFinger,
       .frames = kPadsOnPalm,
       .gripper = one_jaw},
      {.name = "TwoJawsThatTurn",
       .urdf =
           Finger("l", "palm", Turn(R"(xyz="0 -0.03 -0.02")", "-1", kJawLimits)) +
           Finger("r", "palm",
                  Turn(R"(xyz="0 0.03 -0.02" rpy="0.1 0 0")", "-1", R"(lower="-0.5" upper="0.5")",
                       Mimic(R"(multiplier="-1" offset="0.1")"))),
       .frames = kPads,
       .gripper = jaws},
      {.name = "FourBars",
       .urdf = Finger("k", "palm",
                      Turn(R"(xyz="0 -0.03 0.08")", "-1", kJawLimits, Mimic(R"(multiplier="1")"))) +
               Finger("l", "k", Turn(R"(xyz="0 0 -0.1")", "1", kJawLimits)) +
               Finger("m", "palm",
                      Turn(R"(xyz="0 0.03 0.08")", "1", kJawLimits, Mimic(R"(multiplier="1")"))) +
               Finger("r", "m",
                      Turn(R"(xyz="0 0 -0.1")", "-1", kJawLimits, Mimic(R"(multiplier="1")"))),
       .frames = kPads,
       .gripper = jaws},
      {.name = "Suction",
       .palm_shapes = BoxAt("0 0 -0.06", "0.02 0.02 0.08"),
       .gripper = R"("suction": {"radius": 0.02, "capacity": 1})"},
  };
}

/// A column with a palm that moves up and down over a block of 6 cm.
class GripperKinds : public SimulationFixture, public testing::WithParamInterface<Kind> {
 protected:
  GripperKinds() { MakeSimulation(GetParam(), 0.5); }

  void MakeSimulation(const Kind& kind, double mass, const model::RobotBodyOptions& body = {}) {
    const std::filesystem::path folder =
        std::filesystem::path(testing::TempDir()) /
        ("smile_gripper_kinds_" + kind.name + std::to_string(getpid()));
    std::filesystem::create_directories(folder);
    WriteFile(folder / "r.urdf",
              "<robot name=\"column\"><link name=\"base\"/><link name=\"palm\">" +
                  std::string(kInertial) + BoxAt("0 0 0", "0.1 0.1 0.04") + kind.palm_shapes +
                  R"(</link><joint name="lift" type="prismatic"><parent link="base"/>
<child link="palm"/><origin xyz="0.4 0 0.5"/><axis xyz="0 0 -1"/>
<limit lower="0" upper="0.4" velocity="0.5" effort="100"/></joint>)" +
                  kind.urdf + "</robot>");
    WriteFile(folder / "r.robot.json", R"({"format": 2, "frames": {)" + kind.frames +
                                           R"("tool": {"on": "palm", "xyz": [0, 0, -0.1],
"rpy": [3.141592653589793, 0, 0]}}, "arms": {"only": {"joints": ["lift"], "tool": "tool", )" +
                                           kind.gripper + R"(}},
"never_collide": [)" + Pairs(kind) + R"(], "poses": {"up": {"only": [0], "opening": "open"}},
"start": "up"})");
    RobotPlacement placement{
        .model = robot::ReadRobot(folder / "r.urdf"), .gap = 0, .height = 0, .body = body};
    std::filesystem::remove_all(folder);
    scene::SceneSpec scene{.name = "test"};
    const RigidTransform X_WBase = model::RobotBasePose(scene.table, 0, 0);
    const Vector3 below = X_WBase * Vector3(0.4, 0, 0.03);
    scene.objects = {BlockAt("block", below, mass, {0.06, 0.06, 0.06})};
    simulation_ = std::make_unique<Simulation>(std::move(scene), placement);
  }
  /// All links of the gripper pass through each other.
  static std::string Pairs(const Kind& kind) {
    std::vector<std::string> links{"palm"};
    for (const std::string name : {"k", "l", "m", "r"}) {
      if (kind.urdf.find("<link name=\"" + name + "\"") != std::string::npos) {
        links.push_back(name);
      }
    }
    std::string pairs;
    for (std::size_t i = 0; i < links.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        pairs += (pairs.empty() ? "" : ", ") + ("[\"" + links[j]) + "\", \"" + links[i] + "\"]";
      }
    }
    return pairs;
  }

  const world::RobotBody& robot() const { return *simulation_->robot(); }
  void Lift(double rate, double seconds) {
    ASSERT_EQ(simulation_->Apply(TurnJoint{.joint = "lift", .velocity = -rate}), std::nullopt);
    TickSeconds(*simulation_, seconds);
    ASSERT_EQ(simulation_->Apply(TurnJoint{.joint = "lift", .velocity = 0}), std::nullopt);
  }
  void Close() {
    ASSERT_EQ(simulation_->Apply(MoveGripper{.arm = "left", .velocity = -0.05}), std::nullopt);
  }
  void Open() {
    ASSERT_EQ(simulation_->Apply(MoveGripper{.arm = "left", .velocity = 0.05}), std::nullopt);
  }
  /// Grasps the block, or sucks at its top.
  void Grasp() {
    if (GetParam().name == "Suction") {
      Close();
      Lift(-0.1, 3.2);
      // On until it touches the block, and not deeper.
      for (int i = 0; i < 100 && robot().HeldBodies(0).empty(); ++i) Lift(-0.1, 0.01);
    } else {
      Lift(-0.1, 3.7);
      Close();
    }
    TickSeconds(*simulation_, 2.5);
  }
  /// Expects joints that mimic where their leader has them.
  void ExpectThatFollowersFollow(double tolerance = 1e-3) const {
    const std::vector<double> q = robot().positions();
    for (int i = 0; i < robot().model().num_joints(); ++i) {
      const auto& mimic = robot().model().links[i].mimic;
      if (!mimic) continue;
      EXPECT_NEAR(q[i], mimic->multiplier * q[mimic->leader] + mimic->offset, tolerance)
          << robot().model().links[i].joint_name;
    }
  }

  std::unique_ptr<Simulation> simulation_;
};

TEST_P(GripperKinds, GraspLiftAndRelease) {
  Grasp();
  ASSERT_EQ(robot().HeldBodies(0).size(), 1u);
  ExpectThatFollowersFollow();
  const double opening = GetParam().name == "Suction" ? 0 : 0.06;
  // The tips of jaws that turn may be farther apart than the block is wide.
  EXPECT_NEAR(robot().GripperOpening(0), opening, 0.011);
  Lift(0.1, 2);
  EXPECT_GT(PositionOf(*simulation_, "block").z(), 0.2);
  Open();
  TickSeconds(*simulation_, 0.1);
  EXPECT_TRUE(robot().HeldBodies(0).empty());
  ExpectThatFollowersFollow();
  TickSeconds(*simulation_, 1.5);
  EXPECT_LT(PositionOf(*simulation_, "block").z(), 0.05);
}

TEST_P(GripperKinds, ChangeTheirOpeningAtTheCommandedRate) {
  if (GetParam().name == "Suction") {
    Close();
    EXPECT_EQ(robot().GripperOpening(0), 0);
    return;
  }
  const double before = robot().GripperOpening(0);
  Close();
  TickSeconds(*simulation_, 0.5);
  EXPECT_NEAR(robot().GripperOpening(0), before - 0.025, 0.002);
  ExpectThatFollowersFollow();
}

TEST_P(GripperKinds, ContinueASavedStateToTheSameBits) {
  Grasp();
  const SimulationState state = simulation_->Save();
  const auto rest = [&] {
    Lift(0.2, 0.5);
    Open();
    TickSeconds(*simulation_, 0.3);
    Close();
    TickSeconds(*simulation_, 0.2);
    return simulation_->state_hash();
  };
  const std::uint64_t hash = rest();
  simulation_->Restore(state);
  EXPECT_EQ(rest(), hash);
}

TEST_P(GripperKinds, AreTakenOverByAPoseAtOnce) {
  // Puts the arm, and with it what it holds, elsewhere.
  Grasp();
  const double before = PositionOf(*simulation_, "block").z();
  const double lift = robot().ArmAngles(0)[0];
  ASSERT_EQ(simulation_->Apply(JointAngles{.arms = {{"left", {lift - 0.2}}}}), std::nullopt);
  EXPECT_NEAR(PositionOf(*simulation_, "block").z(), before + 0.2, 2e-3);
  ExpectThatFollowersFollow();
}

TEST_P(GripperKinds, HaveJointsThatNoOtherCommandMoves) {
  for (const int joint : JointsOf(robot().model(), *robot().model().arms[0].gripper)) {
    const std::string name = robot().model().links[static_cast<std::size_t>(joint)].joint_name;
    const auto refusal = simulation_->Apply(TurnJoint{.joint = name, .velocity = 1});
    ASSERT_TRUE(refusal.has_value()) << name;
    EXPECT_TRUE(refusal->starts_with("the robot has no joint \"" + name + "\" to turn"))
        << *refusal;
  }
}

TEST_P(GripperKinds, HoldByFrictionToo) {
  MakeSimulation(GetParam(), 0.3, {.grasps_by_friction = true});
  Grasp();
  Lift(0.1, 2);
  TickSeconds(*simulation_, 1);
  EXPECT_EQ(robot().HeldBodies(0).empty(), GetParam().name != "Suction");
  EXPECT_GT(PositionOf(*simulation_, "block").z(), 0.2);
  // A linkage that presses hard gives way a little.
  ExpectThatFollowersFollow(0.005);
}

TEST_P(GripperKinds, WorkOnAKinematicRobot) {
  MakeSimulation(GetParam(), 0.5, {.is_kinematic = true});
  Grasp();
  ASSERT_EQ(robot().HeldBodies(0).size(), 1u);
  ExpectThatFollowersFollow();
  Lift(0.1, 2);
  EXPECT_GT(PositionOf(*simulation_, "block").z(), 0.2);
}

INSTANTIATE_TEST_SUITE_P(Each, GripperKinds, testing::ValuesIn(Kinds()),
                         [](const auto& kind) { return kind.param.name; });

class SuctionCup : public GripperKinds {};

TEST_P(SuctionCup, HoldsNothingBeyondItsCapacity) {
  MakeSimulation(GetParam(), 1.5);
  Grasp();
  EXPECT_TRUE(robot().HeldBodies(0).empty());
}

INSTANTIATE_TEST_SUITE_P(One, SuctionCup, testing::Values(Kinds().back()),
                         [](const auto& kind) { return kind.param.name; });

}  // namespace
}  // namespace smile::sim
