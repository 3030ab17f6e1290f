#pragma once

#include <map>
#include <utility>

namespace smile::mechanics {

/// Pairs of objects that do not collide, each for one or several reasons. A pair collides again
/// when the last of them ends.
class ExcludedPairs {
 public:
  void Exclude(int a, int b) { ++counts_[Ordered(a, b)]; }
  /// Takes one Exclude() back.
  void Include(int a, int b) {
    const auto pair = counts_.find(Ordered(a, b));
    if (pair != counts_.end() && --pair->second == 0) counts_.erase(pair);
  }
  bool Contains(int a, int b) const { return !counts_.empty() && counts_.contains(Ordered(a, b)); }

 private:
  static std::pair<int, int> Ordered(int a, int b) { return std::minmax(a, b); }

  std::map<std::pair<int, int>, int> counts_;  ///< number of reasons per pair
};

}  // namespace smile::mechanics
