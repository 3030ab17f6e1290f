#include "task/match.h"

#include "base/diagnostic.h"
#include "task/assignment.h"

namespace smile::task {
namespace {

constexpr double kUnlike = 1e9;

double CostOf(const scene::ObjectSpec& wanted, const scene::SceneSpec& scene, std::size_t index,
              const Structure& structure) {
  const scene::ObjectSpec& object = scene.objects[index];
  if (!AreAlike(wanted, object, structure.AttendedOf(wanted.id()))) return kUnlike;
  const double late = static_cast<double>(index) / static_cast<double>(scene.objects.size());
  return object.id() == wanted.id() ? 0 : 1 + late / 1000;
}

}  // namespace

Match MatchObjects(const Structure& structure, const scene::SceneSpec& scene) {
  std::vector<scene::ObjectSpec> wanted = structure.objects;
  wanted.insert(wanted.end(), structure.others.begin(), structure.others.end());
  // Where the scene has too few objects, some are left without.
  const std::size_t columns = std::max(wanted.size(), scene.objects.size());
  Eigen::MatrixXd costs = Eigen::MatrixXd::Constant(static_cast<Eigen::Index>(wanted.size()),
                                                    static_cast<Eigen::Index>(columns), kUnlike);
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    for (std::size_t j = 0; j < scene.objects.size(); ++j) {
      costs(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
          CostOf(wanted[i], scene, j, structure);
    }
  }
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
           "has nothing that looks like '" + wanted[i].id() + "' of the demonstration"});
    }
  }
  if (!findings.empty()) throw InputError(std::move(findings));
  return match;
}

}  // namespace smile::task
