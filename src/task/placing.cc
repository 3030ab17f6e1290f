#include "task/placing.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "task/assignment.h"
#include "task/symmetry.h"
#include "task/table_motion.h"

namespace smile::task {
namespace {

// Cost of an object. Within tolerance: the sum of its errors, in tolerances (0 to 2). Outside: more
// than the errors of all other objects together, so that the number of objects within tolerance
// decides first; plus a small term by which nearer objects are better. Pairs that do not look alike
// are never chosen while there is an alternative.
constexpr double kOutside = 1e6, kPerMeterOutside = 1e-3, kMostMeters = 10;
constexpr double kUnlikely = 1e12;

/// Maximal number of objects that suggest motions. Those with the fewest candidates come first, as
/// they suggest the fewest wrong ones.
constexpr std::size_t kMaxAnchors = 24;
/// Limit of work, in steps of inner loops (less than a second in total); then the best placing so
/// far is good enough. Counting steps and not time keeps the result deterministic.
constexpr double kMaxWork = 1e8;

/// Object of the outcome's scene that may be a counterpart.
struct Candidate {
  const scene::ObjectSpec* object = nullptr;
  RigidTransform X_WB;       ///< at the end
  RigidTransform X_WBStart;  ///< at the begin
  Appearance appearance;
};

/// Object of the structure, with the indices of its candidates in the pool.
struct Wanted {
  const scene::ObjectSpec* object = nullptr;
  RigidTransform X_WA;
  Symmetry symmetry;
  std::vector<std::size_t> candidates;
  std::vector<bool> are_of_its_form;  ///< same form as the candidate, so angles compare
};

/// Searches for the motion on the table (x, y, yaw) and the match with the least total cost. One or
/// two corresponding objects determine a motion: the search tries the motions that follow from each
/// hypothesis "this object is that candidate", evaluates each with an optimal assignment, and
/// refines the best one by least squares.
class PlacingSearch {
 public:
  PlacingSearch(const Structure& structure, const Episode& outcome, const Match& match)
      : structure_(structure), others_(OthersOf(structure, match)) {
    const ObjectPoses at_begin = PosesAt(outcome.scene, outcome.begin);
    const ObjectPoses at_end = PosesAt(outcome.scene, outcome.end);
    // Objects that only effects refer to keep their counterparts; these are not available to
    // others.
    for (const scene::ObjectSpec& object : outcome.scene.objects) {
      const bool is_taken = std::ranges::any_of(
          others_, [&](const auto& other) { return other.second == object.id(); });
      if (is_taken) continue;
      pool_.push_back(
          {&object, at_end.at(object.id()), at_begin.at(object.id()), AppearanceOf(object)});
    }
    for (const scene::ObjectSpec& object : structure.objects) AddWanted(object, structure);
    // The identity is always a hypothesis: the structure stands where it was demonstrated.
    Consider({});
  }

  Placing Find() {
    if (structure_.is_fixed()) {
      SearchFixed();
    } else if (structure_.anchor == Anchor::kLandmark) {
      SearchAtLandmark();
    } else if (structure_.anchor == Anchor::kNone) {
      SearchFree();
      Refine();
    }
    Placing placing{.motion = best_.transform(),
                    .turn = std::remainder(best_.angle, 2 * std::numbers::pi),
                    .match = others_};
    for (std::size_t i = 0; i < wanted_.size(); ++i) {
      placing.match[wanted_[i].object->id()] = pool_[best_choice_[i]].object->id();
    }
    return placing;
  }

 private:
  static Match OthersOf(const Structure& structure, const Match& match) {
    Match others;
    for (const scene::ObjectSpec& other : structure.others) {
      others[other.id()] = match.at(other.id());
    }
    return others;
  }

  /// Adds an object of the structure with the candidates that look alike.
  void AddWanted(const scene::ObjectSpec& object, const Structure& structure) {
    Wanted wanted{.object = &object,
                  .X_WA = object.pose_in_world(),
                  .symmetry = SymmetryOf(object),
                  .candidates = {},
                  .are_of_its_form = {}};
    const Appearance appearance = AppearanceOf(object);
    const std::vector<std::string> properties = structure.AttendedOf(object.id());
    for (std::size_t i = 0; i < pool_.size(); ++i) {
      if (!AreAlike(appearance, pool_[i].appearance, properties)) continue;
      wanted.candidates.push_back(i);
      wanted.are_of_its_form.push_back(appearance.form == pool_[i].appearance.form);
    }
    wanted_.push_back(std::move(wanted));
  }

  /// Returns the cost of an object if the candidate number `which` is its counterpart and X_WGoal
  /// its goal.
  double CostOf(const Wanted& wanted, std::size_t which, const RigidTransform& X_WGoal) const {
    const Candidate& candidate = pool_[wanted.candidates[which]];
    const double distance = (X_WGoal.translation() - candidate.X_WB.translation()).norm();
    if (distance <= kTolerance) {
      const double angle =
          wanted.are_of_its_form[which]
              ? wanted.symmetry.AngleBetween(X_WGoal.rotation(), candidate.X_WB.rotation())
              : 0;
      if (angle <= kAngleTolerance) return distance / kTolerance + angle / kAngleTolerance;
    }
    return kOutside + kPerMeterOutside * std::min(distance, kMostMeters);
  }

  /// Evaluates a motion and keeps it if it is better than the best one so far. On equal cost the
  /// earlier one stays, so the order of the hypotheses makes the result deterministic.
  void Consider(const TableMotion& motion) {
    const auto rows = static_cast<Eigen::Index>(wanted_.size());
    Eigen::MatrixXd costs =
        Eigen::MatrixXd::Constant(rows, static_cast<Eigen::Index>(pool_.size()), kUnlikely);
    double least = 0;
    const RigidTransform X = motion.transform();
    for (Eigen::Index i = 0; i < rows; ++i) {
      const Wanted& wanted = wanted_[static_cast<std::size_t>(i)];
      const RigidTransform X_WGoal = X * wanted.X_WA;
      double nearest = kUnlikely;
      for (std::size_t which = 0; which < wanted.candidates.size(); ++which) {
        const double cost = CostOf(wanted, which, X_WGoal);
        costs(i, static_cast<Eigen::Index>(wanted.candidates[which])) = cost;
        nearest = std::min(nearest, cost);
      }
      least += nearest;
      work_ += static_cast<double>(pool_.size());
    }
    // Lower bound: each object has its nearest candidate, even if several share one. It spares most
    // of the assignments, which are the expensive step.
    if (!best_choice_.empty() && least >= best_cost_) return;
    const std::vector<std::size_t> choice = CheapestAssignment(costs);
    work_ += static_cast<double>(rows * rows * costs.cols());
    double cost = 0;
    for (Eigen::Index i = 0; i < rows; ++i) {
      cost += costs(i, static_cast<Eigen::Index>(choice[static_cast<std::size_t>(i)]));
    }
    if (!best_choice_.empty() && cost >= best_cost_) return;
    best_ = motion;
    best_cost_ = cost;
    best_choice_ = choice;
  }

  bool IsTired() const { return work_ > kMaxWork; }

  /// Considers only motions that carry fixed objects onto fixed candidates: the structure cannot
  /// stand elsewhere.
  void SearchFixed() {
    best_choice_.clear();
    for (const Wanted& one : wanted_) {
      if (one.object->is_static()) ConsiderTurnsAbout(one, /*is_fixed=*/true);
    }
    // A choice is needed for the result even if nothing matches.
    if (best_choice_.empty()) Consider({});
  }

  /// Considers only motions that carry the landmark to where a counterpart was at the begin: a
  /// robot that moves the landmark instead has not done the task.
  void SearchAtLandmark() {
    best_choice_.clear();
    const auto landmark = std::ranges::find_if(
        wanted_, [&](const Wanted& one) { return one.object->id() == structure_.landmark; });
    for (std::size_t j : landmark->candidates) {
      const Vector3& from = landmark->X_WA.translation();
      const Vector3& to = pool_[j].X_WBStart.translation();
      const std::vector<double> yaws =
          landmark->symmetry.YawsBetween(landmark->X_WA.rotation(), pool_[j].X_WBStart.rotation());
      for (double yaw : yaws) Consider(MotionTo(yaw, from, to));
      if (!yaws.empty()) continue;
      // A round landmark has no direction: that to each of the other objects is a hypothesis.
      Consider(MotionTo(0, from, to));
      for (const Wanted& other : wanted_) ConsiderDirectionsTo(other, *landmark, j);
    }
    if (best_choice_.empty()) Consider({});
  }

  /// Considers the motions that carry the landmark to a candidate's start, and another object to
  /// the direction in which one of its candidates is from there.
  void ConsiderDirectionsTo(const Wanted& other, const Wanted& landmark, std::size_t at) {
    const Vector3& from = landmark.X_WA.translation();
    const Vector3& to = pool_[at].X_WBStart.translation();
    const Eigen::Vector2d shown = (other.X_WA.translation() - from).head<2>();
    if (&other == &landmark || shown.norm() < kTolerance) return;
    for (std::size_t k : other.candidates) {
      const Eigen::Vector2d here = (pool_[k].X_WB.translation() - to).head<2>();
      if (k == at || here.norm() < kTolerance) continue;
      if (IsTired()) return;
      Consider(
          MotionTo(std::atan2(here.y(), here.x()) - std::atan2(shown.y(), shown.x()), from, to));
    }
  }

  /// Considers motions from single objects and their orientations first, then from pairs of
  /// objects.
  void SearchFree() {
    const std::vector<const Wanted*> anchors = Anchors();
    for (const Wanted* one : anchors) ConsiderTurnsAbout(*one, /*is_fixed=*/false);
    for (const Wanted* one : anchors) {
      for (const Wanted* other : anchors) {
        if (one != other) ConsiderPairs(*one, *other);
      }
    }
  }

  /// Returns the objects that suggest motions. Stable sorting keeps the scene order among equals.
  std::vector<const Wanted*> Anchors() const {
    std::vector<const Wanted*> anchors;
    for (const Wanted& wanted : wanted_) anchors.push_back(&wanted);
    std::ranges::stable_sort(anchors, {},
                             [](const Wanted* wanted) { return wanted->candidates.size(); });
    if (anchors.size() > kMaxAnchors) anchors.resize(kMaxAnchors);
    return anchors;
  }

  /// A motion on the table keeps heights: a candidate at another height cannot be within tolerance.
  static bool MayBeThere(const Wanted& wanted, const Candidate& candidate) {
    return std::abs(wanted.X_WA.translation().z() - candidate.X_WB.translation().z()) <= kTolerance;
  }

  /// Considers the motions that carry an object exactly onto a candidate, position and yaw.
  void ConsiderTurnsAbout(const Wanted& one, bool is_fixed) {
    for (std::size_t j : one.candidates) {
      if (!is_fixed && !MayBeThere(one, pool_[j])) continue;
      const Vector3& from = one.X_WA.translation();
      const Vector3& to = pool_[j].X_WB.translation();
      const std::vector<double> yaws =
          one.symmetry.YawsBetween(one.X_WA.rotation(), pool_[j].X_WB.rotation());
      // Every yaw is possible (a sphere, an upright cylinder) or the two do not stand alike: the
      // position alone is the hypothesis.
      if (yaws.empty()) Consider(MotionTo(0, from, to));
      for (double yaw : yaws) {
        if (IsTired()) return;
        Consider(MotionTo(yaw, from, to));
      }
    }
  }

  /// Considers the motions that two objects determine: the first one's position, and the direction
  /// from the first to the second. The longer the baseline, the more exact is the yaw, compared
  /// with that of a single orientation.
  void ConsiderPairs(const Wanted& one, const Wanted& other) {
    const Eigen::Vector2d a = (other.X_WA.translation() - one.X_WA.translation()).head<2>();
    if (a.norm() < kTolerance) return;
    for (std::size_t j : one.candidates) {
      if (!MayBeThere(one, pool_[j])) continue;
      for (std::size_t k : other.candidates) {
        if (j == k || !MayBeThere(other, pool_[k])) continue;
        const Eigen::Vector2d b =
            (pool_[k].X_WB.translation() - pool_[j].X_WB.translation()).head<2>();
        // A motion keeps distances: each object may be off by the tolerance, hence twice that.
        if (std::abs(a.norm() - b.norm()) > 2 * kTolerance || b.norm() < kTolerance) continue;
        if (IsTired()) return;
        Consider(MotionTo(std::atan2(b.y(), b.x()) - std::atan2(a.y(), a.x()),
                          one.X_WA.translation(), pool_[j].X_WB.translation()));
      }
    }
  }

  /// Fits the motion to all objects within tolerance, since one or two objects carry their own
  /// placement errors into it. Kept only if it is better.
  void Refine() {
    std::vector<PointPair> pairs;
    for (std::size_t i = 0; i < wanted_.size(); ++i) {
      const Candidate& candidate = pool_[best_choice_[i]];
      const RigidTransform X_WGoal = best_.transform() * wanted_[i].X_WA;
      if (ErrorOf(*wanted_[i].object, X_WGoal, *candidate.object, candidate.X_WB).is_within()) {
        pairs.push_back({wanted_[i].X_WA.translation(), candidate.X_WB.translation()});
      }
    }
    if (!pairs.empty()) Consider(FitMotion(pairs, best_.angle));
  }

  const Structure& structure_;
  Match others_;
  std::vector<Candidate> pool_;
  std::vector<Wanted> wanted_;
  TableMotion best_;
  double best_cost_ = 0;
  std::vector<std::size_t> best_choice_;  ///< of pool_, for each of wanted_; empty before the first
  double work_ = 0;
};

}  // namespace

Placing FindPlacing(const Structure& structure, const Episode& outcome, const Match& match) {
  if (structure.objects.empty()) return {.match = match};
  return PlacingSearch(structure, outcome, match).Find();
}

ObjectError ErrorOf(const scene::ObjectSpec& wanted, const RigidTransform& X_WGoal,
                    const scene::ObjectSpec& counterpart, const RigidTransform& X_WB) {
  ObjectError error{.distance = (X_WGoal.translation() - X_WB.translation()).norm()};
  if (AppearanceOf(wanted).form == AppearanceOf(counterpart).form) {
    error.angle = SymmetryOf(wanted).AngleBetween(X_WGoal.rotation(), X_WB.rotation());
  }
  return error;
}

}  // namespace smile::task
