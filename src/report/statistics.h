#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace smile::report {

// What numbers of repeated runs say. Every interval is the usual two-sided one of 95 %: of a
// hundred such intervals, about ninety-five hold what an endless number of runs would give.

struct Interval {
  double low = 0, high = 0;

  bool operator==(const Interval&) const = default;
};

/// Of a rate, from `successes` in `runs`: Wilson's score interval, which stays within 0 and 1 and
/// is sound for few runs and for rates near the ends.
/// Source: E. B. Wilson, "Probable inference, the law of succession, and statistical inference",
/// Journal of the American Statistical Association 22 (1927).
/// @param runs  at least 1.
Interval WilsonInterval(std::size_t successes, std::size_t runs);

/// The t for which Student's distribution lies within -t and t with a probability of 95 %.
/// @param degrees_of_freedom  at least 1; from 100,000 on, that of the normal distribution.
double StudentQuantile(std::size_t degrees_of_freedom);

struct Mean {
  double value = 0;
  std::size_t count = 0;             ///< of numbers
  std::optional<Interval> interval;  ///< Student's t; nullopt of a single number

  bool operator==(const Mean&) const = default;
};
/// nullopt of no numbers.
std::optional<Mean> MeanOf(std::span<const double> numbers);

/// The number below which a share of the others lies, between two of them in proportion (Hyndman
/// and Fan's type 7, as R and numpy have it); nullopt of no numbers.
/// @param share  0 to 1.
std::optional<double> Quantile(std::span<const double> numbers, double share);

/// How probable it is that two that are equally good differ at least as much as this: McNemar's
/// test in its exact form, a sign test of the pairs in which just one of them succeeded.
/// @param only_a, only_b  how many those are.
double ExactMcNemar(std::size_t only_a, std::size_t only_b);

}  // namespace smile::report
