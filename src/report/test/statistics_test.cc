#include "report/statistics.h"

#include <gtest/gtest.h>

#include <vector>

namespace smile::report {
namespace {

// R. G. Newcombe, "Two-sided confidence intervals for the single proportion", Statistics in
// Medicine 17 (1998), table I, method 3: four examples to four digits.
TEST(Statistics, IntervalsOfRatesAreThoseThatNewcombePrinted) {
  const struct {
    std::size_t successes, runs;
    double low, high;
  } printed[] = {{81, 263, 0.2553, 0.3662},
                 {15, 148, 0.0624, 0.1605},
                 {0, 20, 0, 0.1611},
                 {1, 29, 0.0061, 0.1718}};
  for (const auto& [successes, runs, low, high] : printed) {
    const Interval interval = WilsonInterval(successes, runs);
    EXPECT_NEAR(interval.low, low, 5e-5) << successes << " of " << runs;
    EXPECT_NEAR(interval.high, high, 5e-5) << successes << " of " << runs;
    const Interval mirrored = WilsonInterval(runs - successes, runs);
    EXPECT_NEAR(mirrored.low, 1 - interval.high, 1e-12);
    EXPECT_NEAR(mirrored.high, 1 - interval.low, 1e-12);
  }
}

// The table of Student's t at the back of any textbook, two-sided 5 %.
TEST(Statistics, StudentsQuantilesAreThoseOfTheTables) {
  const std::pair<std::size_t, double> table[] = {{1, 12.706}, {2, 4.303},   {3, 3.182},
                                                  {4, 2.776},  {9, 2.262},   {10, 2.228},
                                                  {29, 2.045}, {120, 1.980}, {1'000'000, 1.960}};
  for (const auto& [degrees, t] : table) EXPECT_NEAR(StudentQuantile(degrees), t, 5e-4) << degrees;
  EXPECT_NEAR(StudentQuantile(99'999), StudentQuantile(100'000), 1e-4);
}

// Student's own example: the additional hours of sleep gained by ten patients, difference of two
// drugs ("The probable error of a mean", Biometrika 6, 1908); the mean is 1.58 with a standard
// error of 0.389, so its interval is 0.70 to 2.46.
TEST(Statistics, TheMeanOfStudentsSleepersHasItsInterval) {
  const std::vector<double> hours{1.2, 2.4, 1.3, 1.3, 0.0, 1.0, 1.8, 0.8, 4.6, 1.4};
  const std::optional<Mean> mean = MeanOf(hours);
  ASSERT_TRUE(mean && mean->interval);
  EXPECT_EQ(mean->count, 10u);
  EXPECT_NEAR(mean->value, 1.58, 1e-12);
  EXPECT_NEAR(mean->interval->low, 0.7001, 1e-4);
  EXPECT_NEAR(mean->interval->high, 2.4599, 1e-4);
}

TEST(Statistics, OneNumberHasNoIntervalAndZeroNumbersHaveNoMean) {
  const std::vector<double> one{3};
  EXPECT_EQ(MeanOf(one), (Mean{.value = 3, .count = 1}));
  EXPECT_EQ(MeanOf({}), std::nullopt);
  EXPECT_EQ(Quantile({}, 0.5), std::nullopt);
  EXPECT_EQ(Quantile(one, 0.95), 3);
}

// What R prints for quantile(c(7, 15, 36, 39, 40, 41), c(0, .25, .5, .95, 1)).
TEST(Statistics, QuantilesLieBetweenNumbersInProportion) {
  const std::vector<double> numbers{40, 7, 41, 15, 39, 36};
  const std::pair<double, double> printed[] = {
      {0, 7}, {0.25, 20.25}, {0.5, 37.5}, {0.95, 40.75}, {1, 41}};
  for (const auto& [share, number] : printed) {
    EXPECT_NEAR(Quantile(numbers, share).value_or(-1), number, 1e-12) << share;
  }
}

// Sums of binomial coefficients, by hand: 2 (1 + 10) / 2^10; 2 (1 + 12 + 66) / 2^12.
TEST(Statistics, PairsThatDifferAreWeighedExactly) {
  EXPECT_NEAR(ExactMcNemar(1, 9), 22.0 / 1024, 1e-12);
  EXPECT_NEAR(ExactMcNemar(9, 1), 22.0 / 1024, 1e-12);
  EXPECT_NEAR(ExactMcNemar(2, 10), 158.0 / 4096, 1e-12);
  EXPECT_NEAR(ExactMcNemar(0, 1), 1, 1e-12);
  EXPECT_EQ(ExactMcNemar(0, 0), 1);
  EXPECT_EQ(ExactMcNemar(5, 5), 1);
  EXPECT_LT(ExactMcNemar(0, 5000), 1e-300);
  EXPECT_NEAR(ExactMcNemar(5000, 5000), 1, 1e-9);
}

}  // namespace
}  // namespace smile::report
