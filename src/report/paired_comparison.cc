#include "report/paired_comparison.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/demand.h"

namespace smile::report {
namespace {

/// Returns the number of ratios that may lie outside the interval on each side: the largest k for
/// which at most k of the rounds fall on one side of the median with kTailProbability.
std::size_t NumOutside(std::size_t num_rounds) {
  double term = std::pow(0.5, static_cast<double>(num_rounds));  // exactly k rounds
  double sum = term;                                             // at most k rounds
  std::size_t k = 0;
  while (true) {
    term *= static_cast<double>(num_rounds - k) / static_cast<double>(k + 1);
    if (sum + term > kTailProbability) return k;
    sum += term;
    ++k;
  }
}

SpeedDifference DifferenceOf(const PairedComparison& comparison) {
  if (comparison.interval.low > 1 && comparison.ratio >= 1 + kSmallestDifference &&
      comparison.current > comparison.baseline)
    return SpeedDifference::kSlower;
  if (comparison.interval.high < 1 && comparison.ratio <= 1 / (1 + kSmallestDifference) &&
      comparison.current < comparison.baseline)
    return SpeedDifference::kFaster;
  return SpeedDifference::kWithinNoise;
}

}  // namespace

PairedComparison ComparePairs(std::span<const TimePair> rounds) {
  SMILE_DEMAND(rounds.size() >= kMinRounds);
  PairedComparison comparison{rounds[0].baseline, rounds[0].current};
  std::vector<double> ratios;
  for (const TimePair& round : rounds) {
    comparison.baseline = std::min(comparison.baseline, round.baseline);
    comparison.current = std::min(comparison.current, round.current);
    ratios.push_back(round.current / round.baseline);
  }
  std::sort(ratios.begin(), ratios.end());
  const std::size_t num_outside = NumOutside(ratios.size());
  comparison.ratio = Quantile(ratios, 0.5).value();
  comparison.interval = {ratios[num_outside], ratios[ratios.size() - 1 - num_outside]};
  comparison.difference = DifferenceOf(comparison);
  return comparison;
}

PairedComparison ConfirmDifference(std::span<const TimePair> earlier,
                                   std::span<const TimePair> later) {
  std::vector<TimePair> all(earlier.begin(), earlier.end());
  all.insert(all.end(), later.begin(), later.end());
  PairedComparison comparison = ComparePairs(all);
  comparison.difference = ComparePairs(earlier).difference;
  if (ComparePairs(later).difference != comparison.difference)
    comparison.difference = SpeedDifference::kWithinNoise;
  return comparison;
}

}  // namespace smile::report
