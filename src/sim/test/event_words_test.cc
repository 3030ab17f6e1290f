#include "sim/event_words.h"

#include <gtest/gtest.h>

namespace smile::sim {
namespace {

TEST(EventWords, SayWhatContactAndToolsDidWithoutACommand) {
  Event press{.kind = EventKind::kPressed, .arm = "left", .object = "Panel", .control = "Power"};
  EXPECT_EQ(WordsOf(press), "Power pressed by left gripper");
  press.arm = "robot";
  EXPECT_EQ(WordsOf(press), "Power pressed by robot");
  press.arm.clear();
  EXPECT_EQ(WordsOf(press), "Power pressed");
  press.by = "Ball";
  EXPECT_EQ(WordsOf(press), "Power pressed by Ball");

  Event use{.kind = EventKind::kUsed,
            .arm = "left",
            .object = "String-link4",
            .part = "String between link 4 and 5",
            .state = "cut",
            .by = "Scissors"};
  EXPECT_EQ(WordsOf(use), "left gripper cuts String between link 4 and 5 with Scissors");
  use.arm.clear();
  EXPECT_EQ(WordsOf(use), "Scissors cuts String between link 4 and 5");
  // A command of a hand is an action, which has a summary.
  use.hand = demonstrator::HandName::kLeft;
  EXPECT_EQ(WordsOf(use), std::nullopt);
  EXPECT_EQ(WordsOf(Event{.kind = EventKind::kControlChanged}), std::nullopt);
}

}  // namespace
}  // namespace smile::sim
