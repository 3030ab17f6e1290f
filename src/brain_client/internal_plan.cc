#include "brain_client/internal_plan.h"

#include <cmath>
#include <stdexcept>

#include "brain_client/internal_lines.h"

namespace smile::brain_client {
namespace {

/// Returns the index of a subtask, which messages count from 1.
std::size_t IndexOf(double number, const char* field, std::size_t num_subtasks) {
  if (!(number >= 1) || number > static_cast<double>(num_subtasks) ||
      number != std::floor(number)) {
    throw std::invalid_argument(std::string(field) + " contains " + std::to_string(number) +
                                ", expected the number of one of " + std::to_string(num_subtasks) +
                                " subtasks");
  }
  return static_cast<std::size_t>(number) - 1;
}

/// Returns a matrix of this size.
Eigen::MatrixXd SizedMatrix(const Fields& init, const char* field, Eigen::Index rows,
                            Eigen::Index columns) {
  Eigen::MatrixXd matrix = init.Matrix(field);
  if (matrix.rows() != rows || matrix.cols() != columns) {
    throw std::invalid_argument(std::string(field) + " is " + std::to_string(matrix.rows()) + "x" +
                                std::to_string(matrix.cols()) + ", expected " +
                                std::to_string(rows) + "x" + std::to_string(columns));
  }
  return matrix;
}

std::vector<PlanSubtask> SubtasksOf(const Fields& init) {
  const std::vector<std::string> words = LinesOf(init.Text("planWords"));
  const std::vector<std::string> objects = LinesOf(init.Text("planObjects"));
  const auto count = static_cast<Eigen::Index>(words.size());
  if (objects.size() != words.size()) {
    throw std::invalid_argument("planObjects has " + std::to_string(objects.size()) +
                                " lines, expected " + std::to_string(words.size()));
  }
  const Eigen::MatrixXd segments = SizedMatrix(init, "planSegments", count, 2);
  const Eigen::MatrixXd necessary = SizedMatrix(init, "planNecessary", 1, count);
  std::vector<PlanSubtask> subtasks;
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    subtasks.push_back({.words = words[k],
                        .objects = {},
                        .first_segment = static_cast<int>(segments(i, 0)),
                        .last_segment = static_cast<int>(segments(i, 1)),
                        .is_necessary = necessary(0, i) != 0});
    if (!objects[k].empty()) subtasks.back().objects = SplitAt(',', objects[k]);
  }
  return subtasks;
}

}  // namespace

std::optional<Plan> PlanOf(const Fields& init) {
  if (!init.Has("planWords")) return std::nullopt;
  Plan plan{.subtasks = SubtasksOf(init)};
  const std::size_t count = plan.subtasks.size();
  const Eigen::MatrixXd order = init.Matrix("planOrder");
  for (Eigen::Index i = 0; i < order.rows(); ++i) {
    plan.order.emplace_back(IndexOf(order(i, 0), "planOrder", count),
                            IndexOf(order(i, 1), "planOrder", count));
  }
  const Eigen::MatrixXd sufficient = init.Matrix("planSufficient");
  for (Eigen::Index i = 0; i < sufficient.cols(); ++i) {
    plan.sufficient.push_back(IndexOf(sufficient(0, i), "planSufficient", count));
  }
  const std::string goals = init.Text("planGoals");
  if (!goals.empty()) plan.goals = LinesOf(goals);
  return plan;
}

}  // namespace smile::brain_client
