#pragma once

#include <set>
#include <string>
#include <vector>

namespace smile::task {

/// In what order things were put in their places, beside how it was shown; by the ids of the
/// demonstration.
struct Order {
  std::vector<std::string> demonstrated, done;
  /// Of all pairs of what was shown to be put, those that were put in the order shown, 0 to 1; 1
  /// where there are no two.
  double share = 1;

  bool is_kept() const { return share == 1; }
  bool operator==(const Order&) const = default;
};

/// @param in_place  what was already where it belongs, and needed not be put: it counts as put
///                  before all others.
Order OrderOf(std::vector<std::string> demonstrated, std::vector<std::string> done,
              const std::set<std::string>& in_place);

}  // namespace smile::task
