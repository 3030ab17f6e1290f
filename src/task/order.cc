#include "task/order.h"

#include <algorithm>
#include <optional>

namespace smile::task {

Order OrderOf(std::vector<std::string> demonstrated, std::vector<std::string> done,
              const std::set<std::string>& in_place) {
  // Returns the rank of a placement, -1 for objects that were in place already, and nullopt for
  // objects that were never placed.
  const auto when = [&](const std::string& id) -> std::optional<std::ptrdiff_t> {
    const auto put = std::ranges::find(done, id);
    if (put != done.end()) return put - done.begin();
    return in_place.contains(id) ? std::optional<std::ptrdiff_t>(-1) : std::nullopt;
  };
  // Fraction of concordant pairs, as in Kendall's rank correlation. A pair with a missing placement
  // counts as not kept.
  int num_pairs = 0, num_kept = 0;
  for (std::size_t later = 0; later < demonstrated.size(); ++later) {
    for (std::size_t earlier = 0; earlier < later; ++earlier) {
      const auto first = when(demonstrated[earlier]), second = when(demonstrated[later]);
      ++num_pairs;
      if (first && second && *first <= *second) ++num_kept;
    }
  }
  const double fraction = num_pairs == 0 ? 1 : static_cast<double>(num_kept) / num_pairs;
  return {.demonstrated = std::move(demonstrated), .done = std::move(done), .fraction = fraction};
}

}  // namespace smile::task
