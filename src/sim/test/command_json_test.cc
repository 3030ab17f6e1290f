#include "sim/command_json.h"

#include <gtest/gtest.h>

#include <random>

#include "scene/scene_spec.h"
#include "sim/command_documents.h"

namespace smile::sim {
namespace {

constexpr double kUnit = scene::kMetersPerUnit;

std::string MessageOf(const char* text) {
  try {
    ParseCommand(Json::parse(text), kUnit);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(CommandJson, ReadsLengthsInFileUnits) {
  const Command command = ParseCommand(
      Json::parse(R"({"hand":"left","do":"move_to","position":[1,-2.5,3],"speed":2})"), kUnit);
  const auto& move = std::get<MoveTo>(command);
  EXPECT_EQ(move.hand, HandName::kLeft);
  EXPECT_EQ(move.p_WH, Vector3(0.1, -0.25, 0.3));
  EXPECT_EQ(move.speed, 0.2);
}

TEST(CommandJson, RoundTripsEveryKindToTheLastBit) {
  std::mt19937_64 random(5);
  const auto number = [&random] { return std::uniform_real_distribution<>(-3, 3)(random); };
  const auto point = [&number] { return Vector3(number(), number(), number()); };
  for (int i = 0; i < 2000; ++i) {
    const std::vector<Command> commands = {
        Grasp{.hand = HandName::kRight, .object = "b#3", .p_WQ = point()},
        Grasp{.object = "b"},
        MoveTo{.p_WH = point(), .speed = std::abs(number()) + 0.01},
        Plane{.hand = HandName::kRight, .angle_deg = number() * 90},
        Attend{.hand = HandName::kLeft, .properties = {"color", "maker's \"name\""}},
        Attend{},
        Rotate{.hand = HandName::kBoth, .angles_deg = point() * 60},
        Release{.hand = HandName::kLeft},
        Destroy{.hand = HandName::kRight},
        Load{std::make_shared<const scene::SceneSpec>(scene::SceneSpec{.name = "scene"})},
        Point{.hand = HandName::kAny, .part = "knob"},
        Trigger{.hand = HandName::kLeft, .control = "S1"},
        Trigger{.hand = HandName::kLeft, .control = "S1", .part = "S1-b2"},
        Fasten{.hand = HandName::kLeft, .object = "screw", .p_WQ = point()},
        Loosen{.hand = HandName::kRight, .object = "screw"},
        JointVelocities{.arms = {{"left", {number(), number()}}},
                        .grippers = {{"left", number()}, {"right", number()}},
                        .head = number()},
        JointAngles{.arms = {{"right", {number()}}}},
        TurnJoint{.joint = "left_e1", .velocity = number()},
        MoveGripper{.arm = "right", .velocity = number()},
        TakePose{.name = "ready", .speed = 0.25},
        FollowTrajectory{{{"left_s0", "left_gripper"},
                          {{0, {number(), number()}, {number(), number()}},
                           {0.1, {number(), number()}, {number(), number()}}}}},
        ShowRobot{.is_shown = false},
        Face{.face_expression = robot::kFaceExpressions[i % robot::kFaceExpressions.size()]},
        Markers{.points_in_world = {point(), point()}},
        Markers(),
        Undo(),
        Redo(),
        StartRecording{.name = "um", .title = "UM", .notes = "twice, \"quickly\""},
        FinishRecording(),
    };
    for (const Command& command : commands) {
      const Command on_grid = OnFileGrid(command, kUnit);
      const std::string text = ToJson(on_grid, kUnit).dump();
      EXPECT_EQ(ParseCommand(Json::parse(text), kUnit), on_grid) << text;
      EXPECT_EQ(OnFileGrid(on_grid, kUnit), on_grid) << text;
    }
  }
}

TEST(CommandJson, ReportsWhatWasFoundAndExpected) {
  EXPECT_EQ(MessageOf(R"({"do":"grasp","object":"b"})"),
            "\"grasp\" lacks \"hand\": hand of the demonstrator");
  EXPECT_EQ(MessageOf(R"({"do":"grab","hand":"left"})"),
            "\"do\" is \"grab\", expected one of grasp, move_to, plane, rotate, release, "
            "destroy, attend, point, trigger, fasten, loosen, use, "
            "joint_velocities, joint_angles, turn, gripper, pose, trajectory, robot, face, "
            "markers, spawn, remove, displace, clear, load, undo, redo, start, finish");
  EXPECT_EQ(MessageOf(R"({"hand":"third","do":"release"})"),
            "\"hand\" is \"third\", expected left, right, both or any");
  EXPECT_EQ(MessageOf(R"({"do":"face","mood":"angry"})"),
            "\"mood\" is \"angry\", expected idle, watching, working, puzzled or done");
  EXPECT_EQ(MessageOf(R"({"hand":"left","do":"move_to","position":[1,2]})"),
            "\"position\" is [1,2], expected three numbers [x, y, z] of at most 1e6");
  EXPECT_EQ(MessageOf(R"({"hand":"left","do":"release","force":3})"),
            "\"release\" has an unknown key \"force\"");
}

TEST(CommandJson, RefusesMarkersThatAreNoPoints) {
  EXPECT_EQ(MessageOf(R"({"do":"joint_angles","left":[1],"arms":{"a":[2],"left":[1]}})"),
            "\"arms\" repeats \"left\", expected each arm once");
  EXPECT_EQ(
      MessageOf(R"({"do":"joint_velocities","grippers":{"a":[1]}})"),
      "\"grippers\" is {\"a\":[1]}, expected two numbers [left, right], or at most 16 numbers "
      "like {\"arm\": 0.1}");
  EXPECT_EQ(
      MessageOf(R"({"do":"markers","points":[[1,2]]})"),
      "\"points\" is [[1,2]], expected at most 500 points [x, y, z] of numbers of at most 1e6");
  Json many = {{"do", "markers"}, {"points", std::vector(501, std::vector{1, 2, 3})}};
  EXPECT_NE(MessageOf(many.dump().c_str()), "");
}

TEST(CommandJson, RefusesInvalidNumbersAndExcessiveDepth) {
  EXPECT_NE(MessageOf(R"({"hand":"left","do":"move_to","position":[2e307,0,0]})"), "");
  EXPECT_NE(MessageOf(R"({"hand":"left","do":"move_to","position":[0,0,0],"speed":5e-324})"), "");
  const std::string deep = R"({"do":"grasp","hand":"left","object":)" + std::string(200'000, '[') +
                           std::string(200'000, ']') + "}";
  EXPECT_THROW(ParseJson(deep), std::invalid_argument);
}

TEST(CommandJson, ATrajectoryWithoutVelocitiesGetsThoseOfItsPositions) {
  const Command command = ParseCommand(
      Json::parse(R"({"do":"trajectory","joints":["a"],"points":[{"seconds":0,"positions":[0]},
          {"seconds":1,"positions":[1]},{"seconds":2,"positions":[2]}]})"),
      kUnit);
  for (const auto& point : std::get<FollowTrajectory>(command).trajectory.points) {
    EXPECT_EQ(point.velocities, std::vector<double>{1});
  }
}

TEST(CommandJson, ReportsErrorsOfATrajectory) {
  const auto with_points = [](const std::string& points) {
    return MessageOf((R"({"do":"trajectory","joints":["a"],"points":)" + points + "}").c_str());
  };
  EXPECT_EQ(with_points("[]"), "\"points\" is [], expected 1 to 10000 points");
  EXPECT_EQ(with_points(R"([{"seconds":0,"positions":[0]},{"seconds":1,"position":[0]}])"),
            "\"points[1]\" is {\"seconds\":1,\"position\":[0]}, expected a point like "
            "{\"seconds\": 0, \"positions\": [0], \"velocities\": [0]}");
  EXPECT_EQ(with_points(R"([{"seconds":1,"positions":[0]},{"seconds":1,"positions":[0]}])"),
            "points[1]: the time is 1 s, expected more than the 1 s before");
  EXPECT_EQ(with_points(R"([{"seconds":0,"positions":[0],"velocities":[0]},
                            {"seconds":1,"positions":[0]}])"),
            "points[1]: there are 0 velocities, expected 1");
}

TEST(CommandJson, TheSchemaNamesEveryCommandItReads) {
  const Json schema = CommandSchema();
  for (const Json& form : schema.at("oneOf")) {
    Json empty = {{"do", form.at("title")}};
    const bool needs_more = form.at("required").size() > 1;
    EXPECT_EQ(!MessageOf(empty.dump().c_str()).empty(), needs_more) << form.at("title");
  }
  EXPECT_EQ(schema.at("oneOf").size(), std::variant_size_v<Command> + 3)
      << "and drag, add, and duplicate";
}

}  // namespace
}  // namespace smile::sim
