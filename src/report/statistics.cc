#include "report/statistics.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace smile::report {
namespace {

// Of two-sided intervals of 95 %: the 97.5 % quantile of the normal distribution.
constexpr double kNormalQuantile = 1.959963984540054;
constexpr double kConfidence = 0.95;
constexpr std::size_t kManyDegrees = 100'000;  ///< t and normal then agree to five digits

/// Returns the probability that |T| is at most `t`. Source: Abramowitz and Stegun, "Handbook of
/// Mathematical Functions", 26.7.3 and 26.7.4: finite series for whole degrees of freedom.
double StudentWithin(double t, std::size_t degrees_of_freedom) {
  const auto nu = static_cast<double>(degrees_of_freedom);
  const double theta = std::atan(t / std::sqrt(nu));
  const double cosine = std::cos(theta);
  const bool is_odd = degrees_of_freedom % 2 == 1;
  double sum = 0, term = is_odd ? cosine : 1;
  // Terms of cos^k, each by its ratio to the one before.
  for (std::size_t k = is_odd ? 1 : 0; k + 2 <= degrees_of_freedom; k += 2) {
    sum += term;
    const auto order = static_cast<double>(k);
    term *= cosine * cosine * (order + 1) / (order + 2);
  }
  const double series = std::sin(theta) * sum;
  return is_odd ? 2 / std::numbers::pi * (theta + series) : series;
}

}  // namespace

Interval WilsonInterval(std::size_t successes, std::size_t runs) {
  const auto n = static_cast<double>(runs);
  const double rate = static_cast<double>(successes) / n;
  // Source: Wilson, "Probable inference, the law of succession, and statistical inference", 1927.
  const double z2 = kNormalQuantile * kNormalQuantile;
  // Center and half width of the score interval; at the ends, rounding must not leave [0, 1].
  const double middle = (rate + z2 / (2 * n)) / (1 + z2 / n);
  const double half =
      kNormalQuantile / (1 + z2 / n) * std::sqrt(rate * (1 - rate) / n + z2 / (4 * n * n));
  return {.low = successes == 0 ? 0 : middle - half, .high = successes == runs ? 1 : middle + half};
}

double StudentQuantile(std::size_t degrees_of_freedom) {
  if (degrees_of_freedom >= kManyDegrees) return kNormalQuantile;
  double low = 0, high = 20;  // the quantile is 12.7 for one degree of freedom, and less for more
  // Bisection: the probability increases with t.
  while (high - low > 1e-12 * high) {
    const double middle = (low + high) / 2;
    (StudentWithin(middle, degrees_of_freedom) < kConfidence ? low : high) = middle;
  }
  return high;
}

std::optional<Mean> MeanOf(std::span<const double> numbers) {
  if (numbers.empty()) return std::nullopt;
  const auto n = static_cast<double>(numbers.size());
  double sum = 0, squares = 0;
  for (double number : numbers) sum += number;
  Mean mean{.value = sum / n, .count = numbers.size()};
  if (numbers.size() == 1) return mean;
  // In a second pass: the difference of two large sums would lose digits.
  for (double number : numbers) squares += (number - mean.value) * (number - mean.value);
  // Standard error of the mean, with the unbiased estimate of the variance.
  const double half = StudentQuantile(numbers.size() - 1) * std::sqrt(squares / (n - 1) / n);
  mean.interval = {.low = mean.value - half, .high = mean.value + half};
  return mean;
}

std::optional<double> Quantile(std::span<const double> numbers, double fraction) {
  if (numbers.empty()) return std::nullopt;
  std::vector<double> sorted(numbers.begin(), numbers.end());
  std::ranges::sort(sorted);
  // Linear interpolation between the neighbors in sorted order (type 7 of Hyndman and Fan, 1996).
  const double place = fraction * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

double ExactMcNemar(std::size_t only_a, std::size_t only_b) {
  const auto n = static_cast<double>(only_a + only_b);
  double tail = 0;  // of the binomial distribution with equal chances
  for (std::size_t k = 0; k <= std::min(only_a, only_b); ++k) {
    // Binomial coefficients by logarithms, which do not overflow.
    const auto heads = static_cast<double>(k);
    tail += std::exp(std::lgamma(n + 1) - std::lgamma(heads + 1) - std::lgamma(n - heads + 1) -
                     n * std::numbers::ln2);
  }
  // Two-sided. With equal counts the middle is in both tails, and twice the tail exceeds 1.
  return std::min(1.0, 2 * tail);
}

}  // namespace smile::report
