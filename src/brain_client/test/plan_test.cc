#include <gtest/gtest.h>

#include <array>
#include <stdexcept>

#include "brain_client/internal_plan.h"
#include "wire/test/wire_verbs.h"

namespace smile::brain_client {
namespace {

using Ids = std::vector<std::string>;

/// INIT with a plan of two subtasks.
Fields InitWith(double sufficient, const std::string& objects = "a,tool\n") {
  wire::MessageWriter writer(wire::MessageType::kInit, 1);
  writer.AddText("planWords", "puts a\npresses");
  writer.AddText("planObjects", objects);
  writer.AddDoubles("planSegments", std::array{2u, 2u}, std::array{1.0, 3.0, 2.0, 3.0});
  writer.AddDoubles("planNecessary", std::array{1u, 2u}, std::array{1.0, 0.0});
  writer.AddDoubles("planOrder", std::array{1u, 2u}, std::array{1.0, 2.0});
  writer.AddDoubles("planSufficient", std::array{1u, 1u}, std::array{sufficient});
  writer.AddText("planGoals", "a\nb");
  return Fields(wire::Decoded(writer.Finish()));
}

TEST(Plan, IsReadFromTheFirstMessage) {
  const Plan plan = PlanOf(InitWith(1)).value();
  ASSERT_EQ(plan.subtasks.size(), 2u);
  EXPECT_EQ(plan.subtasks[0].words, "puts a");
  EXPECT_EQ(plan.subtasks[0].objects, (Ids{"a", "tool"}));
  EXPECT_EQ(plan.subtasks[1].objects, Ids());
  EXPECT_EQ(plan.subtasks[0].last_segment, 2);
  EXPECT_TRUE(plan.subtasks[0].is_necessary);
  EXPECT_FALSE(plan.subtasks[1].is_necessary);
  EXPECT_EQ(plan.order.front(), std::pair(std::size_t{0}, std::size_t{1}));
  EXPECT_EQ(plan.sufficient, std::vector<std::size_t>{0});
  EXPECT_EQ(plan.goals, (Ids{"a", "b"}));
}

TEST(Plan, IsOptional) {
  wire::MessageWriter writer(wire::MessageType::kInit, 1);
  EXPECT_FALSE(PlanOf(Fields(wire::Decoded(writer.Finish()))).has_value());
}

TEST(Plan, RefusesWhatDoesNotFitTogether) {
  for (const double number : {0.0, 3.0, 1.5}) {
    EXPECT_THROW((void)PlanOf(InitWith(number)), std::invalid_argument) << number;
  }
  EXPECT_THROW((void)PlanOf(InitWith(1, "a")), std::invalid_argument);
}

}  // namespace
}  // namespace smile::brain_client
