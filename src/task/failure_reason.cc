#include "task/failure_reason.h"

#include <algorithm>
#include <cmath>

#include "base/wording.h"
#include "task/symmetry.h"

namespace smile::task {
namespace {

/// An object displaced by less than this was not taken [m].
constexpr double kWhereItBegan = 0.01;
/// An object farther from its goal than this was not placed, only displaced: a unit block [m].
constexpr double kNear = 0.1;

/// Determines the failure reason from the objects that are not at their goal poses.
class FailureAnalysis {
 public:
  FailureAnalysis(const Structure& structure, const Episode& outcome,
                  const StructureComparison& comparison)
      : outcome_(outcome),
        comparison_(comparison),
        start_(StartOf(outcome.scene)),
        end_(PosesAt(outcome.scene, outcome.end)) {
    // Objects in the order of demonstrated placement, then the rest: the first match names the
    // reason.
    for (const std::string& id : structure.order) AddIfWrong(id, structure);
    for (const scene::ObjectSpec& object : structure.objects) AddIfWrong(object.id(), structure);
  }

  std::optional<FailureReason> Fallen() const {
    return OfFirst("fell_off_table", [this](const scene::ObjectSpec& object) -> std::string {
      const std::string& id = IdOf(object);
      const bool has_fallen =
          std::ranges::any_of(outcome_.contacts, [&](const ContactEvent& contact) {
            return contact.event.kind == sim::EventKind::kFell && contact.event.object == id;
          });
      return has_fallen ? " fell off the table" : "";
    });
  }

  std::optional<FailureReason> StillHeld() const {
    return OfFirst("still_held", [this](const scene::ObjectSpec& object) -> std::string {
      return comparison_.errors.at(object.id()).is_held ? " is still held" : "";
    });
  }

  std::optional<FailureReason> NeverTaken() const {
    return OfFirst("never_taken", [this](const scene::ObjectSpec& object) -> std::string {
      const std::string& id = IdOf(object);
      const double displacement = (end_.at(id).translation() - start_.at(id).translation()).norm();
      return displacement < kWhereItBegan ? " is still at its start position" : "";
    });
  }

  std::optional<FailureReason> Toppled() const {
    return OfFirst("toppled", [this](const scene::ObjectSpec& object) -> std::string {
      const RigidTransform& X_WGoal = comparison_.goal.at(object.id());
      const RigidTransform& X_WB = end_.at(IdOf(object));
      // An object below its goal fell from what it should stand on, even if it landed upright.
      const double below = X_WGoal.translation().z() - X_WB.translation().z();
      if (below > kTolerance) return " lies " + Millimeters(below) + " lower than it should";
      const double tilt = SymmetryOf(object).TiltBetween(X_WGoal.rotation(), X_WB.rotation());
      return tilt > kAngleTolerance ? " is tilted by " + Degrees(tilt) : "";
    });
  }

  std::optional<FailureReason> Apart() const {
    return OfFirst("apart", [this](const scene::ObjectSpec& object) -> std::string {
      const ObjectError& error = comparison_.errors.at(object.id());
      if (!error.is_apart || !error.is_pose_within()) return "";
      const auto pair =
          std::ranges::find_if(comparison_.neighbors, [&object](const NeighborError& neighbor) {
            return neighbor.pair.object == object.id() && !neighbor.is_within();
          });
      return " is " + Millimeters(pair->distance) + " from its place relative to " +
             comparison_.match.at(pair->pair.other) + ", turned by " + Degrees(pair->angle);
    });
  }

  std::optional<FailureReason> Misplaced() const {
    return OfFirst("misplaced", [this](const scene::ObjectSpec& object) -> std::string {
      const ObjectError& error = comparison_.errors.at(object.id());
      if (error.distance > kNear || error.is_pose_within()) return "";
      return " is " + Millimeters(error.distance) + " from its place, turned by " +
             Degrees(error.angle);
    });
  }

  std::optional<FailureReason> NotPlaced() const {
    return OfFirst("not_placed", [this](const scene::ObjectSpec& object) -> std::string {
      if (comparison_.errors.at(object.id()).is_pose_within()) return "";
      return " is " + Millimeters(comparison_.errors.at(object.id()).distance) + " from its place";
    });
  }

 private:
  /// Appends an object of the structure that is not within tolerance, once.
  void AddIfWrong(const std::string& id, const Structure& structure) {
    const auto object = std::ranges::find(structure.objects, id, &scene::ObjectSpec::id);
    const bool is_known = std::ranges::find(wrong_, &*object) != wrong_.end();
    if (!is_known && !comparison_.errors.at(id).is_within()) wrong_.push_back(&*object);
  }

  /// Its id in the robot's scene.
  const std::string& IdOf(const scene::ObjectSpec& object) const {
    return comparison_.match.at(object.id());
  }

  /// Returns a reason with the text of the first object for which `text_of` returns one.
  template <class TextOf>
  std::optional<FailureReason> OfFirst(const char* code, const TextOf& text_of) const {
    for (const scene::ObjectSpec* object : wrong_) {
      const std::string what = text_of(*object);
      if (!what.empty()) return FailureReason{code, IdOf(*object) + what};
    }
    return std::nullopt;
  }

  static std::string Millimeters(double length) {
    return NumberText(std::round(1000 * length)) + " mm";
  }
  static std::string Degrees(double angle) {
    return NumberText(std::round(RadiansToDegrees(angle))) + " degrees";
  }

  const Episode& outcome_;
  const StructureComparison& comparison_;
  ObjectPoses start_, end_;
  std::vector<const scene::ObjectSpec*> wrong_;  ///< of the structure
};

/// Returns the reason for the first effect that is not achieved; nullopt if all are.
std::optional<FailureReason> ReasonOfMissingEffect(const Structure& structure,
                                                   const Episode& outcome,
                                                   const StructureComparison& comparison) {
  for (std::size_t i = 0; i < structure.effects.size(); ++i) {
    if (comparison.achieved[i]) continue;
    return FailureReason{
        "effect_missing",
        "not achieved: " + WordsOf(structure.effects[i], outcome.scene.meters_per_unit)};
  }
  return std::nullopt;
}

bool HasFailed(const ProgramEnd& program) { return program.status == "failed"; }

}  // namespace

bool IsSuccess(const StructureComparison& comparison, const ProgramEnd& program) {
  return comparison.is_achieved() && program.status == "exited";
}

std::optional<FailureReason> FailureReasonOf(const Structure& structure, const Episode& outcome,
                                             const StructureComparison& comparison,
                                             const ProgramEnd& program) {
  if (IsSuccess(comparison, program)) return std::nullopt;
  if (HasFailed(program)) {
    return FailureReason{"brain_failed", "the brain failed: " + program.message};
  }
  // From the most specific reason to the most general one. A fall or a broken rule comes first,
  // since no time could mend it; a program that ran out of time comes before reasons that more time
  // might have removed.
  const FailureAnalysis analysis(structure, outcome, comparison);
  if (const auto reason = analysis.Fallen()) return reason;
  if (!comparison.broken_rules.empty()) {
    return FailureReason{"rule_broken", WordsOf(comparison.broken_rules.front())};
  }
  if (program.status == "running" || program.status == "stopped") {
    return FailureReason{"time_up", "the brain was still running when the episode ended"};
  }
  if (const auto reason = analysis.StillHeld()) return reason;
  if (const auto reason = analysis.NeverTaken()) return reason;
  if (const auto reason = analysis.Toppled()) return reason;
  if (const auto reason = analysis.Misplaced()) return reason;
  if (const auto reason = analysis.NotPlaced()) return reason;
  if (const auto reason = analysis.Apart()) return reason;
  if (!comparison.intruders.empty()) {
    return FailureReason{"intruder", comparison.intruders.front() +
                                         " touches the structure and does not belong to it"};
  }
  return ReasonOfMissingEffect(structure, outcome, comparison);
}

}  // namespace smile::task
