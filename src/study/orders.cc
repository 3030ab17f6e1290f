#include "study/orders.h"

#include <algorithm>

namespace smile::study {

std::size_t NumOrders(std::size_t n) { return n % 2 == 0 || n == 1 ? n : 2 * n; }

std::vector<std::size_t> BalancedOrder(std::size_t n, std::size_t row) {
  row %= NumOrders(n);
  std::vector<std::size_t> order;
  // The first row is 0, 1, n-1, 2, n-2, …: its differences are all different. Each further row adds
  // one to all items.
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t first = k % 2 == 1 ? (k + 1) / 2 : (n - k / 2) % n;
    order.push_back((first + row) % n);
  }
  if (row >= n) std::ranges::reverse(order);
  return order;
}

}  // namespace smile::study
