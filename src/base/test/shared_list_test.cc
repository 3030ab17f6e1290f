#include "base/shared_list.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

namespace smile {
namespace {

TEST(SharedList, IsTheListThatWasSetWhateverItsCopiesBecome) {
  std::mt19937 random(1);
  std::vector<int> truth(200);
  SharedList<int> list(truth);
  std::vector<std::pair<SharedList<int>, std::vector<int>>> kept;
  for (int round = 0; round < 300; ++round) {
    std::map<std::size_t, int> changes;
    for (unsigned i = 0; i < random() % (round % 50 == 0 ? 200 : 4); ++i) {
      changes[random() % truth.size()] = static_cast<int>(random());
    }
    for (const auto& [index, value] : changes) truth[index] = value;
    list.Set({changes.begin(), changes.end()});
    ASSERT_TRUE(std::ranges::equal(list, truth)) << "round " << round;
    for (const auto& [copy, then] : kept) {
      const std::vector<std::size_t> may_differ = list.MayDifferFrom(copy);
      for (std::size_t i = 0; i < truth.size(); ++i) {
        ASSERT_TRUE(truth[i] == then[i] || std::ranges::binary_search(may_differ, i));
      }
    }
    if (random() % 5 == 0) kept.emplace_back(list, truth);
    if (random() % 20 == 0 && !kept.empty()) {
      std::tie(list, truth) = kept[random() % kept.size()];
    }
  }
  for (const auto& [copy, then] : kept) EXPECT_TRUE(std::ranges::equal(copy, then));
}

TEST(SharedList, ACopyKeepsLittleBesideWhatItShares) {
  SharedList<int> list(std::vector<int>(1000));
  const SharedList<int> before = list;
  EXPECT_EQ(list.NumBeside(SharedList<int>()), 1000u);
  for (int round = 0; round < 100; ++round) {
    list.Set({{7, round}, {8, round}});
    EXPECT_EQ(list.NumBeside(before), 2u);
    EXPECT_EQ(list.MayDifferFrom(before), (std::vector<std::size_t>{7, 8}));
  }
}

}  // namespace
}  // namespace smile
