#include "robot/internal_side_file.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <stdexcept>
#include <string_view>

#include "base/diagnostic.h"
#include "base/wording.h"
#include "robot/internal_jaws.h"
#include "robot/internal_urdf_values.h"
#include "robot/kinematics.h"
#include "robot/robot_appearance.h"

// The side file `NAME.robot.json` says what URDF cannot: which joints are arms, what the grippers
// are, limits, poses, the start (docs/robot.md). Files of format 1 ignore URDF's <mimic> except
// between two fingers; those of format 2 follow it. A side file is read in two steps: Mountings()
// before the model is built, as attached parts belong to it, and Apply() afterwards.

namespace smile::robot::internal {
namespace {

constexpr std::size_t kMaxPlaces = 100;  // of a robot
constexpr std::size_t kMaxParts = 16;    // of a gripper
/// Words with another meaning in commands and poses.
constexpr std::array<std::string_view, 5> kNoArmNames{"both", "any", "all", "head", "opening"};

constexpr double kMaxPayload = 1e5;  // [kg], the limit for links

// Known members; others are refused, since a misspelled one would be ignored otherwise.
constexpr std::array<std::string_view, 15> kFileMembers{
    "format",        "urdf_hashes",   "kinematics_hashes",
    "ignore_mimics", "frames",        "arms",
    "grippers",      "gripper",       "head",
    "limits",        "never_collide", "poses",
    "start",         "look",          "stands"};
constexpr std::array<std::string_view, 10> kArmMembers{
    "joints",         "tool", "fingers", "jaws",   "suction",
    "closed_opening", "pads", "flange",  "prefix", "payload"};
constexpr std::array<std::string_view, 10> kGripperMembers{
    "parts",   "choices",        "tool", "fingers",       "jaws",
    "suction", "closed_opening", "pads", "never_collide", "look"};
constexpr std::array<std::string_view, 3> kJawsMembers{"drive", "left", "right"};
constexpr std::array<std::string_view, 2> kSuctionMembers{"radius", "capacity"};
constexpr std::array<std::string_view, 3> kPartMembers{"urdf", "to", "prefix"};
constexpr std::array<std::string_view, 3> kHeadMembers{"joint", "joints", "camera"};
constexpr std::array<std::string_view, 2> kPlaceMembers{"gap", "height"};
constexpr std::array<std::string_view, 3> kFrameMembers{"on", "xyz", "rpy"};
constexpr std::array<std::string_view, 4> kLimitMembers{"lower", "upper", "velocity", "effort"};

/// Parses JSON; a syntax error becomes an InputError.
Json ParsedWithLimits(const std::string& text, const std::string& file) {
  try {
    return ParseJson(text);
  } catch (const std::invalid_argument& refusal) {
    throw InputError({file, 0, "", refusal.what()});
  }
}

/// Checks the name of an arm, which is part of commands, poses and columns of trajectories.
void ExpectArmName(const std::string& name, const JsonNode& arms) {
  constexpr auto is_letter = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
  };
  const bool is_word = !name.empty() && is_letter(name[0]) && name.size() <= kMaxArmName &&
                       std::ranges::all_of(name, [&](char c) {
                         return is_letter(c) || (c >= '0' && c <= '9') || c == '_';
                       });
  if (!is_word) {
    arms.Fail("found the name " + Quoted(name) +
              ", expected a letter, then letters, digits or _, " + std::to_string(kMaxArmName) +
              " at most");
  }
  if (std::ranges::find(kNoArmNames, name) == kNoArmNames.end()) return;
  arms.Fail("found the name " + Quoted(name) + ", expected another than " + OneOf(kNoArmNames));
}

/// Returns the prefix of names attached to an arm.
std::string PrefixOf(const std::string& arm, const JsonNode& node) {
  return node.Has("prefix") ? node.Member("prefix").ShortString(kMaxShortText) : arm + "_";
}

/// Applies a side file to a robot. The order matters: frames and limits before the arms that use
/// them, poses after all limits.
class SideFileReader {
 public:
  SideFileReader(const JsonNode* gripper, bool has_appearance, BuiltModel* built)
      : gripper_(gripper), has_appearance_(has_appearance), built_(*built), model_(built->model) {}

  void Read(const JsonNode& root) {
    follows_mimics_ = root.Member("format").Number() >= 2;
    if (root.Has("ignore_mimics")) {
      for (const JsonNode& joint : root.Member("ignore_mimics").ItemsUpTo(kMaxPlaces)) {
        IgnoreMimic(joint);
      }
    }
    if (root.Has("frames")) {
      for (const auto& [name, frame] : root.Member("frames").MembersUpTo(kMaxPlaces)) {
        ReadFrame(name, frame);
      }
    }
    if (root.Has("limits")) {
      for (const auto& [name, limits] : root.Member("limits").Members()) ReadLimits(name, limits);
    }
    if (follows_mimics_) {
      if (const auto complaint = AddMimics(built_.mimics, &model_)) root.Fail(*complaint);
    }
    if (root.Has("arms")) {
      for (const auto& [name, arm] : root.Member("arms").Members()) ReadArm(name, arm);
    }
    if (root.Has("head")) ReadHead(root.Member("head"));
    if (root.Has("never_collide")) {
      for (const JsonNode& pair : root.Member("never_collide").Items()) ReadPair(pair, "");
    }
    // Sorted and unique, whatever the order in the file.
    std::ranges::sort(model_.never_collide);
    auto& pairs = model_.never_collide;
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    follows_mimics_ ? CheckLeaders(root) : CheckMimics(root);
    model_.q_start = NeutralPose();
    if (root.Has("poses")) {
      for (const auto& [name, pose] : root.Member("poses").Members()) ReadPose(name, pose);
    }
    if (root.Has("start")) {
      const JsonNode name = root.Member("start");
      const NamedPose* start = FindPose(model_, name.String());
      if (!start) name.Fail("found " + Quoted(name.String()) + ", expected one of the poses");
      model_.q_start = start->q;
    }
    if (root.Has("look")) {
      ReadAppearance(root.Member("look"), "baxter", "");
    }
  }

 private:
  /// Reads a frame on a link for which the URDF has no name.
  void ReadFrame(const std::string& name, const JsonNode& node) {
    node.ExpectMembers(kFrameMembers);
    if (FindFrame(model_, name)) node.Fail("a link or frame of that name already exists");
    // A copy, since the list of frames grows below.
    const Frame link = model_.frames[FrameNamedBy(node.Member("on"))];
    const Vector3 p = ReadVector(node, "xyz"), rpy = ReadVector(node, "rpy");
    // Fixed axes x, y, z as in URDF.
    const Matrix3 R = (Eigen::AngleAxisd(rpy.z(), Vector3::UnitZ()) *
                       Eigen::AngleAxisd(rpy.y(), Vector3::UnitY()) *
                       Eigen::AngleAxisd(rpy.x(), Vector3::UnitX()))
                          .toRotationMatrix();
    model_.frames.push_back({name, link.link, link.X_LF * RigidTransform(R, p)});
  }
  /// Returns three numbers, or zeros.
  static Vector3 ReadVector(const JsonNode& node, const std::string& member) {
    Vector3 vector = Vector3::Zero();
    if (!node.Has(member)) return vector;
    const std::vector<JsonNode> numbers = node.Member(member).Items(3);
    for (int i = 0; i < 3; ++i) {
      vector[i] = numbers[static_cast<std::size_t>(i)].Number(-100, 100);
    }
    return vector;
  }

  /// Reads narrower limits of a joint: some descriptions have placeholders where the real robot has
  /// limits, or no limits of continuous joints.
  void ReadLimits(const std::string& name, const JsonNode& node) {
    node.ExpectMembers(kLimitMembers);
    const auto joint = FindJoint(model_, name);
    if (!joint) node.Fail("found " + Quoted(name) + ", expected a joint that moves");
    scene::LinkSpec& link = model_.links[*joint];
    const auto narrow = [&](const char* member, double low, double high, double* limit) {
      if (!node.Has(member)) return;
      const JsonNode value = node.Member(member);
      *limit = value.Number();
      if (*limit >= low && *limit <= high) return;
      value.Fail("found " + NumberText(*limit) + ", expected " + NumberText(low) + " to " +
                 NumberText(high) + ", as the URDF has it");
    };
    narrow("lower", link.lower, link.upper, &link.lower);
    narrow("upper", link.lower, link.upper, &link.upper);
    // A continuous joint may have none in the URDF.
    narrow("velocity", 0, std::min(link.max_velocity, kMaxRate), &link.max_velocity);
    narrow("effort", 0, std::min(link.max_effort, kMaxEffort), &link.max_effort);
    const bool moves = link.lower < link.upper && link.max_velocity > 0 && link.max_effort > 0;
    if (!moves) node.Fail("it permits no motion, expected lower below upper, the others above 0");
  }

  void ReadArm(const std::string& name, const JsonNode& node) {
    node.ExpectMembers(kArmMembers);
    Arm arm{.name = name, .joints = {}, .tool = -1, .gripper = {}};
    for (const JsonNode& joint : node.Member("joints").ItemsUpTo(kMaxArmJoints)) {
      const int next = JointNamedBy(joint);
      Take(next, joint);
      ExpectOnArm(next, arm, joint);
      arm.joints.push_back(next);
    }
    if (!node.Has("flange")) {
      arm.tool = FrameOnArm(arm, node.Member("tool"), "");
      arm.gripper = ReadGripper(node, "", arm);
    } else {
      ExpectNothingOfItsOwn(node);
      const std::string prefix = PrefixOf(name, node);
      arm.tool = FrameOnArm(arm, node.Member("flange"), "");
      if (gripper_->Has("tool")) arm.tool = FrameOnArm(arm, gripper_->Member("tool"), prefix);
      arm.gripper = ReadGripper(*gripper_, prefix, arm);
      if (gripper_->Has("never_collide")) {
        for (const JsonNode& pair : gripper_->Member("never_collide").Items()) {
          ReadPair(pair, prefix);
        }
      }
      if (gripper_->Has("look")) {
        ReadAppearance(gripper_->Member("look"), "classic", prefix);
      }
    }
    if (arm.gripper && model_.frames[arm.tool].link < 0) {
      node.Fail("the tool is on the base, expected a gripper on a link that moves");
    }
    // Trajectories use this name for the gripper.
    if (const std::string own = name + "_gripper"; arm.gripper && FindJoint(model_, own)) {
      node.Fail("there is a joint " + Quoted(own) + ", expected that name for the gripper only");
    }
    if (node.Has("payload")) arm.payload = node.Member("payload").Number(0, kMaxPayload);
    model_.arms.push_back(std::move(arm));
  }

  int FrameOnArm(const Arm& arm, const JsonNode& node, const std::string& prefix) const {
    const int frame = FrameNamedBy(node, prefix);
    ExpectOnArm(model_.frames[frame].link, arm, node);
    return frame;
  }
  /// Lets a joint move by itself that mimics another one in the URDF.
  void IgnoreMimic(const JsonNode& joint) {
    const std::string name = joint.String();
    if (std::erase_if(built_.mimics, [&](const Mimic& one) { return one.joint == name; }) > 0) {
      return;
    }
    joint.Fail("found " + Quoted(name) + ", expected a joint that mimics another one");
  }

  /// Checks that a link, or the joint that carries it, moves with all joints of the arm so far:
  /// planners treat an arm as one chain.
  void ExpectOnArm(int link, const Arm& arm, const JsonNode& node) const {
    // The first joint may be anywhere.
    if (arm.joints.empty()) return;
    const int last = arm.joints.back();
    while (link > last) link = model_.links[link].parent;  // parents come before children
    if (link == last) return;
    node.Fail("found " + Quoted(node.String()) + ", which is not attached to joint " +
              Quoted(model_.links[last].joint_name) +
              ", expected one after it in the chain: joints in order from the shoulder to the "
              "wrist, then the gripper");
  }

  /// Claims a joint: an arm, a finger and the head must not share one.
  void Take(int joint, const JsonNode& node) {
    if (const auto& mimic = model_.links[joint].mimic) {
      node.Fail("joint " + Quoted(model_.links[joint].joint_name) + " mimics " +
                Quoted(model_.links[mimic->leader].joint_name) +
                ", expected a joint that follows no other");
    }
    if (taken_.insert(joint).second) return;
    node.Fail("joint " + Quoted(model_.links[joint].joint_name) +
              " is already used, expected each joint once: in an arm, as a finger or in the head");
  }

  static void ExpectNothingOfItsOwn(const JsonNode& arm) {
    for (const char* own : {"tool", "fingers", "jaws", "suction", "closed_opening", "pads"}) {
      if (arm.Has(own))
        arm.Member(own).Fail("the arm has a flange, expected this member in the gripper");
    }
  }

  /// Returns the gripper described by an arm or a gripper node, if any.
  std::optional<Gripper> ReadGripper(const JsonNode& node, const std::string& prefix,
                                     const Arm& arm) {
    const int num_kinds = node.Has("fingers") + node.Has("jaws") + node.Has("suction");
    if (num_kinds > 1) node.Fail("has several kinds of gripper, expected fingers, jaws or suction");
    if (node.Has("jaws")) return ReadJaws(node, prefix, arm);
    if (node.Has("suction")) return ReadSuction(node.Member("suction"));
    if (!node.Has("fingers")) return std::nullopt;
    return ReadFingers(node, prefix, arm);
  }

  /// Reads jaws: one joint that drives one or both of them.
  Gripper ReadJaws(const JsonNode& node, const std::string& prefix, const Arm& arm) {
    const JsonNode jaws = node.Member("jaws");
    jaws.ExpectMembers(kJawsMembers);
    if (node.Has("closed_opening")) {
      node.Member("closed_opening").Fail("is for fingers, expected pads, which measure jaws");
    }
    Gripper gripper{.kind = GripperKind::kJaws,
                    .left_finger = SideOf(jaws.Member("left"), prefix, arm),
                    .right_finger = SideOf(jaws.Member("right"), prefix, arm),
                    .drive = JointNamedBy(jaws.Member("drive"), prefix)};
    Take(gripper.drive, jaws.Member("drive"));
    ExpectOnArm(gripper.drive, arm, jaws.Member("drive"));
    if (gripper.left_finger == gripper.right_finger) {
      jaws.Fail("left and right are the same rigid body, expected two");
    }
    const JsonNode pads = node.Member("pads");
    const std::vector<JsonNode> names = pads.Items(2);
    const std::pair frames{FrameNamedBy(names[0], prefix), FrameNamedBy(names[1], prefix)};
    if (const auto complaint = MeasureJaws(frames, arm.tool, &model_, &gripper)) {
      pads.Fail(*complaint);
    }
    return gripper;
  }
  int SideOf(const JsonNode& name, const std::string& prefix, const Arm& arm) const {
    const int link = model_.frames[FrameNamedBy(name, prefix)].link;
    ExpectOnArm(link, arm, name);
    if (link < 0) name.Fail("is fixed to the base, expected a link that moves");
    return link;
  }

  static Gripper ReadSuction(const JsonNode& node) {
    node.ExpectMembers(kSuctionMembers);
    return {.kind = GripperKind::kSuction,
            .cup_radius = node.Member("radius").Number(0.001, 1),
            .cup_capacity = node.Member("capacity").Number(0, kMaxPayload)};
  }

  Gripper ReadFingers(const JsonNode& node, const std::string& prefix, const Arm& arm) {
    const JsonNode fingers = node.Member("fingers");
    const std::vector<JsonNode> names = fingers.Items(2);
    Gripper gripper{.left_finger = JointNamedBy(names[0], prefix),
                    .right_finger = JointNamedBy(names[1], prefix)};
    if (gripper.left_finger == gripper.right_finger)
      fingers.Fail("both are the same joint, expected two");
    if (follows_mimics_) DropMimics(gripper, fingers);
    Take(gripper.left_finger, names[0]);
    Take(gripper.right_finger, names[1]);
    ExpectOnArm(gripper.left_finger, arm, names[0]);
    ExpectOnArm(gripper.right_finger, arm, names[1]);
    for (int finger : {gripper.left_finger, gripper.right_finger}) {
      MakeSlideFromZero(&model_.links[finger], fingers);
    }
    if (node.Has("closed_opening")) {
      gripper.closed_opening = node.Member("closed_opening").Number();
    } else if (node.Has("pads")) {
      // Measured from the description itself, with fingers closed.
      gripper.closed_opening = GapBetween(node.Member("pads"), prefix, arm.tool);
    }
    if (!(std::abs(gripper.closed_opening) < 100)) {
      fingers.Fail("would be " + NumberText(gripper.closed_opening) +
                   " m apart when closed, expected less than 100");
    }
    // Pads that would overlap when closed: a negative opening has no meaning in commands.
    if (gripper.closed_opening < 0) MakeMeetAtZero(&gripper, fingers);
    return gripper;
  }

  /// Removes the coupling of two fingers: each has its motor, and their gripper moves both alike.
  void DropMimics(const Gripper& gripper, const JsonNode& node) {
    for (int finger : {gripper.left_finger, gripper.right_finger}) {
      scene::LinkSpec& link = model_.links[finger];
      const int other = gripper.left_finger + gripper.right_finger - finger;
      if (!link.mimic || link.mimic->leader != other) continue;
      // Joints that run in the same sense, or one from 0 upwards and the other from 0 downwards.
      const bool runs_down = link.upper == 0, other_runs_down = model_.links[other].upper == 0;
      const double multiplier = runs_down == other_runs_down ? 1 : -1;
      if (link.mimic->multiplier != multiplier || link.mimic->offset != 0) {
        node.Fail("joint " + Quoted(link.joint_name) +
                  " mimics the other one differently, expected fingers that open alike, or jaws");
      }
      link.mimic.reset();
    }
  }

  /// Reverses the axis of a finger whose joint runs from 0 downwards, so that it runs upwards.
  void MakeSlideFromZero(scene::LinkSpec* link, const JsonNode& node) {
    if (link->joint_type == scene::JointType::kPrismatic && link->upper == 0) {
      // Position and axis change sign together, so the finger moves as before.
      link->axis = -link->axis;
      link->upper = -link->lower;
      link->lower = 0;
      turned_.push_back(link->joint_name);
    }
    if (link->joint_type == scene::JointType::kPrismatic && link->lower == 0) return;
    node.Fail("joint \"" + link->joint_name +
              "\" does not slide from 0, expected a finger that slides from 0");
  }

  /// Shifts the origins of fingers that would overlap when closed, such that they meet at 0.
  void MakeMeetAtZero(Gripper* gripper, const JsonNode& node) {
    // Half of the overlap for either finger.
    const double shift = -gripper->closed_opening / 2;
    for (int finger : {gripper->left_finger, gripper->right_finger}) {
      scene::LinkSpec& link = model_.links[finger];
      if (!(link.upper > shift)) node.Fail("never open, expected joints with a longer range");
      // The former position `way` becomes 0; the range ends at the same place as before.
      link.X_PJ = link.X_PJ * RigidTransform(Vector3(link.axis * shift));
      link.upper -= shift;
    }
    gripper->closed_opening = 0;
  }

  /// Returns the distance of two frames along y of the tool, left minus right, with all joints at 0
  /// [m].
  double GapBetween(const JsonNode& pads, const std::string& prefix, int tool) const {
    const std::vector<JsonNode> names = pads.Items(2);
    const std::vector<double> q(model_.links.size(), 0.0);
    // In the tool's frame G, whose y axis is the closing direction.
    const RigidTransform X_GBase = FramePose(model_, {}, q, tool).inverse();
    const auto y_of = [&](const JsonNode& name) {
      return (X_GBase * FramePose(model_, {}, q, FrameNamedBy(name, prefix))).translation().y();
    };
    return y_of(names[0]) - y_of(names[1]);
  }

  void ReadHead(const JsonNode& node) {
    node.ExpectMembers(kHeadMembers);
    Head head{.joints = {}, .camera = FrameNamedBy(node.Member("camera"))};
    std::vector<JsonNode> joints;
    if (node.Has("joint")) joints.push_back(node.Member("joint"));
    if (node.Has("joints")) {
      if (node.Has("joint")) node.Fail("has joint and joints, expected one of them");
      joints = node.Member("joints").ItemsUpTo(kMaxArmJoints);
    }
    for (const JsonNode& joint : joints) {
      head.joints.push_back(JointNamedBy(joint));
      Take(head.joints.back(), joint);
    }
    model_.head = std::move(head);
  }

  void ReadPair(const JsonNode& node, const std::string& prefix) {
    const std::vector<JsonNode> names = node.Items(2);
    const int first = model_.frames[FrameNamedBy(names[0], prefix)].link;
    const int second = model_.frames[FrameNamedBy(names[1], prefix)].link;
    if (first == second)
      node.Fail(
          "both are the same rigid body, expected two links that move relative to each other");
    // The smaller number first, so that each pair has one form.
    model_.never_collide.emplace_back(std::min(first, second), std::max(first, second));
  }

  /// Checks that joints that follow others are pairs of fingers: these share a motion anyway.
  /// Joints that nothing moves may follow any.
  void CheckMimics(const JsonNode& root) const {
    for (const Mimic& mimic : built_.mimics) {
      if (!IsDriven(mimic.joint) && !IsDriven(mimic.master)) continue;
      // A reversed axis changes the sign of a mimic relation.
      const double sign = std::ranges::count(turned_, mimic.joint) == 0 ? 1 : -1;
      const double master_sign = std::ranges::count(turned_, mimic.master) == 0 ? 1 : -1;
      const bool mirrors = std::ranges::any_of(model_.arms, [&](const Arm& arm) {
        if (!arm.gripper || arm.gripper->kind != GripperKind::kFingers) return false;
        const std::string& left = model_.links[arm.gripper->left_finger].joint_name;
        const std::string& right = model_.links[arm.gripper->right_finger].joint_name;
        return (mimic.joint == left && mimic.master == right) ||
               (mimic.joint == right && mimic.master == left);
      });
      // Both fingers then move by the same amount, as the gripper command does.
      if (mirrors && mimic.offset == 0 && sign * master_sign * mimic.multiplier == 1) continue;
      root.Fail("joint " + Quoted(mimic.joint) + " mimics " + Quoted(mimic.master) +
                ", expected a mimic only between two fingers that open symmetrically");
    }
  }
  bool IsDriven(const std::string& name) const {
    const auto joint = FindJoint(model_, name);
    return joint && taken_.contains(*joint);
  }

  /// Checks that no joint of an arm or finger leads others: planners treat an arm as one chain, and
  /// a finger's axis may have been reversed.
  void CheckLeaders(const JsonNode& root) const {
    for (const scene::LinkSpec& link : model_.links) {
      if (!link.mimic) continue;
      const int leader = link.mimic->leader;
      const bool is_free = std::ranges::none_of(model_.arms, [leader](const Arm& arm) {
        const auto& gripper = arm.gripper;
        return std::ranges::count(arm.joints, leader) > 0 ||
               (gripper && gripper->kind == GripperKind::kFingers &&
                (gripper->left_finger == leader || gripper->right_finger == leader));
      });
      if (is_free) continue;
      root.Fail("joint " + Quoted(link.joint_name) + " mimics " +
                Quoted(model_.links[leader].joint_name) +
                ", which belongs to an arm or is a finger, expected mimics of jaws and heads only");
    }
  }

  /// Returns 0 for each joint, or its nearest limit.
  std::vector<double> NeutralPose() const {
    std::vector<double> q;
    for (const scene::LinkSpec& link : model_.links) {
      q.push_back(std::clamp(0.0, link.lower, link.upper));
    }
    scene::FollowLeaders(model_.links, q);
    return q;
  }

  /// Reads a pose: a list of joint values per arm, `head`, and the `opening` of all grippers.
  /// Joints that it does not mention are at 0 or at the nearest limit.
  void ReadPose(const std::string& name, const JsonNode& node) {
    NamedPose pose{name, NeutralPose()};
    for (const auto& [key, value] : node.Members()) {
      if (const Arm* arm = FindArm(model_, key)) {
        const std::vector<JsonNode> values = value.Items(arm->joints.size());
        for (std::size_t i = 0; i < values.size(); ++i) {
          SetJoint(arm->joints[i], values[i].Number(), values[i], &pose);
        }
      } else if (key == "head" && model_.head) {
        SetHead(value, &pose);
      } else if (key == "opening") {
        for (const Arm& each : model_.arms) {
          if (each.gripper) SetOpening(*each.gripper, value, &pose);
        }
      } else {
        value.Fail("expected the name of an arm, head or opening");
      }
    }
    scene::FollowLeaders(model_.links, pose.q);
    model_.poses.push_back(std::move(pose));
  }

  /// Sets the joints of the head: a number for one, a list for any number.
  void SetHead(const JsonNode& node, NamedPose* pose) const {
    const std::vector<int>& joints = model_.head->joints;
    if (joints.size() == 1 && !node.value().is_array()) {
      return SetJoint(joints.front(), node.Number(), node, pose);
    }
    const std::vector<JsonNode> values = node.Items(joints.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
      SetJoint(joints[i], values[i].Number(), values[i], pose);
    }
  }

  /// Sets a gripper's opening: a width, or `open` or `closed`, which suit any gripper.
  void SetOpening(const Gripper& gripper, const JsonNode& node, NamedPose* pose) const {
    if (gripper.kind == GripperKind::kJaws) {
      const OpeningRange range = OpeningRangeOf(model_, gripper);
      const double opening = !node.IsString()            ? node.Number(range.closed, range.open)
                             : node.String() == "open"   ? range.open
                             : node.String() == "closed" ? range.closed
                                                         : FailForOpening(node);
      pose->q[gripper.drive] = DrivePositionAt(model_, gripper, opening);
    }
    if (gripper.kind != GripperKind::kFingers) return;
    for (int finger : {gripper.left_finger, gripper.right_finger}) {
      if (!node.IsString()) {
        SetJoint(finger, (node.Number() - gripper.closed_opening) / 2, node, pose);
      } else if (node.String() == "open") {
        pose->q[finger] = model_.links[finger].upper;
      } else if (node.String() != "closed") {
        FailForOpening(node);
      }
    }
  }
  [[noreturn]] static double FailForOpening(const JsonNode& node) {
    node.Fail("found " + Quoted(node.String()) + ", expected open, closed or a width");
  }

  /// Adds a shipped appearance, for links whose names begin with `prefix`.
  void ReadAppearance(const JsonNode& node, std::string_view known, const std::string& prefix) {
    // Looks are left out on request, for example by programs that only need kinematics.
    if (!has_appearance_) return;
    const std::string name = node.String();
    if (name != known) {
      node.Fail("unknown appearance " + Quoted(name) + ", expected " + std::string(known) +
                DidYouMean(name, std::span(&known, 1)));
    }
    try {
      AddAppearance(name, prefix, &model_);
    } catch (const std::invalid_argument& error) {
      node.Fail(error.what());
    }
  }

  void SetJoint(int joint, double q, const JsonNode& node, NamedPose* pose) const {
    const scene::LinkSpec& link = model_.links[joint];
    if (!(q >= link.lower && q <= link.upper)) {
      node.Fail("joint \"" + link.joint_name + "\" would be at " + NumberText(q) + ", expected " +
                NumberText(link.lower) + " to " + NumberText(link.upper));
    }
    pose->q[joint] = q;
  }

  int JointNamedBy(const JsonNode& node, const std::string& prefix = "") const {
    const auto joint = FindJoint(model_, prefix + node.String());
    if (!joint) {
      node.Fail("found " + Quoted(prefix + node.String()) + ", expected a joint that moves");
    }
    return *joint;
  }
  int FrameNamedBy(const JsonNode& node, const std::string& prefix = "") const {
    const std::string name = prefix + node.String();
    if (const auto frame = FindFrame(model_, name)) return *frame;
    // The root of an attached part has merged with the link it hangs on, but keeps its name.
    for (const auto& [root, frame] : built_.part_roots) {
      if (root == name) return frame;
    }
    node.Fail("found " + Quoted(name) + ", expected the name of a link");
  }

  const JsonNode* gripper_;  // of all flanges
  bool has_appearance_;
  bool follows_mimics_ = false;  // since format 2
  BuiltModel& built_;
  RobotModel& model_;
  std::vector<std::string> turned_;  // fingers whose axis was reversed
  std::set<int> taken_;              // joints of arms, fingers and the head
};

}  // namespace

SideFile::SideFile(const FoundFile& file, const std::string& gripper) : file_(file.path.string()) {
  const std::string& text = *file.bytes;
  root_ = ParsedWithLimits(text, file_);
  const JsonNode root(root_, file_, "");
  root.ExpectMembers(kFileMembers);
  const double format = root.Member("format").Number();
  if (format != 1 && format != 2) {
    root.Member("format").Fail("found " + NumberText(format) + ", expected 1 or 2");
  }
  if (root.Has("gripper") && !root.Has("grippers")) {
    const JsonNode chosen = root.Member("gripper");
    chosen.Fail("found " + Quoted(chosen.String()) +
                ", but there are no grippers, expected the member grippers");
  }
  if (root.Has("grippers")) {
    const std::string wanted = gripper.empty() ? root.Member("gripper").String() : gripper;
    gripper_ = ChooseGripper(root.Member("grippers"), wanted);
    JsonNode(gripper_->value, file_, gripper_->place).ExpectMembers(kGripperMembers);
  } else if (!gripper.empty()) {
    root.Fail("offers no grippers, found the choice " + Quoted(gripper));
  }
}

void SideFile::Fail(const std::string& place, const std::string& message) const {
  JsonNode(root_, file_, place).Fail(message);
}

std::optional<double> SideFile::Place(const std::string& member) const {
  const JsonNode root(root_, file_, "");
  if (!root.Has("stands")) return std::nullopt;
  const JsonNode place = root.Member("stands");
  place.ExpectMembers(kPlaceMembers);
  if (!place.Has(member)) return std::nullopt;
  return place.Member(member).Number(-100, 100);
}

std::vector<Mounting> SideFile::Mountings() const {
  std::vector<Mounting> mountings;
  const JsonNode root(root_, file_, "");
  if (!root.Has("arms")) return mountings;
  for (const auto& [arm, node] : root.Member("arms").MembersUpTo(kMaxArms)) {
    ExpectArmName(arm, root.Member("arms"));
    node.ExpectMembers(kArmMembers);
    // An arm without a flange has its gripper in the URDF itself.
    if (!node.Has("flange")) continue;
    const JsonNode flange = node.Member("flange");
    if (!gripper_) flange.Fail("there are no grippers, expected the member grippers");
    const std::string prefix = PrefixOf(arm, node);
    const JsonNode gripper(gripper_->value, file_, gripper_->place);
    // A gripper without parts of its own uses links of the URDF.
    if (!gripper.Has("parts")) continue;
    for (const JsonNode& part : gripper.Member("parts").ItemsUpTo(kMaxParts)) {
      part.ExpectMembers(kPartMembers);
      mountings.push_back(
          {.urdf = part.Member("urdf").String(),
           .prefix = prefix +
                     (part.Has("prefix") ? part.Member("prefix").ShortString(kMaxShortText) : ""),
           .to = part.Has("to") ? prefix + part.Member("to").String() : flange.String(),
           .place = part.place()});
    }
  }
  return mountings;
}

void SideFile::Apply(BuiltModel* built, bool has_appearance) const {
  const std::optional<JsonNode> gripper =
      gripper_ ? std::optional(JsonNode(gripper_->value, file_, gripper_->place)) : std::nullopt;
  SideFileReader(gripper ? &*gripper : nullptr, has_appearance, built)
      .Read(JsonNode(root_, file_, ""));
}

}  // namespace smile::robot::internal
