#include "task/failure_reason.h"

#include <algorithm>
#include <cmath>

#include "task/symmetry.h"
#include "texts/message_json.h"

namespace smile::task {
namespace {

using texts::Say;
using texts::UserMessage;

/// An object displaced by less than this was not taken [m].
constexpr double kWhereItBegan = 0.01;
/// An object farther from its goal than this was not placed, only displaced: a unit block [m].
constexpr double kNear = 0.1;
constexpr std::size_t kMaxCodeBytes = 256, kMaxTextBytes = 1 << 16;

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
    return OfFirst("fell_off_table", [this](const scene::ObjectSpec& object) {
      const UserMessage id = IdOf(object);
      const bool has_fallen =
          std::ranges::any_of(outcome_.contacts, [&](const ContactEvent& contact) {
            return contact.event.kind == sim::EventKind::kFell && contact.event.object == id;
          });
      return has_fallen ? Say("failures.fell", {{"object", id}}) : UserMessage();
    });
  }

  std::optional<FailureReason> StillHeld() const {
    return OfFirst("still_held", [this](const scene::ObjectSpec& object) {
      return comparison_.errors.at(object.id()).is_held
                 ? Say("failures.isHeld", {{"object", IdOf(object)}})
                 : UserMessage();
    });
  }

  std::optional<FailureReason> NeverTaken() const {
    return OfFirst("never_taken", [this](const scene::ObjectSpec& object) {
      const std::string& id = IdOf(object);
      const double displacement = (end_.at(id).translation() - start_.at(id).translation()).norm();
      return displacement < kWhereItBegan ? Say("failures.neverTaken", {{"object", id}})
                                          : UserMessage();
    });
  }

  std::optional<FailureReason> Toppled() const {
    return OfFirst("toppled", [this](const scene::ObjectSpec& object) {
      const RigidTransform& X_WGoal = comparison_.goal.at(object.id());
      const RigidTransform& X_WB = end_.at(IdOf(object));
      // An object below its goal fell from what it should stand on, even if it landed upright.
      const double below = X_WGoal.translation().z() - X_WB.translation().z();
      if (below > kTolerance) {
        return Say("failures.lower", {{"object", IdOf(object)}, {"distance", Millimeters(below)}});
      }
      const double tilt = SymmetryOf(object).TiltBetween(X_WGoal.rotation(), X_WB.rotation());
      return tilt > kAngleTolerance
                 ? Say("failures.tilted", {{"object", IdOf(object)}, {"angle", Degrees(tilt)}})
                 : UserMessage();
    });
  }

  std::optional<FailureReason> Apart() const {
    return OfFirst("apart", [this](const scene::ObjectSpec& object) -> UserMessage {
      const ObjectError& error = comparison_.errors.at(object.id());
      if (!error.is_apart || !error.is_pose_within()) return {};
      const auto pair =
          std::ranges::find_if(comparison_.neighbors, [&object](const NeighborError& neighbor) {
            return neighbor.pair.object == object.id() && !neighbor.is_within();
          });
      return Say("failures.apart", {{"object", IdOf(object)},
                                    {"distance", Millimeters(pair->distance)},
                                    {"other", comparison_.match.at(pair->pair.other)},
                                    {"angle", Degrees(pair->angle)}});
    });
  }

  std::optional<FailureReason> Misplaced() const {
    return OfFirst("misplaced", [this](const scene::ObjectSpec& object) -> UserMessage {
      const ObjectError& error = comparison_.errors.at(object.id());
      if (error.distance > kNear || error.is_pose_within()) return {};
      return Say("failures.misplaced", {{"object", IdOf(object)},
                                        {"distance", Millimeters(error.distance)},
                                        {"angle", Degrees(error.angle)}});
    });
  }

  std::optional<FailureReason> NotPlaced() const {
    return OfFirst("not_placed", [this](const scene::ObjectSpec& object) -> UserMessage {
      const ObjectError& error = comparison_.errors.at(object.id());
      if (error.is_pose_within()) return {};
      return Say("failures.notPlaced",
                 {{"object", IdOf(object)}, {"distance", Millimeters(error.distance)}});
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
      UserMessage text = text_of(*object);
      if (!text.empty()) return FailureReason{code, std::move(text)};
    }
    return std::nullopt;
  }

  static double Millimeters(double length) { return std::round(1000 * length); }
  static double Degrees(double angle) { return std::round(RadiansToDegrees(angle)); }

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
    const UserMessage effect = WordsOf(structure.effects[i], outcome.scene.meters_per_unit);
    return FailureReason{"effect_missing", Say("failures.notAchieved", {{"effect", effect}})};
  }
  return std::nullopt;
}

bool HasFailed(const ProgramEnd& program) { return program.status == "failed"; }

}  // namespace

Json ToJson(const std::optional<FailureReason>& reason) {
  if (!reason) return nullptr;
  Json json = {{"word", reason->code}, {"text", reason->text}};
  texts::AddMessage(reason->text, &json);
  return json;
}

std::optional<FailureReason> FailureReasonIn(const JsonNode& node) {
  if (node.IsNull()) return std::nullopt;
  return FailureReason{
      .code = node.Member("word").ShortString(kMaxCodeBytes),
      .text = texts::MessageBeside(node.Member("text").ShortString(kMaxTextBytes), node.value())};
}

bool IsSuccess(const StructureComparison& comparison, const ProgramEnd& program) {
  return comparison.is_achieved() && program.status == "exited";
}

std::optional<FailureReason> FailureReasonOf(const Structure& structure, const Episode& outcome,
                                             const StructureComparison& comparison,
                                             const ProgramEnd& program) {
  if (IsSuccess(comparison, program)) return std::nullopt;
  if (HasFailed(program)) {
    return FailureReason{"brain_failed", Say("failures.brainFailed", {{"why", program.message}})};
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
    return FailureReason{"time_up", Say("failures.timeUp")};
  }
  if (const auto reason = analysis.StillHeld()) return reason;
  if (const auto reason = analysis.NeverTaken()) return reason;
  if (const auto reason = analysis.Toppled()) return reason;
  if (const auto reason = analysis.Misplaced()) return reason;
  if (const auto reason = analysis.NotPlaced()) return reason;
  if (const auto reason = analysis.Apart()) return reason;
  if (!comparison.intruders.empty()) {
    return FailureReason{"intruder",
                         Say("failures.intruder", {{"object", comparison.intruders.front()}})};
  }
  return ReasonOfMissingEffect(structure, outcome, comparison);
}

}  // namespace smile::task
