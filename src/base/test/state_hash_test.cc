#include "base/state_hash.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace smile {
namespace {

template <class... Values>
std::uint64_t HashOf(const Values&... values) {
  StateHash hash;
  (hash.Add(values), ...);
  return hash.value();
}

TEST(StateHash, DependsOnTheLastBitAndTheOrder) {
  EXPECT_EQ(HashOf(1.0, 2.0), HashOf(1.0, 2.0));
  EXPECT_NE(HashOf(1.0, 2.0), HashOf(2.0, 1.0));
  EXPECT_NE(HashOf(1.0), HashOf(std::nextafter(1.0, 2.0)));
  EXPECT_NE(HashOf(0.0), HashOf(-0.0)) << "numbers enter by their bits";
}

TEST(StateHash, DependsOnWhereATextEnds) {
  using std::string_view_literals::operator""sv;
  EXPECT_NE(HashOf("ab"sv, "c"sv), HashOf("a"sv, "bc"sv));
}

TEST(StateHash, TakesManyNumbersAsOneAfterTheOther) {
  const std::array<double, 3> numbers{1, 2, 3};
  EXPECT_EQ(HashOf(std::span<const double>(numbers)), HashOf(1.0, 2.0, 3.0));
}

}  // namespace
}  // namespace smile
