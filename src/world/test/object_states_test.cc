#include "world/object_states.h"

#include <gtest/gtest.h>

namespace smile::world {
namespace {

using model::ObjectIndex;

TEST(ObjectStates, KeepOnlyThoseThatDifferFromTheInitialOne) {
  ObjectStates states;
  EXPECT_EQ(states[ObjectIndex(1000)], ObjectState());
  states.Set(ObjectIndex(7), {.was_raised = true});
  states.Set(ObjectIndex(3), {.has_fallen = true});
  states.Set(ObjectIndex(5), {});
  ASSERT_EQ(states.changed().size(), 2u);
  EXPECT_EQ(states.changed()[0].first, 3u);
  EXPECT_EQ(states.changed()[1].first, 7u);
  EXPECT_TRUE(states[ObjectIndex(7)].was_raised);
  EXPECT_FALSE(states[ObjectIndex(7)].has_fallen);

  states.Set(ObjectIndex(7), {.was_raised = true, .has_fallen = true});
  EXPECT_TRUE(states[ObjectIndex(7)].has_fallen);
  states.Set(ObjectIndex(7), {});
  states.Set(ObjectIndex(3), {});
  EXPECT_EQ(states, ObjectStates());
}

}  // namespace
}  // namespace smile::world
