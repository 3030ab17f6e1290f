#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace smile::report {

// Statistics of repeated runs. Every interval is a two-sided 95 % confidence interval: of a hundred
// such intervals, about ninety-five contain the value that infinitely many runs would give.

struct Interval {
  double low = 0, high = 0;

  bool operator==(const Interval&) const = default;
};

/// Returns Wilson's score interval of a rate, from `successes` in `runs`. It stays within 0 and 1
/// and is valid for few runs and for rates near the ends. Source: E. B. Wilson, "Probable
/// inference, the law of succession, and statistical inference", Journal of the American
/// Statistical Association 22 (1927).
/// @param runs  at least 1.
Interval WilsonInterval(std::size_t successes, std::size_t runs);

/// Returns the t for which Student's distribution lies within -t and t with a probability of 95 %.
/// @param degrees_of_freedom  at least 1; from 100,000 on, that of the normal distribution.
double StudentQuantile(std::size_t degrees_of_freedom);

struct Mean {
  double value = 0;
  std::size_t count = 0;             ///< of numbers
  std::optional<Interval> interval;  ///< Student's t; nullopt for a single number

  bool operator==(const Mean&) const = default;
};
/// Returns mean and interval; nullopt without numbers.
std::optional<Mean> MeanOf(std::span<const double> numbers);

/// Returns the quantile below which a given fraction of the numbers lies, interpolated linearly
/// (Hyndman and Fan's type 7, as in R and numpy); nullopt without numbers.
/// @param fraction  0 to 1.
std::optional<double> Quantile(std::span<const double> numbers, double fraction);

/// Returns the p-value of McNemar's exact test: the probability that two equally good programs
/// differ at least this much, by a sign test of the pairs in which only one of them succeeded.
/// @param only_a, only_b  numbers of these pairs.
double ExactMcNemar(std::size_t only_a, std::size_t only_b);

}  // namespace smile::report
