#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "task/match.h"
#include "task/object_error.h"
#include "task/order.h"
#include "task/rules.h"

namespace smile::task {

/// Comparison of an outcome with a demonstrated structure, wherever on the table it was built.
struct StructureComparison {
  Match match;       ///< of the structure's objects, and of others that its effects refer to
  ObjectPoses goal;  ///< poses of the structure in this scene, by demo id
  std::map<std::string, ObjectError> errors;  ///< by demo id
  std::vector<NeighborError> neighbors;       ///< in the order of Structure::neighbors
  /// Scene ids of objects that do not belong to the structure and touch it, see IntrudersOf().
  std::vector<std::string> intruders;
  /// Turn of the structure against the demonstration [rad]; nullopt if something determines its
  /// place, or each of its parts has its own.
  std::optional<double> turn;
  /// The structure as a whole looks like the mirror image of the demonstrated one, seen from the
  /// same side: a half-turn of blocks that are their own mirror images.
  bool is_mirrored = false;
  Order order;
  std::vector<RuleBreak> broken_rules;
  std::vector<bool> achieved;  ///< for each effect
  /// Fraction of objects within tolerance and effects achieved, of all these, the intruders and the
  /// broken rules.
  double score = 0;

  bool is_achieved() const { return score == 1; }
  std::size_t num_faults() const { return intruders.size() + broken_rules.size(); }
  ObjectError mean_error() const;  ///< over all objects; 0 without any
};

/// Returns the fraction of objects within tolerance and effects achieved, of all these and the
/// faults: each object, each effect and each fault has the same weight.
/// @param num_faults  intruders and broken rules.
double ScoreOf(const std::map<std::string, ObjectError>& errors, const std::vector<bool>& achieved,
               std::size_t num_faults);

/// Compares up to a motion of the whole structure on the table, a shift along x and y and a turn
/// about z, and up to an exchange of objects that look alike. Motion and match are chosen together
/// so that as many objects as possible are within tolerance, then with least errors among these.
/// What stands on a fixed object stands where this is in the scene; of several fixed objects, each
/// determines the place of what it carries. A landmark stays where it was when the outcome began
/// (Structure::anchor).
StructureComparison CompareWith(const Structure& structure, const Episode& outcome);

/// The part of CompareWith() that depends on poses only: `match`, `goal`, `errors`, `neighbors` and
/// `turn`; the others stay empty.
/// @param match  as from MatchObjects().
/// @param held   ids of the outcome's scene that a hand or a gripper holds.
StructureComparison ComparePoses(const Structure& structure, const Episode& outcome, Match match,
                                 const std::set<std::string>& held);

}  // namespace smile::task
