#pragma once

#include <set>
#include <string>
#include <vector>

namespace smile::task {

/// Order of placements, demonstrated and done, by the ids of the demonstration.
struct Order {
  std::vector<std::string> demonstrated, done;
  /// Fraction of the pairs of demonstrated placements that were done in the same order, 0 to 1; 1
  /// with fewer than two placements.
  double fraction = 1;

  bool is_kept() const { return fraction == 1; }
  bool operator==(const Order&) const = default;
};

/// @param in_place  objects that were at their goals already and needed no placement; they count as
///                  placed before all others.
Order OrderOf(std::vector<std::string> demonstrated, std::vector<std::string> done,
              const std::set<std::string>& in_place);

}  // namespace smile::task
