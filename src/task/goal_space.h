#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "task/comparison.h"

namespace smile::task {

/// Goals of a task as lists of numbers, for learners that compare what they achieved with goals of
/// their choice.
///
/// The numbers are, for each object of the structure, the pose of its counterpart in the world (x,
/// y, z [m]; quaternion w, x, y, z) and 1 if nothing holds it, else 0; for each effect 1 if it is
/// achieved, else 0; and the number of faults, which are intruders and broken rules.
class GoalSpace {
 public:
  explicit GoalSpace(Structure structure) : structure_(std::move(structure)) {}

  const Structure& structure() const { return structure_; }
  /// Count of the numbers.
  std::size_t size() const {
    return kNumbersPerObject * structure_.objects.size() + structure_.effects.size() + 1;
  }
  /// Returns names of the numbers, `RedBlock.x` or `Lamp from dark to blue` for example.
  std::vector<std::string> Names(double meters_per_unit) const;

  /// Returns the goal of an episode: the structure where it was demonstrated, if it may stand
  /// anywhere; else where it belongs in the episode's scene.
  std::vector<double> Desired(const Episode& at_begin) const;
  /// Returns what an episode has achieved by its end.
  std::vector<double> Achieved(const Episode& outcome) const;

  static constexpr std::size_t kNumbersPerObject = 8;

 private:
  Structure structure_;
};

/// Comparison of an achieved goal with a desired one. Each is 1 if all is as desired.
struct GoalScore {
  double score = 0;  ///< as StructureComparison::score
  /// Fraction of the relations among the desired objects, as "on" and "in", that hold of released
  /// objects.
  double relations = 0;
  double closeness = 0;  ///< mean over the objects of 1 - tanh(distance / 0.1 m)

  bool is_achieved() const { return score == 1; }
  bool operator==(const GoalScore&) const = default;
};

/// Compares goals of a space as CompareWith() compares an outcome with the structure: up to a
/// motion on the table if the structure may stand anywhere, and up to an exchange of objects that
/// look alike. The result depends on nothing but the two goals.
class GoalComparer {
 public:
  /// @param space  must outlive this.
  explicit GoalComparer(const GoalSpace* space);

  /// @throws std::invalid_argument if one has the wrong size, or a number that is not finite or not
  ///         of a quaternion.
  GoalScore Compare(std::span<const double> achieved, std::span<const double> desired);

 private:
  /// Checks a goal and sets the poses of objects to its.
  void Read(const char* name, std::span<const double> goal,
            std::vector<recording::TracePose>* poses) const;
  void SetDesired(std::span<const double> desired);
  /// Returns the fraction of the desired relations that hold.
  double HeldRelations(const Match& match, const std::set<std::string>& held) const;

  const GoalSpace& space_;
  std::vector<double> desired_;  ///< the last one
  Structure structure_;          ///< as desired, without effects
  std::vector<Relation> relations_;
  Episode outcome_;  ///< of a scene with the structure's objects only
};

}  // namespace smile::task
