#include "robot/internal_side_file.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <span>
#include <string>
#include <string_view>

#include "base/diagnostic.h"
#include "base/files.h"
#include "base/json.h"
#include "base/wording.h"

namespace smile::robot::internal {
namespace {

constexpr std::size_t kMaxFileBytes = 1 << 20;

constexpr std::array<std::string_view, 6> kFileMembers{"format",        "arms",  "head",
                                                       "never_collide", "poses", "start"};
constexpr std::array<std::string_view, 4> kArmMembers{"joints", "tool", "fingers", "payload"};
constexpr std::array<std::string_view, 2> kHeadMembers{"joint", "camera"};

/// A value together with its place in the file.
class Node {
 public:
  Node(const Json& value, const std::string& file, std::string place)
      : value_(value), file_(file), place_(std::move(place)) {}

  [[noreturn]] void Fail(const std::string& message) const {
    throw InputError(Diagnostic{.file = file_, .element = place_, .message = message});
  }

  /// Refuses members nobody reads: a typing mistake must not pass in silence.
  void ExpectMembers(std::span<const std::string_view> names) const {
    ExpectObject();
    for (const auto& [key, value] : value_.items()) {
      if (std::ranges::find(names, key) != names.end()) continue;
      Fail("unknown member " + Quoted(key) + ", expected " + OneOf(names) + DidYouMean(key, names));
    }
  }
  bool Has(const std::string& name) const { return value_.contains(name); }
  Node Member(const std::string& name) const {
    ExpectObject();
    if (!Has(name)) Fail("has no member " + Quoted(name));
    return {value_[name], file_, place_.empty() ? name : place_ + "/" + name};
  }
  /// Names and values of an object.
  std::vector<std::pair<std::string, Node>> Members() const {
    ExpectObject();
    std::vector<std::pair<std::string, Node>> members;
    for (const auto& [key, value] : value_.items()) members.emplace_back(key, Member(key));
    return members;
  }
  std::vector<Node> Items() const {
    if (!value_.is_array()) Fail("found " + Kind() + ", expected a list");
    std::vector<Node> items;
    for (std::size_t i = 0; i < value_.size(); ++i) {
      items.emplace_back(value_[i], file_, place_ + "/" + std::to_string(i));
    }
    return items;
  }
  /// A list of exactly `count` items.
  std::vector<Node> Items(std::size_t count) const {
    std::vector<Node> items = Items();
    if (items.size() == count) return items;
    Fail("length is " + std::to_string(items.size()) + ", expected " + std::to_string(count));
  }
  std::string String() const {
    if (!value_.is_string()) Fail("found " + Kind() + ", expected a text");
    return value_.get<std::string>();
  }
  double Number() const {
    if (!value_.is_number()) Fail("found " + Kind() + ", expected a number");
    return value_.get<double>();
  }

 private:
  void ExpectObject() const {
    if (!value_.is_object()) Fail("found " + Kind() + ", expected an object");
  }
  std::string Kind() const { return value_.type_name(); }

  const Json& value_;
  const std::string& file_;
  std::string place_;
};

class SideFileReader {
 public:
  explicit SideFileReader(RobotModel* model) : model_(*model) {}

  void Read(const Node& root) {
    root.ExpectMembers(kFileMembers);
    const double format = root.Member("format").Number();
    if (format != 1) root.Member("format").Fail("found " + NumberText(format) + ", expected 1");
    if (root.Has("arms")) {
      for (const auto& [name, arm] : root.Member("arms").Members()) ReadArm(name, arm);
    }
    if (root.Has("head")) ReadHead(root.Member("head"));
    if (root.Has("never_collide")) {
      for (const Node& pair : root.Member("never_collide").Items()) ReadPair(pair);
    }
    if (root.Has("poses")) {
      for (const auto& [name, pose] : root.Member("poses").Members()) ReadPose(name, pose);
    }
    if (root.Has("start")) {
      const Node name = root.Member("start");
      const NamedPose* start = FindPose(model_, name.String());
      if (!start) name.Fail("found " + Quoted(name.String()) + ", expected one of the poses");
      model_.q_start = start->q;
    }
  }

 private:
  void ReadArm(const std::string& name, const Node& node) {
    node.ExpectMembers(kArmMembers);
    Arm arm{.name = name, .tool = FrameNamedBy(node.Member("tool"))};
    for (const Node& joint : node.Member("joints").Items())
      arm.joints.push_back(JointNamedBy(joint));
    if (node.Has("fingers")) {
      const std::vector<Node> fingers = node.Member("fingers").Items(2);
      arm.gripper = Gripper{JointNamedBy(fingers[0]), JointNamedBy(fingers[1])};
      for (int finger : {arm.gripper->left_finger, arm.gripper->right_finger}) {
        const physics::LinkSpec& link = model_.links[finger];
        if (link.joint_type != physics::JointType::kPrismatic || link.lower != 0) {
          node.Member("fingers").Fail("joint \"" + link.joint_name +
                                      "\" does not slide from 0 on, expected a finger that does");
        }
      }
    }
    if (node.Has("payload")) {
      const Node payload = node.Member("payload");
      arm.payload = payload.Number();
      if (!(arm.payload >= 0)) {
        payload.Fail("found " + NumberText(arm.payload) + " kg, expected at least 0");
      }
    }
    model_.arms.push_back(std::move(arm));
  }

  void ReadHead(const Node& node) {
    node.ExpectMembers(kHeadMembers);
    model_.head = Head{JointNamedBy(node.Member("joint")), FrameNamedBy(node.Member("camera"))};
  }

  void ReadPair(const Node& node) {
    const std::vector<Node> names = node.Items(2);
    const int first = model_.frames[FrameNamedBy(names[0])].link;
    const int second = model_.frames[FrameNamedBy(names[1])].link;
    if (first == second) node.Fail("both move as one, expected two links that move apart");
    model_.never_collide.emplace_back(std::min(first, second), std::max(first, second));
  }

  /// One list of joint values for each arm, `head`, and the `opening` of all grippers; what a
  /// pose leaves out stays at 0 or at the limit next to it.
  void ReadPose(const std::string& name, const Node& node) {
    NamedPose pose{name, {}};
    for (const physics::LinkSpec& link : model_.links) {
      pose.q.push_back(std::clamp(0.0, link.lower, link.upper));
    }
    for (const auto& [key, value] : node.Members()) {
      if (const Arm* arm = FindArm(model_, key)) {
        const std::vector<Node> values = value.Items(arm->joints.size());
        for (std::size_t i = 0; i < values.size(); ++i) {
          SetJoint(arm->joints[i], values[i].Number(), values[i], &pose);
        }
      } else if (key == "head" && model_.head) {
        SetJoint(model_.head->joint, value.Number(), value, &pose);
      } else if (key == "opening") {
        for (const Arm& each : model_.arms) {
          if (!each.gripper) continue;
          SetJoint(each.gripper->left_finger, value.Number() / 2, value, &pose);
          SetJoint(each.gripper->right_finger, value.Number() / 2, value, &pose);
        }
      } else {
        value.Fail("expected the name of an arm, head or opening");
      }
    }
    model_.poses.push_back(std::move(pose));
  }

  void SetJoint(int joint, double q, const Node& node, NamedPose* pose) const {
    const physics::LinkSpec& link = model_.links[joint];
    if (!(q >= link.lower && q <= link.upper)) {
      node.Fail("joint \"" + link.joint_name + "\" would stand at " + NumberText(q) +
                ", expected " + NumberText(link.lower) + " to " + NumberText(link.upper));
    }
    pose->q[joint] = q;
  }

  int JointNamedBy(const Node& node) const {
    const auto joint = FindJoint(model_, node.String());
    if (!joint) node.Fail("found " + Quoted(node.String()) + ", expected a joint that moves");
    return *joint;
  }
  int FrameNamedBy(const Node& node) const {
    const auto frame = FindFrame(model_, node.String());
    if (!frame) node.Fail("found " + Quoted(node.String()) + ", expected the name of a link");
    return *frame;
  }

  RobotModel& model_;
};

}  // namespace

void ReadSideFile(const std::filesystem::path& path, RobotModel* model) {
  const std::string file = path.string();
  const std::string text = ReadFile(path, kMaxFileBytes);
  Json root;
  try {
    root = Json::parse(text);
  } catch (const Json::parse_error& error) {
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(error.byte, text.size()));
    throw InputError(Diagnostic{.file = file,
                                .line = 1 + static_cast<int>(std::count(text.begin(), end, '\n')),
                                .message = std::string("not JSON: ") + error.what()});
  }
  SideFileReader(model).Read(Node(root, file, ""));
}

}  // namespace smile::robot::internal
