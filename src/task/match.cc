#include "task/match.h"

#include "base/diagnostic.h"
#include "task/assignment.h"

namespace smile::task {
namespace {

/// Cost of a pair that does not look alike: more than all alike pairs together, so that as many
/// objects as possible get a counterpart.
constexpr double kUnlike = 1e9;

/// Prefers the object of the same id, then the first one in scene order.
/// @param lateness  position in scene order, from 0 to less than 1. Divided by 1000, all of them
///                  together weigh less than one equal id.
double CostOfPart(bool is_alike, bool has_same_id, double lateness) {
  if (!is_alike) return kUnlike;
  return has_same_id ? 0 : 1 + lateness / 1000;
}

std::vector<Appearance> AppearancesOfAll(const std::vector<scene::ObjectSpec>& objects) {
  std::vector<Appearance> appearances;
  for (const scene::ObjectSpec& object : objects) appearances.push_back(AppearanceOf(object));
  return appearances;
}

}  // namespace

Match MatchObjects(const Structure& structure, const scene::SceneSpec& scene) {
  std::vector<scene::ObjectSpec> wanted = structure.objects;
  wanted.insert(wanted.end(), structure.others.begin(), structure.others.end());
  // If the scene has too few objects, extra columns of cost kUnlike keep the problem solvable; the
  // objects assigned to them have no counterpart.
  const std::size_t columns = std::max(wanted.size(), scene.objects.size());
  Eigen::MatrixXd costs = Eigen::MatrixXd::Constant(static_cast<Eigen::Index>(wanted.size()),
                                                    static_cast<Eigen::Index>(columns), kUnlike);
  const std::vector<Appearance> appearances = AppearancesOfAll(scene.objects);
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const Appearance wanted_appearance = AppearanceOf(wanted[i]);
    const std::vector<std::string> properties = structure.AttendedOf(wanted[i].id());
    for (std::size_t j = 0; j < scene.objects.size(); ++j) {
      costs(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
          CostOfPart(AreAlike(wanted_appearance, appearances[j], properties),
                     wanted[i].id() == scene.objects[j].id(),
                     static_cast<double>(j) / static_cast<double>(appearances.size()));
    }
  }
  // A global optimum is necessary: with attention to different properties, sets of candidates can
  // overlap in part, and a greedy choice could take the only counterpart of another object.
  const std::vector<std::size_t> assigned = CheapestAssignment(costs);
  Match match;
  std::vector<Diagnostic> findings;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const std::size_t j = assigned[i];
    if (costs(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) < kUnlike) {
      match[wanted[i].id()] = scene.objects[j].id();
    } else {
      findings.push_back(
          {scene.name, 0, "",
           "has no object that looks like '" + wanted[i].id() + "' of the demonstration"});
    }
  }
  if (!findings.empty()) throw InputError(std::move(findings));
  return match;
}

}  // namespace smile::task
