#include "mechanics/joint_order.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace smile::mechanics {
namespace {

/// Sorts joints from `low` to `high` by their islands (C. A. R. Hoare, Quicksort, 1962): equal ones
/// change places, too.
void SortByIsland(std::span<const JointOrder::Entry> all, int low, int high,
                  std::vector<int>* joints) {
  std::vector<int>& sorted = *joints;
  const auto island_at = [&](int place) { return all[sorted[place]].island; };
  int i = low, j = high;
  const int pivot = island_at((low + high) / 2);
  do {
    while (island_at(i) < pivot) ++i;
    while (pivot < island_at(j)) --j;
    if (i <= j) std::swap(sorted[i++], sorted[j--]);
  } while (i <= j);
  if (low < j) SortByIsland(all, low, j, joints);
  if (i < high) SortByIsland(all, i, high, joints);
}

}  // namespace

std::vector<int> JointOrder::PlacesOf(std::span<const Entry> present) const {
  std::vector<Entry> all(present.begin(), present.end());
  for (const auto& [joint, island] : left_out_) all.push_back({joint, island});
  std::ranges::sort(all, {}, &Entry::joint);
  std::vector<int> sorted(all.size()), places;
  std::iota(sorted.begin(), sorted.end(), 0);
  const int count = static_cast<int>(all.size());
  if (count > 1) SortByIsland(all, 0, count - 1, &sorted);
  std::vector<int> place_of(all.size());
  for (int place = 0; place < count; ++place) place_of[sorted[place]] = place;
  for (const Entry& entry : present) {
    const auto found = std::ranges::lower_bound(all, entry.joint, {}, &Entry::joint);
    places.push_back(place_of[static_cast<std::size_t>(found - all.begin())]);
  }
  return places;
}

}  // namespace smile::mechanics
