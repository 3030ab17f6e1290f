#include "task/cause.h"

#include <algorithm>
#include <cmath>

#include "base/wording.h"
#include "task/symmetry.h"

namespace smile::task {
namespace {

/// What is no farther from where it began was not taken [m].
constexpr double kWhereItBegan = 0.01;
/// What is farther from its place was not put there: a unit block [m].
constexpr double kNear = 0.1;

/// Looks for what went wrong with the objects that are not where they should be.
class Inquest {
 public:
  Inquest(const Structure& structure, const Episode& outcome, const Comparison& comparison)
      : outcome_(outcome),
        comparison_(comparison),
        start_(StartOf(outcome.scene)),
        end_(PosesAt(outcome.scene, outcome.end)) {
    for (const std::string& id : structure.order) AddIfWrong(id, structure);
    for (const scene::ObjectSpec& object : structure.objects) AddIfWrong(object.id(), structure);
  }

  std::optional<Cause> Fallen() const {
    return OfFirst("fell_off_table", [this](const scene::ObjectSpec& object) -> std::string {
      const std::string& id = IdOf(object);
      const bool has_fallen = std::ranges::any_of(outcome_.touches, [&](const Touch& touch) {
        return touch.event.kind == sim::EventKind::kFell && touch.event.object == id;
      });
      return has_fallen ? " fell off the table" : "";
    });
  }

  std::optional<Cause> StillHeld() const {
    return OfFirst("still_held", [this](const scene::ObjectSpec& object) -> std::string {
      return comparison_.errors.at(object.id()).is_held ? " is still held" : "";
    });
  }

  std::optional<Cause> NeverTaken() const {
    return OfFirst("never_taken", [this](const scene::ObjectSpec& object) -> std::string {
      const std::string& id = IdOf(object);
      const double way = (end_.at(id).translation() - start_.at(id).translation()).norm();
      return way < kWhereItBegan ? " still lies where it began" : "";
    });
  }

  std::optional<Cause> Toppled() const {
    return OfFirst("toppled", [this](const scene::ObjectSpec& object) -> std::string {
      const RigidTransform& X_WGoal = comparison_.goal.at(object.id());
      const RigidTransform& X_WB = end_.at(IdOf(object));
      const double below = X_WGoal.translation().z() - X_WB.translation().z();
      if (below > kTolerance) return " lies " + Millimeters(below) + " lower than it should";
      const double tilt = SymmetryOf(object).TiltBetween(X_WGoal.rotation(), X_WB.rotation());
      return tilt > kAngleTolerance ? " lies tilted by " + Degrees(tilt) : "";
    });
  }

  std::optional<Cause> Misplaced() const {
    return OfFirst("misplaced", [this](const scene::ObjectSpec& object) -> std::string {
      const ObjectError& error = comparison_.errors.at(object.id());
      if (error.distance > kNear) return "";
      return " is " + Millimeters(error.distance) + " from its place, turned by " +
             Degrees(error.angle);
    });
  }

  std::optional<Cause> NotPlaced() const {
    return OfFirst("not_placed", [this](const scene::ObjectSpec& object) -> std::string {
      return " is " + Millimeters(comparison_.errors.at(object.id()).distance) + " from its place";
    });
  }

 private:
  void AddIfWrong(const std::string& id, const Structure& structure) {
    const auto object = std::ranges::find(structure.objects, id, &scene::ObjectSpec::id);
    const bool is_known = std::ranges::find(wrong_, &*object) != wrong_.end();
    if (!is_known && !comparison_.errors.at(id).is_within()) wrong_.push_back(&*object);
  }

  /// Its id in the robot's scene.
  const std::string& IdOf(const scene::ObjectSpec& object) const {
    return comparison_.match.at(object.id());
  }

  /// Of the first object of which there is something to tell.
  template <class Tell>
  std::optional<Cause> OfFirst(const char* word, const Tell& tell) const {
    for (const scene::ObjectSpec* object : wrong_) {
      const std::string what = tell(*object);
      if (!what.empty()) return Cause{word, IdOf(*object) + what};
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
  const Comparison& comparison_;
  ObjectPoses start_, end_;
  std::vector<const scene::ObjectSpec*> wrong_;  ///< of the structure
};

std::optional<Cause> CauseOfMissingEffect(const Structure& structure, const Episode& outcome,
                                          const Comparison& comparison) {
  for (std::size_t i = 0; i < structure.effects.size(); ++i) {
    if (comparison.achieved[i]) continue;
    return Cause{"effect_missing",
                 "not achieved: " + WordsOf(structure.effects[i], outcome.scene.meters_per_unit)};
  }
  return std::nullopt;
}

bool HasFailed(const ProgramEnd& program) { return program.status == "failed"; }

}  // namespace

bool IsSuccess(const Comparison& comparison, const ProgramEnd& program) {
  return comparison.is_rebuilt() && !HasFailed(program);
}

std::optional<Cause> CauseOf(const Structure& structure, const Episode& outcome,
                             const Comparison& comparison, const ProgramEnd& program) {
  if (IsSuccess(comparison, program)) return std::nullopt;
  if (HasFailed(program)) {
    return Cause{"brain_failed", "the robot program failed: " + program.message};
  }
  const Inquest inquest(structure, outcome, comparison);
  if (const auto cause = inquest.Fallen()) return cause;
  if (program.status == "running" || program.status == "stopped") {
    return Cause{"time_up", "the robot program was still at work when it had to end"};
  }
  if (const auto cause = inquest.StillHeld()) return cause;
  if (const auto cause = inquest.NeverTaken()) return cause;
  if (const auto cause = inquest.Toppled()) return cause;
  if (const auto cause = inquest.Misplaced()) return cause;
  if (const auto cause = inquest.NotPlaced()) return cause;
  return CauseOfMissingEffect(structure, outcome, comparison);
}

}  // namespace smile::task
