#include "task/placing.h"

#include <algorithm>
#include <cmath>

#include "task/assignment.h"
#include "task/symmetry.h"
#include "task/table_motion.h"

namespace smile::task {
namespace {

// What an object costs: within tolerance the sum of its errors, in tolerances. What is not weighs
// more than all others together can; among those, near ones are better.
constexpr double kOutside = 1e6, kPerMeterOutside = 1e-3, kMostMeters = 10;
constexpr double kUnlikely = 1e12;

/// As many objects suggest motions, those with the fewest look-alikes first.
constexpr std::size_t kMaxAnchors = 24;
/// Steps of work after which the best placing so far is good enough: less than a second.
constexpr double kMaxWork = 1e8;

/// An object that may play a part.
struct Candidate {
  const scene::ObjectSpec* object = nullptr;
  RigidTransform X_WB;
  Looks looks;
};

/// An object of the structure, and who may play its part.
struct Wanted {
  const scene::ObjectSpec* object = nullptr;
  RigidTransform X_WA;
  Symmetry symmetry;
  std::vector<std::size_t> candidates;
  std::vector<bool> are_of_its_form;  ///< of these: only then is an angle between them
};

class PlacingSearch {
 public:
  PlacingSearch(const Structure& structure, const scene::SceneSpec& scene,
                const ObjectPoses& outcome, const Match& match)
      : others_(OthersOf(structure, match)) {
    for (const scene::ObjectSpec& object : scene.objects) {
      const bool is_taken = std::ranges::any_of(
          others_, [&](const auto& other) { return other.second == object.id(); });
      if (!is_taken) pool_.push_back({&object, outcome.at(object.id()), LooksOf(object)});
    }
    for (const scene::ObjectSpec& object : structure.objects) AddWanted(object, structure);
    Consider({});
  }

  Placing Find(bool is_fixed) {
    if (is_fixed) {
      SearchFixed();
    } else {
      SearchFree();
      Refine();
    }
    Placing placing{.motion = best_.transform(), .match = others_};
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

  void AddWanted(const scene::ObjectSpec& object, const Structure& structure) {
    Wanted wanted{.object = &object,
                  .X_WA = object.pose_in_world(),
                  .symmetry = SymmetryOf(object),
                  .candidates = {},
                  .are_of_its_form = {}};
    const Looks looks = LooksOf(object);
    const std::vector<std::string> properties = structure.AttendedOf(object.id());
    for (std::size_t i = 0; i < pool_.size(); ++i) {
      if (!AreAlike(looks, pool_[i].looks, properties)) continue;
      wanted.candidates.push_back(i);
      wanted.are_of_its_form.push_back(looks.form == pool_[i].looks.form);
    }
    wanted_.push_back(std::move(wanted));
  }

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

  /// Takes the motion if it is better than the best so far.
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
    // Even if all could have their nearest ones it would be no better.
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

  /// Where the fixed objects are, there is the structure.
  void SearchFixed() {
    best_choice_.clear();
    for (const Wanted& one : wanted_) {
      if (one.object->is_static()) ConsiderTurnsAbout(one, /*is_fixed=*/true);
    }
    if (best_choice_.empty()) Consider({});
  }

  void SearchFree() {
    const std::vector<const Wanted*> anchors = Anchors();
    for (const Wanted* one : anchors) ConsiderTurnsAbout(*one, /*is_fixed=*/false);
    for (const Wanted* one : anchors) {
      for (const Wanted* other : anchors) {
        if (one != other) ConsiderPairs(*one, *other);
      }
    }
  }

  std::vector<const Wanted*> Anchors() const {
    std::vector<const Wanted*> anchors;
    for (const Wanted& wanted : wanted_) anchors.push_back(&wanted);
    std::ranges::stable_sort(anchors, {},
                             [](const Wanted* wanted) { return wanted->candidates.size(); });
    if (anchors.size() > kMaxAnchors) anchors.resize(kMaxAnchors);
    return anchors;
  }

  /// An object that is where it should be is as high as it should be: heights are not shifted.
  static bool MayBeThere(const Wanted& wanted, const Candidate& candidate) {
    return std::abs(wanted.X_WA.translation().z() - candidate.X_WB.translation().z()) <= kTolerance;
  }

  void ConsiderTurnsAbout(const Wanted& one, bool is_fixed) {
    for (std::size_t j : one.candidates) {
      if (!is_fixed && !MayBeThere(one, pool_[j])) continue;
      const Vector3& from = one.X_WA.translation();
      const Vector3& to = pool_[j].X_WB.translation();
      const std::vector<double> yaws =
          one.symmetry.YawsBetween(one.X_WA.rotation(), pool_[j].X_WB.rotation());
      if (yaws.empty()) Consider(MotionTo(0, from, to));
      for (double yaw : yaws) {
        if (IsTired()) return;
        Consider(MotionTo(yaw, from, to));
      }
    }
  }

  /// Two objects that stand apart tell the turn by where they are, which is more exact.
  void ConsiderPairs(const Wanted& one, const Wanted& other) {
    const Eigen::Vector2d a = (other.X_WA.translation() - one.X_WA.translation()).head<2>();
    if (a.norm() < kTolerance) return;
    for (std::size_t j : one.candidates) {
      if (!MayBeThere(one, pool_[j])) continue;
      for (std::size_t k : other.candidates) {
        if (j == k || !MayBeThere(other, pool_[k])) continue;
        const Eigen::Vector2d b =
            (pool_[k].X_WB.translation() - pool_[j].X_WB.translation()).head<2>();
        if (std::abs(a.norm() - b.norm()) > 2 * kTolerance || b.norm() < kTolerance) continue;
        if (IsTired()) return;
        Consider(MotionTo(std::atan2(b.y(), b.x()) - std::atan2(a.y(), a.x()),
                          one.X_WA.translation(), pool_[j].X_WB.translation()));
      }
    }
  }

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

  Match others_;
  std::vector<Candidate> pool_;
  std::vector<Wanted> wanted_;
  TableMotion best_;
  double best_cost_ = 0;
  std::vector<std::size_t> best_choice_;  ///< of pool_, for each of wanted_; empty before the first
  double work_ = 0;
};

}  // namespace

Placing FindPlacing(const Structure& structure, const scene::SceneSpec& scene,
                    const ObjectPoses& outcome, const Match& match) {
  if (structure.objects.empty()) return {.motion = {}, .match = match};
  return PlacingSearch(structure, scene, outcome, match).Find(structure.is_fixed());
}

ObjectError ErrorOf(const scene::ObjectSpec& wanted, const RigidTransform& X_WGoal,
                    const scene::ObjectSpec& counterpart, const RigidTransform& X_WB) {
  ObjectError error{.distance = (X_WGoal.translation() - X_WB.translation()).norm()};
  if (LooksOf(wanted).form == LooksOf(counterpart).form) {
    error.angle = SymmetryOf(wanted).AngleBetween(X_WGoal.rotation(), X_WB.rotation());
  }
  return error;
}

}  // namespace smile::task
