#include "study/orders.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "study/steps.h"
#include "study_fixture.h"

namespace smile::study {
namespace {

TEST(Orders, AreBalanced) {
  for (std::size_t n = 1; n <= 9; ++n) {
    std::map<std::pair<std::size_t, std::size_t>, int> at, after;
    for (std::size_t row = 0; row < NumOrders(n); ++row) {
      const std::vector<std::size_t> order = BalancedOrder(n, row);
      EXPECT_EQ(std::set<std::size_t>(order.begin(), order.end()).size(), n);
      for (std::size_t k = 0; k < n; ++k) {
        ++at[{k, order[k]}];
        if (k > 0) ++after[{order[k - 1], order[k]}];
      }
    }
    // Each item at each position, and after each other item, equally often.
    EXPECT_EQ(at.size(), n * n);
    EXPECT_EQ(after.size(), n * (n - 1));
    const int times = static_cast<int>(NumOrders(n) / n);
    for (const auto& [place, count] : at) EXPECT_EQ(count, times) << n;
    for (const auto& [pair, count] : after) EXPECT_EQ(count, times) << n;
  }
}

TEST(Orders, AreThoseOfWilliams) {
  EXPECT_EQ(BalancedOrder(4, 0), (std::vector<std::size_t>{0, 1, 3, 2}));
  EXPECT_EQ(BalancedOrder(4, 1), (std::vector<std::size_t>{1, 2, 0, 3}));
  EXPECT_EQ(BalancedOrder(3, 3), (std::vector<std::size_t>{2, 1, 0}));
  EXPECT_EQ(BalancedOrder(4, 5), BalancedOrder(4, 1));
}

class Steps : public StudyTest {};

TEST_F(Steps, GoFromConsentToThanks) {
  std::vector<std::string> names;
  for (const Step& step : StepsOf(ReadDefinition(file()), 2)) names.push_back(step.name);
  EXPECT_EQ(names, (std::vector<std::string>{
                       "consent", "instruction-1", "practice", "task-stack-ghost",
                       "questions-nasa-tlx-ghost", "break-1", "task-stack-snap",
                       "questions-nasa-tlx-snap", "break-2", "task-stack-none",
                       "questions-nasa-tlx-none", "questions-sus", "questions-remarks", "thanks"}));
}

TEST_F(Steps, GiveEachConditionEachTaskEquallyOften) {
  Json study = Study();
  for (const char* name : {"two", "three"}) {
    study["tasks"].push_back(study["tasks"][0]);
    study["tasks"].back()["name"] = name;
  }
  study["tasks_per_condition"] = "one";
  WriteStudy(study);
  const Definition read = ReadDefinition(file());
  std::map<std::string, int> counts;
  for (int number = 1; number <= 6; ++number) {
    for (const Step& step : StepsOf(read, number)) {
      if (step.kind == StepKind::kTask) ++counts[step.name];
    }
  }
  EXPECT_EQ(counts.size(), 9u);
  for (const auto& [name, count] : counts) EXPECT_EQ(count, 2) << name;
}

}  // namespace
}  // namespace smile::study
