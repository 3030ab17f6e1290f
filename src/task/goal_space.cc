#include "task/goal_space.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "model/relations.h"
#include "task/neighbors.h"

namespace smile::task {
namespace {

/// Distance at which an object is neither near nor far [m].
constexpr double kHalfway = 0.1;

using recording::TracePose;

void Append(const TracePose& pose, bool is_released, std::vector<double>* goal) {
  goal->insert(goal->end(), pose.position.begin(), pose.position.end());
  goal->insert(goal->end(), pose.rotation.begin(), pose.rotation.end());
  goal->push_back(is_released ? 1 : 0);
}

std::size_t IndexOf(const scene::SceneSpec& scene, const std::string& id) {
  const auto object = std::ranges::find(scene.objects, id, &scene::ObjectSpec::id);
  return static_cast<std::size_t>(object - scene.objects.begin());
}

}  // namespace

std::vector<std::string> GoalSpace::Names(double meters_per_unit) const {
  std::vector<std::string> names;
  for (const scene::ObjectSpec& object : structure_.objects) {
    for (const char* name : {"x", "y", "z", "qw", "qx", "qy", "qz", "released"}) {
      names.push_back(object.id() + "." + name);
    }
  }
  for (const Effect& effect : structure_.effects) names.push_back(WordsOf(effect, meters_per_unit));
  names.emplace_back("faults");
  return names;
}

std::vector<double> GoalSpace::Desired(const Episode& at_begin) const {
  ObjectPoses poses;
  if (!structure_.is_free() || PartsOf(structure_).size() > 1) {
    poses = CompareWith(structure_, AtBegin(at_begin)).goal;
  }
  std::vector<double> goal;
  for (const scene::ObjectSpec& object : structure_.objects) {
    const auto pose = poses.find(object.id());
    const RigidTransform& X_WB = pose != poses.end() ? pose->second : object.pose_in_world();
    Append(TracePose::At(X_WB, /*is_awake=*/false), /*is_released=*/true, &goal);
  }
  goal.resize(size() - 1, 1);
  goal.push_back(0);
  return goal;
}

std::vector<double> GoalSpace::Achieved(const Episode& outcome) const {
  const StructureComparison comparison = CompareWith(structure_, outcome);
  std::vector<double> goal;
  for (const scene::ObjectSpec& object : structure_.objects) {
    const std::size_t index = IndexOf(outcome.scene, comparison.match.at(object.id()));
    const TracePose& now = outcome.end.objects[index];
    // Absent objects have their initial poses, see PosesAt().
    Append(
        now.is_present ? now : TracePose::At(outcome.scene.objects[index].pose_in_world(), false),
        !comparison.errors.at(object.id()).is_held, &goal);
  }
  for (const bool is_achieved : comparison.achieved) goal.push_back(is_achieved ? 1 : 0);
  goal.push_back(static_cast<double>(comparison.num_faults()));
  return goal;
}

GoalComparer::GoalComparer(const GoalSpace* space)
    : space_(*space), structure_(space->structure()) {
  outcome_.scene.objects = structure_.objects;
  outcome_.begin.objects.resize(structure_.objects.size());
  outcome_.end = outcome_.begin;
  // All that is not a pose is in the goals.
  structure_.effects.clear();
  structure_.others.clear();
  structure_.fallen.clear();
  structure_.bystanders.clear();
  structure_.support_rules.clear();
}

void GoalComparer::Read(const char* name, std::span<const double> goal,
                        std::vector<TracePose>* poses) const {
  if (goal.size() != space_.size()) {
    throw std::invalid_argument(std::string(name) + " has " + std::to_string(goal.size()) +
                                " numbers, expected " + std::to_string(space_.size()));
  }
  const auto fault = std::ranges::find_if(goal, [](double v) { return !std::isfinite(v); });
  if (fault != goal.end()) {
    throw std::invalid_argument(std::string(name) + "[" + std::to_string(fault - goal.begin()) +
                                "] is not finite, expected a finite number");
  }
  for (std::size_t i = 0; i < poses->size(); ++i) {
    const double* v = goal.data() + GoalSpace::kNumbersPerObject * i;
    TracePose& pose = (*poses)[i];
    pose.position = {v[0], v[1], v[2]};
    pose.rotation = {v[3], v[4], v[5], v[6]};
    // Those of a simulation stay as they are, to the last bit; learners may have rounded others.
    constexpr double kRounding = 1e-9, kLeastNorm = 1e-3;
    const double norm = pose.rotation.norm();
    if (norm < kLeastNorm) {
      throw std::invalid_argument(std::string(name) + " has a quaternion of length " +
                                  std::to_string(norm) + ", expected 1");
    }
    if (std::abs(norm - 1) > kRounding) pose.rotation /= norm;
  }
}

void GoalComparer::SetDesired(std::span<const double> desired) {
  if (std::ranges::equal(desired, desired_)) return;
  desired_.clear();  // nothing is kept of a goal that is refused
  Read("desired_goal", desired, &outcome_.begin.objects);
  for (std::size_t i = 0; i < structure_.objects.size(); ++i) {
    structure_.objects[i].whole.X_PE = outcome_.begin.objects[i].pose_in_world();
  }
  structure_.neighbors = NeighborsOf(structure_);
  relations_ = model::RelationsOf(outcome_.scene, structure_.objects);
  desired_.assign(desired.begin(), desired.end());
}

double GoalComparer::HeldRelations(const Match& match, const std::set<std::string>& held) const {
  if (relations_.empty()) return 1;
  const std::vector<Relation> now =
      model::RelationsOf(outcome_.scene, ObjectsAt(outcome_.scene, outcome_.end));
  const auto holds = [&](const Relation& wanted) {
    const Relation here{
        .object = match.at(wanted.object),
        .kind = wanted.kind,
        .support = wanted.support.empty() ? std::string() : match.at(wanted.support)};
    return !held.contains(here.object) && std::ranges::find(now, here) != now.end();
  };
  return static_cast<double>(std::ranges::count_if(relations_, holds)) /
         static_cast<double>(relations_.size());
}

GoalScore GoalComparer::Compare(std::span<const double> achieved, std::span<const double> desired) {
  SetDesired(desired);
  Read("achieved_goal", achieved, &outcome_.end.objects);
  Match match;
  std::set<std::string> held;
  for (std::size_t i = 0; i < structure_.objects.size(); ++i) {
    const std::string& id = structure_.objects[i].id();
    match[id] = id;
    // What is to be held, as in a goal that was achieved by the way, may be held.
    const std::size_t released = GoalSpace::kNumbersPerObject * (i + 1) - 1;
    if (achieved[released] < desired[released]) held.insert(id);
  }
  const StructureComparison comparison = ComparePoses(structure_, outcome_, std::move(match), held);
  std::vector<bool> effects;
  for (std::size_t i = GoalSpace::kNumbersPerObject * structure_.objects.size();
       i + 1 < space_.size(); ++i) {
    effects.push_back(achieved[i] >= desired[i]);
  }
  const double faults = std::clamp(achieved.back() - desired.back(), 0.0, 1e6);
  GoalScore result{
      .score = ScoreOf(comparison.errors, effects, static_cast<std::size_t>(std::llround(faults))),
      .relations = HeldRelations(comparison.match, held),
      .closeness = comparison.errors.empty() ? 1.0 : 0.0};
  for (const auto& [id, error] : comparison.errors) {
    result.closeness +=
        (1 - std::tanh(error.distance / kHalfway)) / static_cast<double>(comparison.errors.size());
  }
  return result;
}

}  // namespace smile::task
