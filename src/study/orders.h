#pragma once

#include <cstddef>
#include <vector>

namespace smile::study {

/// Returns the number of rows of the balanced Latin square of `n` items: n if it is even, else 2 n.
std::size_t NumOrders(std::size_t n);

/// Returns a row of a balanced Latin square: in all rows together, each item is equally often at
/// each position, and each item follows each other one equally often. Source: E. J. Williams,
/// "Experimental designs balanced for the estimation of residual effects of treatments", Australian
/// Journal of Scientific Research A 2 (1949). For an odd number of items, the square and its mirror
/// image together are balanced.
/// @param n    at least 1.
/// @param row  from 0 on; continues with the first row after the last one.
/// @returns the numbers 0 to n - 1.
std::vector<std::size_t> BalancedOrder(std::size_t n, std::size_t row);

}  // namespace smile::study
