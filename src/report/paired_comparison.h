#pragma once

#include <cstddef>
#include <span>

#include "report/statistics.h"

namespace smile::report {

// Comparison of the times of two programs on a machine that others use, too.
//
// The programs run in turns, and what counts are the ratios of neighbors in time: a disturbance
// that lasts slows both. If the programs are equally fast and the first of each pair alternates, a
// ratio is as likely above 1 as below, whatever the distribution of the times. So an interval
// between two of the sorted ratios contains their median with a probability that follows from the
// binomial distribution alone (the inverted sign test: W. J. Conover, "Practical Nonparametric
// Statistics" (1999), section 3.2).

/// One round: the time of each program, in any unit.
struct TimePair {
  double baseline = 0, current = 0;

  bool operator==(const TimePair&) const = default;
};

enum class SpeedDifference { kWithinNoise, kSlower, kFaster };

struct PairedComparison {
  double baseline = 0, current = 0;  ///< the shortest times
  double ratio = 1;                  ///< median of current / baseline
  Interval interval;                 ///< of this median
  SpeedDifference difference = SpeedDifference::kWithinNoise;

  bool operator==(const PairedComparison&) const = default;
};

/// Probability that the median ratio of infinitely many rounds lies below the interval; the same
/// above it.
inline constexpr double kTailProbability = 0.01;
/// Number of rounds from which on there is an interval: with fewer, even the largest ratio is
/// exceeded too often.
inline constexpr std::size_t kMinRounds = 7;
/// Smallest relative difference that counts. Less than this changes with the place of a program's
/// code in memory. Source: T. Mytkowicz et al., "Producing wrong data without doing anything
/// obviously wrong!", ASPLOS (2009).
inline constexpr double kSmallestDifference = 0.02;

/// Compares two programs. They differ if the interval excludes 1, the median ratio differs from 1
/// by at least kSmallestDifference, and the shortest times differ in the same direction.
/// @param rounds  at least kMinRounds, with positive times.
PairedComparison ComparePairs(std::span<const TimePair> rounds);

/// Compares two programs by all rounds, of which the later ones were added because the earlier ones
/// showed a difference. They differ only if each of the two groups by itself shows the same
/// difference: among many benchmarks some look different by chance, but hardly twice.
/// @param earlier, later  as for ComparePairs().
PairedComparison ConfirmDifference(std::span<const TimePair> earlier,
                                   std::span<const TimePair> later);

}  // namespace smile::report
