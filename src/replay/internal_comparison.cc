#include "replay/internal_comparison.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/wording.h"
#include "math/angles.h"
#include "scene/units.h"

// Compares a replayed tick with the recorded one. TickComparison answers two questions: what
// differs first (is the replay exact?), and how far apart the two are (how different is its
// outcome?). DeviationMeter collects the latter over time.

namespace smile::replay {
namespace {

/// Name of the quantity of an invisible difference.
constexpr const char* kHidden = "state_hash";

/// Write values for reports.
std::string Written(const Vector3& v) {
  return "(" + NumberText(v.x()) + ", " + NumberText(v.y()) + ", " + NumberText(v.z()) + ")";
}
std::string Written(const model::ControlState& control) {
  std::string text =
      std::to_string(control.state) + " in position " + std::to_string(control.position);
  if (control.override_state >= 0) text += ", shows " + std::to_string(control.override_state);
  return text;
}
std::string Written(const model::HostState& bond) {
  return std::to_string(bond.tightness) + (bond.is_locked ? ", locked" : "") +
         (bond.guest ? ", of guest point " + std::to_string(*bond.guest) : "");
}
std::string Written(bool is_true) { return is_true ? "true" : "false"; }
std::string WrittenHash(std::uint64_t hash) {
  char text[32];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
  return text;
}

}  // namespace

bool IsVisible(const Difference& difference) { return difference.quantity != kHidden; }

std::optional<Difference> TickComparison::Presence(model::ObjectIndex i) const {
  const bool was = recorded_.objects[i].is_present, is = replayed_.objects[i].is_present;
  if (was == is) return std::nullopt;
  return Difference{recorded_.tick, model_.id(i), "present", Written(was), Written(is)};
}

std::optional<Difference> TickComparison::Pose(model::ObjectIndex i) const {
  const recording::TracePose& was = recorded_.objects[i];
  const recording::TracePose& is = replayed_.objects[i];
  const std::string& id = model_.id(i);
  // Exact comparison: a replay gives the same bits or it differs.
  if (was.position != is.position) {
    const double unit = model_.scene().meters_per_unit;
    return Difference{recorded_.tick, id, "position",
                      Written(scene::ToFileUnits(was.position, unit)),
                      Written(scene::ToFileUnits(is.position, unit))};
  }
  if (was.rotation != is.rotation) {
    return Difference{recorded_.tick, id, "rotation",
                      Written(FixedAxesAngles(was.pose_in_world().rotation())),
                      Written(FixedAxesAngles(is.pose_in_world().rotation()))};
  }
  return std::nullopt;
}

std::optional<Difference> TickComparison::Control(model::ControlIndex i) const {
  if (recorded_.controls[i] == replayed_.controls[i]) return std::nullopt;
  return Difference{recorded_.tick, model_.control(i).id(), "state", Written(recorded_.controls[i]),
                    Written(replayed_.controls[i])};
}

std::optional<Difference> TickComparison::Bond(model::HostIndex i) const {
  if (recorded_.bonds[i] == replayed_.bonds[i]) return std::nullopt;
  return Difference{recorded_.tick, model_.host(i).point->id, "tightness",
                    Written(recorded_.bonds[i]), Written(replayed_.bonds[i])};
}

std::optional<Difference> TickComparison::Joint(model::LinkIndex i) const {
  if (recorded_.joints[i] == replayed_.joints[i]) return std::nullopt;
  return Difference{recorded_.tick, model_.robot()->links[i].joint_name, "angle",
                    NumberText(recorded_.joints[i]), NumberText(replayed_.joints[i])};
}

std::optional<Difference> TickComparison::RobotShown() const {
  if (recorded_.is_robot_shown == replayed_.is_robot_shown) return std::nullopt;
  return Difference{recorded_.tick, "robot", "shown", Written(recorded_.is_robot_shown),
                    Written(replayed_.is_robot_shown)};
}

std::optional<Difference> TickComparison::FaceExpression() const {
  if (recorded_.face_expression == replayed_.face_expression) return std::nullopt;
  return Difference{recorded_.tick, "robot", "mood",
                    std::string(ToString(recorded_.face_expression)),
                    std::string(ToString(replayed_.face_expression))};
}

std::optional<Difference> TickComparison::First() const {
  // In scene order: one deviating object soon disturbs others, and the first tick usually has only
  // one.
  for (model::ObjectIndex i : model_.objects()) {
    // Visible differences first, the hash last.
    if (auto difference = Presence(i)) return difference;
    if (auto difference = Pose(i)) return difference;
  }
  for (model::ControlIndex i : model_.controls()) {
    if (auto difference = Control(i)) return difference;
  }
  for (model::HostIndex i : model_.hosts()) {
    if (auto difference = Bond(i)) return difference;
  }
  // Empty without a robot.
  for (model::LinkIndex i : IndexRange<model::LinkIndex>(replayed_.joints.size())) {
    if (auto difference = Joint(i)) return difference;
  }
  if (auto difference = RobotShown()) return difference;
  if (auto difference = FaceExpression()) return difference;
  // Nothing visible differs: compare the hidden state.
  if (recorded_.hash == replayed_.hash) return std::nullopt;
  return Difference{recorded_.tick, "simulation", kHidden, WrittenHash(recorded_.hash),
                    WrittenHash(replayed_.hash)};
}

std::vector<Difference> TickComparison::States() const {
  std::vector<Difference> all;
  const auto add = [&all](std::optional<Difference> difference) {
    if (difference) all.push_back(*std::move(difference));
  };
  for (model::ObjectIndex i : model_.objects()) add(Presence(i));
  for (model::ControlIndex i : model_.controls()) add(Control(i));
  for (model::HostIndex i : model_.hosts()) add(Bond(i));
  add(RobotShown());
  add(FaceExpression());
  return all;
}

std::optional<recording::PoseGap> TickComparison::GapOf(model::ObjectIndex i) const {
  if (!recorded_.objects[i].is_present || !replayed_.objects[i].is_present) return std::nullopt;
  return recording::GapBetween(recorded_.objects[i], replayed_.objects[i]);
}

recording::PoseGap TickComparison::GapOfJoint(model::LinkIndex i) const {
  const double gap = std::abs(replayed_.joints[i] - recorded_.joints[i]);
  // A prismatic joint deviates by a distance, a revolute one by an angle.
  const bool slides = model_.robot()->links[i].joint_type == scene::JointType::kPrismatic;
  return slides ? recording::PoseGap{.distance = gap} : recording::PoseGap{.angle = gap};
}

/// One entry per object, then one per joint; Note() counts in this order.
DeviationMeter::DeviationMeter(const model::Model& model) : model_(model) {
  for (const scene::ObjectSpec& object : model.scene().objects) {
    all_.push_back({.object = object.id()});
  }
  if (model.robot() == nullptr) return;
  for (const auto& link : model.robot()->links) all_.push_back({.object = link.joint_name});
}

void DeviationMeter::Note(std::size_t index, std::uint64_t tick,
                          const std::optional<recording::PoseGap>& gap) {
  Deviation& deviation = all_[index];
  // The last gap stays; the largest one is kept with its tick.
  deviation.end = gap;
  // Strictly larger, so the tick is the first one with the largest gap.
  if (!gap || gap->size() <= deviation.largest.size()) return;
  deviation.largest = *gap;
  deviation.tick = tick;
}

void DeviationMeter::Compare(const recording::TraceTick& recorded,
                             const recording::TraceTick& replayed) {
  const TickComparison comparison(recorded, replayed, model_);
  for (model::ObjectIndex i : model_.objects()) Note(i, recorded.tick, comparison.GapOf(i));
  for (model::LinkIndex i : IndexRange<model::LinkIndex>(recorded.joints.size())) {
    Note(model_.objects().size() + i, recorded.tick, comparison.GapOfJoint(i));
  }
}

std::vector<Deviation> DeviationMeter::Deviations() const {
  std::vector<Deviation> deviations;
  std::copy_if(all_.begin(), all_.end(), std::back_inserter(deviations),
               [](const Deviation& deviation) { return deviation.largest.size() > 0; });
  // Stable: equal deviations stay in the order of the scene.
  std::stable_sort(
      deviations.begin(), deviations.end(),
      [](const Deviation& a, const Deviation& b) { return a.largest.size() > b.largest.size(); });
  return deviations;
}

}  // namespace smile::replay
