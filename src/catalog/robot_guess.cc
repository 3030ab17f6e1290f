#include "catalog/robot_guess.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "base/diagnostic.h"
#include "base/json.h"
#include "base/wording.h"
#include "catalog/internal_gripper_guess.h"
#include "catalog/internal_sampling.h"
#include "catalog/internal_structure.h"
#include "model/robot_placement.h"
#include "motion/articulation_probe.h"
#include "robot/kinematics.h"
#include "robot/urdf_reader.h"
#include "scene/bounds.h"

// A side file is made in two passes. The first reads the URDF without arms and finds these; the
// second reads it again with them, and finds what needs kinematics: overlaps and poses.

namespace smile::catalog {
namespace {

using internal::ArmChain;

/// Fraction of random configurations in which links overlap that touch by construction; less for
/// those two joints apart.
constexpr double kMostly = 0.5, kOften = 0.2;
/// Arms that begin this high above the robot's foot belong to a robot that stands on the floor [m].
constexpr double kHighShoulder = 0.55;
/// Height of Baxter's floor above the table top [m].
constexpr double kFloor = -0.724;

std::string NamesOf(const robot::RobotModel& model, std::span<const int> joints) {
  std::string names;
  for (int joint : joints) {
    names += (names.empty() ? "" : ", ") + model.links[joint].joint_name;
  }
  return names;
}

/// Writes a side file: lists of numbers, names or pairs in one line, all else one line each.
std::string TextOf(const Json& json, const std::string& indent = "") {
  const bool is_plain_list = json.is_array() && std::ranges::none_of(json, [](const Json& x) {
                               return x.is_structured();
                             });
  if (!json.is_structured() || json.empty() || is_plain_list) {
    std::string text = ToText(json);
    for (std::size_t at = text.find(','); is_plain_list && at != std::string::npos;
         at = text.find(',', at + 2)) {
      text.insert(at + 1, " ");
    }
    return text;
  }
  std::string text(1, json.is_array() ? '[' : '{');
  const std::string inner = indent + "  ";
  for (const auto& [key, value] : json.items()) {
    text += (text.size() > 1 ? ",\n" : "\n") + inner;
    if (json.is_object()) text += ToText(Json(key)) + ": ";
    text += TextOf(value, inner);
  }
  return text + "\n" + indent + (json.is_array() ? "]" : "}");
}

class Guesser {
 public:
  Guesser(const std::filesystem::path& urdf, const robot::RobotReaderOptions& options,
          const Progress& progress)
      : urdf_(urdf), options_(options), progress_(progress) {}

  RobotGuess Guess() {
    root_["format"] = 2;
    robot::RobotModel bare = Read();
    FreeFollowersOfArms(&bare);
    FindArms(bare);
    FindHead(bare);
    Place();
    FindLinksThatTouch();
    FindPoses();
    return {.side_file = TextOf(root_) + "\n", .notes = std::move(notes_)};
  }

 private:
  /// Reads the robot with what is known so far.
  robot::RobotModel Read() const {
    robot::RobotReaderOptions options = options_;
    options.side_file.clear();
    options.side_file_text = ToText(root_, 2);
    try {
      return robot::ReadRobot(urdf_, options);
    } catch (const InputError& error) {
      // The side file is one of this program, which nobody can look at.
      std::filesystem::path side_file = urdf_;
      side_file.replace_extension(".robot.json");
      std::vector<Diagnostic> diagnostics = error.diagnostics();
      for (Diagnostic& diagnostic : diagnostics) {
        if (diagnostic.file == side_file.string()) diagnostic.file = urdf_.string();
      }
      throw InputError(std::move(diagnostics));
    }
  }
  [[noreturn]] void Fail(const std::string& message) const {
    throw InputError({urdf_.string(), 0, "", message});
  }

  /// Lets joints move by themselves that mimic one of an arm: planners move the joints of an arm
  /// only. An arm may be longer then, and have further followers.
  void FreeFollowersOfArms(robot::RobotModel* model) {
    while (true) {
      const internal::Structure structure = internal::StructureOf(*model);
      Json freed = Json::array();
      for (const scene::LinkSpec& link : model->links) {
        const bool follows_arm =
            link.mimic && std::ranges::any_of(structure.arms, [&](const ArmChain& arm) {
              return std::ranges::count(arm.joints, link.mimic->leader) > 0;
            });
        if (!follows_arm) continue;
        freed.push_back(link.joint_name);
        notes_.push_back("joint " + link.joint_name + " mimics " +
                         model->links[link.mimic->leader].joint_name +
                         " of an arm: the mimic is ignored, the joint moves by itself");
      }
      if (freed.empty()) return;
      for (const Json& joint : freed) root_["ignore_mimics"].push_back(joint);
      *model = Read();
    }
  }

  void FindArms(const robot::RobotModel& model) {
    const internal::Structure structure = internal::StructureOf(model);
    if (structure.arms.empty()) {
      Fail("found no arm among its " + std::to_string(model.num_joints()) +
           " joints, expected a chain of two joints or more");
    }
    if (structure.arms.size() > robot::kMaxArms) {
      Fail("found " + std::to_string(structure.arms.size()) + " arms, expected at most " +
           std::to_string(robot::kMaxArms));
    }
    if (!structure.torso.empty()) {
      notes_.push_back("torso, which no arm contains: " + NamesOf(model, structure.torso));
    }
    Json frames = Json::object(), arms = Json::object();
    for (const ArmChain& arm : structure.arms) {
      if (arm.joints.size() > robot::kMaxArmJoints) {
        Fail("found a chain of " + std::to_string(arm.joints.size()) + " joints from " +
             Quoted(model.links[arm.joints.front()].joint_name) + " to " +
             Quoted(model.links[arm.joints.back()].joint_name) + ", expected at most " +
             std::to_string(robot::kMaxArmJoints) + " in an arm");
      }
      notes_.push_back(arm.name + ": " + std::to_string(arm.joints.size()) + " joints, " +
                       NamesOf(model, arm.joints));
      internal::ToolGuess tool = GuessTool(model, arm);
      Json joints = Json::array();
      for (int joint : arm.joints) joints.push_back(model.links[joint].joint_name);
      arms[arm.name] = {{"joints", std::move(joints)}, {"tool", tool.tool}};
      arms[arm.name].update(tool.gripper);
      frames.update(tool.frames);
      notes_.push_back(arm.name + ": tool " + tool.tool);
      for (const std::string& note : tool.notes) notes_.push_back(arm.name + ": " + note);
    }
    if (!frames.empty()) root_["frames"] = std::move(frames);
    root_["arms"] = std::move(arms);
    arms_ = structure.arms;
    for (const ArmChain& arm : arms_) LeaveOutGripperThatDoesNotOpen(arm.name);
  }

  /// Leaves out the jaws of an arm if they make no gripper: shapes may mislead.
  void LeaveOutGripperThatDoesNotOpen(const std::string& arm) {
    Json& members = root_["arms"][arm];
    if (!members.contains("jaws")) return;
    try {
      Read();
    } catch (const InputError& error) {
      members.erase("jaws");
      members.erase("pads");
      notes_.push_back(arm + ": left out these jaws, which " + error.diagnostics().front().message +
                       ": describe them in the side file");
    }
  }

  /// Finds an eye: an optical frame, as drivers of cameras name it, that no arm carries.
  void FindHead(const robot::RobotModel& model) {
    const auto is_on_arm = [&](int link) {
      return std::ranges::any_of(arms_, [&](const ArmChain& arm) {
        return internal::IsCarriedBy(model, link, arm.joints.front());
      });
    };
    const robot::Frame* eye = nullptr;
    for (const robot::Frame& frame : model.frames) {
      if (!internal::HasWord(frame.name, {"optical"}) || is_on_arm(frame.link)) continue;
      const bool is_of_head = internal::HasWord(frame.name, {"head"});
      if (eye == nullptr || (is_of_head && !internal::HasWord(eye->name, {"head"}))) eye = &frame;
    }
    if (eye == nullptr) return;
    std::vector<int> joints;
    for (int link = eye->link; link >= 0; link = model.links[link].parent) {
      const bool carries_arm = std::ranges::any_of(arms_, [&](const ArmChain& arm) {
        return internal::IsCarriedBy(model, arm.joints.front(), link);
      });
      if (carries_arm) break;
      if (!model.links[link].mimic) joints.insert(joints.begin(), link);
    }
    if (joints.size() > robot::kMaxArmJoints) return;
    Json names = Json::array();
    for (int joint : joints) names.push_back(model.links[joint].joint_name);
    root_["head"] = {{"joints", names}, {"camera", eye->name}};
    notes_.push_back("head: eye " + eye->name + ", " + std::to_string(joints.size()) + " joints");
  }

  /// Places the robot at the table.
  void Place() {
    model_ = Read();
    q_ = model_.q_start;
    const std::vector<RigidTransform> X_BaseL = robot::LinkPoses(model_, {}, q_);
    double shoulder = HUGE_VAL;
    for (const robot::Arm& arm : model_.arms) {
      shoulder = std::min(shoulder, X_BaseL[arm.joints.front()].translation().z());
    }
    scene::Bounds foot = scene::BoundsOf(model_.base_solids, {});
    if (foot.is_empty()) foot = {Vector3::Zero(), Vector3::Zero()};
    const bool is_on_floor = shoulder - std::min(foot.low.z(), 0.0) > kHighShoulder;
    // On the table with its whole foot, or before it.
    gap_ = is_on_floor ? std::max(0.2, foot.high.x() + 0.05) : -std::max(0.1, 0.02 - foot.low.x());
    height_ = is_on_floor ? kFloor - std::min(foot.low.z(), 0.0) : 0.0;
    height_ = std::round(height_ * 1000) / 1000;
    gap_ = std::round(gap_ * 1000) / 1000;
    root_["stands"] = {{"gap", gap_}, {"height", height_}};
    notes_.push_back(is_on_floor ? "stands on the floor behind the table"
                                 : "stands on the table, at its edge");
  }

  RigidTransform X_WBase() const { return model::RobotBasePose(scene::TableSpec(), gap_, height_); }
  std::string NameOf(int link) const {
    return link < 0 ? model_.frames.front().name : model_.links[link].name;
  }

  // ---- links that touch by construction

  void FindLinksThatTouch() {
    internal::LinkPairs touching;
    for (int i = 0; i < model_.num_joints(); ++i) touching.insert({model_.links[i].parent, i});
    for (const ArmChain& arm : arms_) {
      std::vector<int> hand = arm.beyond;
      hand.insert(hand.begin(), arm.palm);
      for (int a : hand) {
        for (int b : hand) {
          if (a < b) touching.insert({a, b});
        }
      }
    }
    const std::size_t num_neighbors = touching.size();
    for (const auto& [pair, fraction] : internal::OverlapFractions(model_, touching, progress_)) {
      const bool is_near = StepsBetween(pair.first, pair.second) <= 2;
      if (fraction >= (is_near ? kOften : kMostly)) touching.insert(pair);
    }
    Json pairs = Json::array();
    for (const auto& [a, b] : touching) pairs.push_back({NameOf(a), NameOf(b)});
    root_["never_collide"] = std::move(pairs);
    notes_.push_back(std::to_string(touching.size()) + " pairs of links touch by construction: " +
                     std::to_string(num_neighbors) + " as neighbors or in one gripper, " +
                     std::to_string(touching.size() - num_neighbors) + " by overlaps in " +
                     std::to_string(internal::kSamples) + " random configurations");
    model_ = Read();
  }

  /// Returns the number of joints between a link and one that carries it or that it carries; a
  /// large number for others.
  int StepsBetween(int a, int b) const {
    int steps = 0;
    for (int link = std::max(a, b); link > std::min(a, b); link = model_.links[link].parent)
      ++steps;
    return internal::IsCarriedBy(model_, std::max(a, b), std::min(a, b)) ? steps : 1000;
  }

  // ---- poses

  void FindPoses() {
    const scene::TableSpec table;
    motion::ArticulationProbe probe(robot::MakeArticulationSpec(model_, X_WBase()),
                                    {scene::TableSolid(table)});
    q_ = model_.q_start;
    for (const robot::Arm& arm : model_.arms) {
      if (arm.gripper) OpenGripper(*arm.gripper);
    }
    int num_ready = 0;
    for (const robot::Arm& arm : model_.arms) num_ready += PutOverTable(arm, &probe);
    const bool is_free = !probe.FirstOverlap(q_);
    if (num_ready == static_cast<int>(model_.arms.size()) && is_free) {
      notes_.push_back("ready pose: each tool over the table, pointing down, free of overlaps");
    } else {
      notes_.push_back(
          std::string("ready pose: not every tool reaches a place over the table pointing down; ") +
          (is_free ? "the others are in a configuration that is free of overlaps"
                   : "no configuration free of overlaps was found: give one in the side file"));
    }
    Json pose = Json::object();
    for (const robot::Arm& arm : model_.arms) {
      Json values = Json::array();
      for (int joint : arm.joints) {
        const scene::LinkSpec& link = model_.links[joint];
        // Rounded for people, and still within limits.
        values.push_back(
            std::clamp(std::round(q_[joint] * 1e4) / 1e4 + 0.0, link.lower, link.upper));
      }
      pose[arm.name] = std::move(values);
    }
    pose["opening"] = "open";
    root_["poses"] = {{"ready", std::move(pose)}};
    root_["start"] = "ready";
    Read();  // What is written must be readable.
  }

  void OpenGripper(const robot::Gripper& gripper) {
    if (gripper.kind == robot::GripperKind::kFingers) {
      for (int finger : JointsOf(model_, gripper)) q_[finger] = model_.links[finger].upper;
    } else if (gripper.kind == robot::GripperKind::kJaws) {
      q_[gripper.drive] = DrivePositionAt(model_, gripper, OpeningRangeOf(model_, gripper).open);
      scene::FollowLeaders(model_.links, q_);
    }
  }

  /// Puts the tool of an arm over the table, pointing down, or else the arm where it is free.
  /// @returns true if the tool is there.
  bool PutOverTable(const robot::Arm& arm, motion::ArticulationProbe* probe) {
    const double reach = internal::ReachOf(model_, arm, q_);
    const Vector3 p_WS =
        X_WBase() * robot::LinkPoses(model_, {}, q_)[arm.joints.front()].translation();
    std::mt19937_64 random(1);
    for (const double height : {0.25, 0.15, 0.35}) {
      for (const double forward : {0.55, 0.65, 0.45, 0.75, 0.35}) {
        const Vector3 goal(p_WS.x(), p_WS.y() + forward * reach, std::max(height * reach, 0.05));
        for (int attempt = 0; attempt < 4; ++attempt) {
          // First from the middle, then from anywhere.
          std::vector<double> start = q_;
          const std::vector<double> anywhere = internal::RandomConfiguration(model_, &random);
          for (int joint : arm.joints) {
            if (attempt > 0) start[joint] = anywhere[joint];
          }
          const auto solution = internal::ReachDown(model_, arm, X_WBase(), goal, start);
          if (solution && IsFree(arm, *solution, probe)) return true;
        }
      }
    }
    for (int attempt = 0; attempt < internal::kSamples; ++attempt) {
      const std::vector<double> q = internal::RandomConfiguration(model_, &random);
      std::vector<double> angles;
      for (int joint : arm.joints) angles.push_back(q[joint]);
      if (IsFree(arm, angles, probe)) return false;
    }
    return false;
  }
  /// Puts an arm at these angles if it overlaps nothing there.
  bool IsFree(const robot::Arm& arm, std::span<const double> angles,
              motion::ArticulationProbe* probe) {
    std::vector<double> q = q_;
    for (std::size_t i = 0; i < angles.size(); ++i) q[arm.joints[i]] = angles[i];
    if (probe->FirstOverlap(q)) return false;
    q_ = std::move(q);
    return true;
  }

  std::filesystem::path urdf_;
  const robot::RobotReaderOptions& options_;
  const Progress& progress_;
  Json root_ = Json::object();
  std::vector<std::string> notes_;
  std::vector<ArmChain> arms_;
  robot::RobotModel model_;  // with what is known so far
  std::vector<double> q_;    // the ready pose, as far as it is known
  double gap_ = 0, height_ = 0;
};

}  // namespace

RobotGuess GuessRobot(const std::filesystem::path& urdf, const robot::RobotReaderOptions& options,
                      const Progress& progress) {
  return Guesser(urdf, options, progress).Guess();
}

}  // namespace smile::catalog
