#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "base/state_hash.h"
#include "mechanics/ids.h"

namespace smile::mechanics {

/// Two bodies, the smaller id first.
using BodyPair = std::pair<BodyId, BodyId>;

inline BodyPair PairOf(BodyId a, BodyId b) { return std::minmax(a, b); }

/// Set of pairs of bodies, in ascending order.
class BodyPairs {
 public:
  BodyPairs() = default;
  explicit BodyPairs(std::vector<BodyPair> sorted) : pairs_(std::move(sorted)) {}

  bool empty() const { return pairs_.empty(); }
  bool Contains(const BodyPair& pair) const {
    return std::binary_search(pairs_.begin(), pairs_.end(), pair);
  }
  void Add(const BodyPair& pair) {
    const auto place = std::lower_bound(pairs_.begin(), pairs_.end(), pair);
    if (place == pairs_.end() || *place != pair) pairs_.insert(place, pair);
  }
  void Remove(const BodyPair& pair) { std::erase(pairs_, pair); }
  /// Removes the pairs for which `is_over` is true, asked in their order.
  template <class IsOver>
  void RemoveIf(IsOver is_over) {
    std::erase_if(pairs_, is_over);
  }
  void clear() { pairs_.clear(); }

  const std::vector<BodyPair>& sorted() const { return pairs_; }
  void AddTo(StateHash* hash) const {
    for (const auto& [a, b] : pairs_) {
      hash->Add(std::uint64_t{a.value});
      hash->Add(std::uint64_t{b.value});
    }
  }

 private:
  std::vector<BodyPair> pairs_;
};

}  // namespace smile::mechanics
