#include "report/paired_comparison.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace smile::report {
namespace {

using Rounds = std::vector<TimePair>;

/// Returns rounds in which the baseline takes 10 and the current program 10 times each ratio.
Rounds RoundsOf(const std::vector<double>& ratios) {
  Rounds rounds;
  for (const double ratio : ratios) rounds.push_back({10, 10 * ratio});
  return rounds;
}

// Sums of binomial coefficients, by hand: at most 1 of 11 is (1 + 11) / 2^11 = 0.6 %, at most 1 of
// 10 is 1.1 %; 14 rounds are the first that may leave out two, (1 + 14 + 91) / 2^14 = 0.6 %.
TEST(PairedComparison, TheIntervalLeavesOutAsManyRoundsAsTheBinomialDistributionAllows) {
  for (const auto& [num_rounds, num_outside] :
       {std::pair(7, 0), {10, 0}, {11, 1}, {13, 1}, {14, 2}}) {
    std::vector<double> ratios;
    for (int i = 0; i < num_rounds; ++i) ratios.push_back(1 + 0.01 * i);
    const Interval interval = ComparePairs(RoundsOf(ratios)).interval;
    EXPECT_DOUBLE_EQ(interval.low, 1 + 0.01 * num_outside) << num_rounds;
    EXPECT_DOUBLE_EQ(interval.high, 1 + 0.01 * (num_rounds - 1 - num_outside)) << num_rounds;
  }
}

TEST(PairedComparison, IsSlowerOnlyIfEachOfSevenRoundsIs) {
  const PairedComparison slower =
      ComparePairs(RoundsOf({1.04, 1.05, 1.06, 1.03, 1.30, 1.05, 1.05}));
  EXPECT_EQ(slower.difference, SpeedDifference::kSlower);
  EXPECT_DOUBLE_EQ(slower.ratio, 1.05);
  EXPECT_DOUBLE_EQ(slower.current, 10.3);
  EXPECT_EQ(ComparePairs(RoundsOf({1.04, 1.05, 1.06, 0.99, 1.30, 1.05, 1.05})).difference,
            SpeedDifference::kWithinNoise);
  EXPECT_EQ(ComparePairs(RoundsOf({0.9, 0.9, 0.8, 0.9, 0.9, 0.97, 0.9})).difference,
            SpeedDifference::kFaster);
}

TEST(PairedComparison, TwoPercentCountAndLessDoesNot) {
  EXPECT_EQ(ComparePairs(RoundsOf(std::vector(20, 1.019))).difference,
            SpeedDifference::kWithinNoise);
  EXPECT_EQ(ComparePairs(RoundsOf(std::vector(20, 1.021))).difference, SpeedDifference::kSlower);
  EXPECT_EQ(ComparePairs(RoundsOf(std::vector(20, 1 / 1.019))).difference,
            SpeedDifference::kWithinNoise);
  EXPECT_EQ(ComparePairs(RoundsOf(std::vector(20, 1 / 1.021))).difference,
            SpeedDifference::kFaster);
}

// The machine is three times as slow for a while: both programs are, and the ratios stay.
TEST(PairedComparison, ADisturbanceOfBothProgramsHidesNoDifference) {
  Rounds rounds = RoundsOf(std::vector(8, 1.05));
  for (std::size_t i = 2; i < 6; ++i) rounds[i] = {3 * rounds[i].baseline, 3 * rounds[i].current};
  EXPECT_EQ(ComparePairs(rounds).difference, SpeedDifference::kSlower);
}

// Of eleven rounds one may be an exception, but not the one with the shortest time.
TEST(PairedComparison, TheShortestTimesMustAgree) {
  Rounds rounds = RoundsOf(std::vector(11, 1.05));
  rounds[4] = {12, 11};
  EXPECT_EQ(ComparePairs(rounds).difference, SpeedDifference::kSlower);
  rounds[4] = {12, 9};
  EXPECT_EQ(ComparePairs(rounds).difference, SpeedDifference::kWithinNoise);
}

TEST(PairedComparison, ADifferenceMustShowTwice) {
  const Rounds slower = RoundsOf(std::vector(7, 1.05)), equal = RoundsOf(std::vector(7, 1.0)),
               faster = RoundsOf(std::vector(7, 0.9));
  EXPECT_EQ(ConfirmDifference(slower, slower).difference, SpeedDifference::kSlower);
  EXPECT_EQ(ConfirmDifference(slower, equal).difference, SpeedDifference::kWithinNoise);
  EXPECT_EQ(ConfirmDifference(slower, faster).difference, SpeedDifference::kWithinNoise);
  EXPECT_EQ(ConfirmDifference(faster, faster).difference, SpeedDifference::kFaster);
  EXPECT_DOUBLE_EQ(ConfirmDifference(slower, equal).ratio, 1.025);
}

// A simulated machine: every time is lengthened by a share with a long tail, independently. Of
// 2,000 comparisons of a program with itself at most 2 % show a difference at first, and none a
// second time; a program slower by 10 % is found nearly always.
TEST(PairedComparison, EqualProgramsSeldomDifferAndSlowerOnesNearlyAlwaysDo) {
  std::mt19937_64 random(1);
  const auto noisy_rounds = [&](double ratio) {
    const auto noise = [&] {
      const double u = static_cast<double>(random() % 1'000'000 + 1) / 1e6;
      return 1 - 0.02 * std::log(u);
    };
    Rounds rounds(8);
    for (TimePair& round : rounds) round = {noise(), ratio * noise()};
    return rounds;
  };
  int num_alarms = 0, num_confirmed = 0, num_found = 0;
  for (int i = 0; i < 2'000; ++i) {
    const Rounds equal = noisy_rounds(1), slower = noisy_rounds(1.1);
    const SpeedDifference alarm = ComparePairs(equal).difference;
    if (alarm != SpeedDifference::kWithinNoise) {
      ++num_alarms;
      const SpeedDifference second = ConfirmDifference(equal, noisy_rounds(1)).difference;
      if (second != SpeedDifference::kWithinNoise) ++num_confirmed;
    }
    if (ComparePairs(slower).difference == SpeedDifference::kSlower) ++num_found;
  }
  EXPECT_LE(num_alarms, 40);
  EXPECT_EQ(num_confirmed, 0);
  EXPECT_GE(num_found, 1'900);
}

}  // namespace
}  // namespace smile::report
