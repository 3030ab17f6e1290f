// A robot moves the mechanisms of scenes/desk.xml, by grasp and by a push: python/examples/desk.

#include <cmath>

#include "program.h"

namespace smile {
namespace {

class Desk : public ProgramTest {};

TEST_F(Desk, IsWorkedByARobotAlone) {
  const Answer run =
      Smile("run '" + Shipped("scenes/desk.xml") + "' --robot tern --brain '" +
            Shipped("python/examples/desk/desk.py") + "' --record worked --no-pictures --json");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Json objects = run.json()["objects"];
  const auto rotation = [&](const char* object, int axis) {
    return objects[object]["rotation"][axis].get<double>();
  };
  const Json drawer = objects["Drawer"]["position"];
  EXPECT_NEAR(drawer[1].get<double>(), -1.3 - 1.5, 0.05) << "the drawer is pulled out by 1.5 units";
  EXPECT_NEAR(drawer[0].get<double>(), -3, 0.01);
  EXPECT_NEAR(rotation("Dial", 2), 86, 4) << "the dial is turned by 1.5 rad";
  EXPECT_NEAR(rotation("Door", 2), 5, 8) << "the door was opened by 1 rad and pushed shut";
  EXPECT_NEAR(rotation("Lid", 0), 57, 5) << "the lid is open by 1 rad";
  // The hinges hold: the axes are where they were.
  const Json door = objects["Door"]["position"], dial = objects["Dial"]["position"];
  EXPECT_NEAR(std::hypot(door[0].get<double>() - 1.6, door[1].get<double>() + 0.6), 1, 0.05);
  EXPECT_NEAR(std::hypot(dial[0].get<double>() - 3.4, dial[1].get<double>() + 3.4), 0, 0.03);
  EXPECT_EQ(Read("worked/commands.jsonl").find("\"hand\""), std::string::npos);
  EXPECT_EQ(Smile("replay worked --verify").exit_code, 0);
}

}  // namespace
}  // namespace smile
