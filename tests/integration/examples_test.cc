// The scripts of examples/: each is recorded with its scene, ends as a demonstration should and
// with the state hash that it has had since the first edition, and replays to the last bit.

#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <ostream>
#include <vector>

#include "program.h"

namespace smile {
namespace {

/// What a script must have brought about; end is what `run --json` answers.
using Claim = void (*)(const Json& end);

struct Example {
  const char* script;  ///< in examples/, without .jsonl
  const char* options;
  Claim claim;
  const char* scene = "";  ///< in scenes/, without .xml; of the same name as the script if empty
};

/// For a test: of letters, digits and `_`.
std::string NameOf(const Example& example) {
  std::string name = std::string(example.script) + example.options;
  std::ranges::replace_if(
      name, [](char c) { return c == '/' || c == '-'; }, '_');
  return name;
}
/// So that GoogleTest says which, not its bytes.
void PrintTo(const Example& example, std::ostream* out) { *out << NameOf(example); }

using Vector = std::array<double, 3>;
constexpr double kMillimeter = 0.01;  ///< [units]
constexpr double kOneDegree = 1;

Vector PositionOf(const Json& end, const std::string& object) {
  return end.at("objects").at(object).at("position").get<Vector>();
}
Vector RotationOf(const Json& end, const std::string& object) {
  return end.at("objects").at(object).at("rotation").get<Vector>();
}

void ExpectNear(const Vector& found, const Vector& expected, double tolerance,
                const std::string& what) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(found[axis], expected[axis], tolerance) << what << ", axis " << axis;
  }
}

/// `object` is there as seen from `base` [units], and stands along the table's axes.
void ExpectAligned(const Json& end, const std::string& object, const std::string& base,
                   const Vector& offset) {
  const Vector from = PositionOf(end, base), to = PositionOf(end, object);
  ExpectNear({to[0] - from[0], to[1] - from[1], to[2] - from[2]}, offset, kMillimeter, object);
  ExpectNear(RotationOf(end, object), {0, 0, 0}, kOneDegree, object);
}

void TheTowerStands(const Json& end) {
  ExpectAligned(end, "GreenBlock", "RedBlock", {0, 0, 1});
  ExpectAligned(end, "BlueBlock", "RedBlock", {0, 0, 2});
}

void TheLettersStand(const Json& end) {
  EXPECT_NEAR(PositionOf(end, "ShortPlank")[2], 0.5, kMillimeter);
  ExpectNear(RotationOf(end, "ShortPlank"), {0, 0, 0}, kOneDegree, "ShortPlank");
  ExpectAligned(end, "Red1", "ShortPlank", {-1.5, 0, 1});
  ExpectAligned(end, "Cyan1", "ShortPlank", {-1.5, 0, 2});
  ExpectAligned(end, "Green1", "ShortPlank", {1.5, 0, 1});
  ExpectAligned(end, "Red2", "ShortPlank", {1.5, 0, 2});

  ExpectAligned(end, "LongPlank", "ShortPlank", {6, 0, 2});
  ExpectAligned(end, "Blue1", "LongPlank", {-2, 0, -2});
  ExpectAligned(end, "Green2", "LongPlank", {-2, 0, -1});
  ExpectAligned(end, "Magenta1", "LongPlank", {0, 0, -2});
  ExpectAligned(end, "Blue2", "LongPlank", {0, 0, -1});
  ExpectAligned(end, "Orange1", "LongPlank", {2, 0, -2});
  ExpectAligned(end, "Magenta2", "LongPlank", {2, 0, -1});
}

void TheBlocksHaveDropped(const Json& end) {
  EXPECT_NEAR(PositionOf(end, "HopperLid")[0], -3, 0.02) << "the door is open";
  for (const char* block : {"Rust", "Moss"}) EXPECT_LT(PositionOf(end, block)[2], 1.3);
}

void TheWeightLiesOnTheAnvil(const Json& end) {
  EXPECT_FALSE(end["objects"].contains("Cord-link10")) << "the string is cut";
  ExpectNear(PositionOf(end, "Weight"), {0, 0, 1.1}, 0.3, "Weight");
}

void TheSpareHasReplacedTheFailedDrive(const Json& end) {
  const Vector drawer = PositionOf(end, "DockDrawer"), spare = PositionOf(end, "Spare");
  EXPECT_NEAR(drawer[1], 3.4, 0.02) << "the drawer is shut";
  ExpectNear(PositionOf(end, "DockCase"), {-5.9, 3.4, 1.4}, 0.02, "DockCase");
  // The slot leaves the drive 0.07 to the sides, 0.15 to the front and the back.
  EXPECT_NEAR(spare[0] - drawer[0], 0.8, 0.07);
  EXPECT_NEAR(spare[1] - drawer[1], 0.6, 0.15);
  EXPECT_NEAR(spare[2] - drawer[2], 0.8, kMillimeter);
  ExpectNear(PositionOf(end, "Drive3"), {2.8, 1.2, 0.95}, 0.1, "Drive3 in the bin");
  const Json& controls = end["controls"];
  EXPECT_EQ(controls["DockLight3"], "ready");
  EXPECT_EQ(controls["DockLight2"], "busy") << "the others are not touched";
}

void TheScrewIsOutAndTheCoverOff(const Json& end) {
  EXPECT_EQ(end["controls"]["LampOff"], "lit") << "first of all it was switched off";
  ExpectNear(PositionOf(end, "PanelScrew"), {3.9, -1.2, 1.02}, 0.02, "PanelScrew on its head");
  ExpectNear(PositionOf(end, "Cover"), {-1.2, -1.5, 0.15}, 0.02, "Cover flat on the table");
  ExpectNear(PositionOf(end, "Cabinet"), {0, 2, 2.55}, 0.02, "Cabinet");
}

void TheRedBlockIsOutAndTheLidShut(const Json& end) {
  ExpectNear(PositionOf(end, "Cherry"), {5.5, 1, 0.5}, 0.02, "Cherry");
  ExpectNear(PositionOf(end, "ChestLid"), {1, -0.5, 2.125}, 0.02, "ChestLid");
}

void BothScrewsAreTight(const Json& end) {
  ExpectNear(PositionOf(end, "BrassScrew"), {-4.5, -2, 1.4}, kMillimeter, "BrassScrew");
  ExpectNear(PositionOf(end, "SteelScrew"), {2.8, -0.5, 1.9}, kMillimeter, "SteelScrew");
}

void TheGaugeIsFull(const Json& end) { EXPECT_EQ(end["controls"]["Gauge"], "full"); }

void TheDigitIsSeven(const Json& end) { EXPECT_EQ(end["controls"]["Digit"], "seven"); }

void TheSignalIsGreen(const Json& end) {
  EXPECT_EQ(end["controls"]["Signal"], "drive");
  EXPECT_EQ(end["controls"]["Lamp"], "blue");
}

void TheRobotIsReadyAndHasTouchedNothing(const Json& end) {
  const std::array ready{-0.08, -1.0, -1.19, 1.94, 0.67, 1.03, -0.5};
  for (std::size_t i = 0; i < ready.size(); ++i) {
    EXPECT_NEAR(end["robot"]["left"]["joints"][i].get<double>(), ready[i], 1e-3) << i;
    const double mirrored = i % 2 == 0 ? -ready[i] : ready[i];
    EXPECT_NEAR(end["robot"]["right"]["joints"][i].get<double>(), mirrored, 1e-3) << i;
  }
  EXPECT_NEAR(end["robot"]["head"].get<double>(), 0, 1e-3);
  EXPECT_NEAR(end["robot"]["left"]["gripper"].get<double>(), 1, kMillimeter);
  EXPECT_NEAR(end["robot"]["right"]["gripper"].get<double>(), 2, kMillimeter);
  ExpectNear(PositionOf(end, "RedBlock"), {-3, -2.5, 0.5}, kMillimeter, "RedBlock");
  ExpectNear(PositionOf(end, "GreenBlock"), {0.4, -3.8, 0.5}, kMillimeter, "GreenBlock");
  ExpectNear(PositionOf(end, "BlueBlock"), {3.2, -2, 0.5}, kMillimeter, "BlueBlock");
}

void TheRowIsSorted(const Json& end) {
  const std::array blocks{"Red1", "Red2", "Green1", "Green2", "Blue1", "Blue2"};
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    ExpectAligned(end, blocks[i], blocks[0], {1.5 * static_cast<double>(i), 0, 0});
  }
}

void TheBridgeStands(const Json& end) {
  EXPECT_NEAR(PositionOf(end, "Red1")[2], 0.5, kMillimeter);
  ExpectAligned(end, "Green1", "Red1", {0, 0, 1});
  ExpectAligned(end, "Red2", "Red1", {3, 0, 0});
  ExpectAligned(end, "Green2", "Red1", {3, 0, 1});
  ExpectAligned(end, "Plank", "Red1", {1.5, 0, 2});
}

void TheBoxIsPacked(const Json& end) {
  ExpectAligned(end, "Cyan", "Case", {-1.4, 0, 0.25});
  ExpectAligned(end, "Yellow", "Case", {0, 0, 0.25});
  ExpectAligned(end, "Magenta", "Case", {1.4, 0, 0.25});
}

void TheCubesAreSortedBySize(const Json& end) {
  ExpectAligned(end, "Medium", "Large", {1.8, 0, -0.15});
  ExpectAligned(end, "Small", "Large", {3.3, 0, -0.275});
  ExpectAligned(end, "Tiny", "Large", {4.6, 0, -0.4});
}

void ThePyramidStands(const Json& end) {
  ExpectAligned(end, "Red2", "Red1", {1.01, 0, 0});
  ExpectAligned(end, "Red3", "Red1", {2.02, 0, 0});
  ExpectAligned(end, "Red4", "Red1", {0.505, 0, 1});
  ExpectAligned(end, "Red5", "Red1", {1.515, 0, 1});
  ExpectAligned(end, "Red6", "Red1", {1.01, 0, 2});
}

void TheWallStands(const Json& end) {
  ExpectAligned(end, "Brick2", "Brick1", {2.02, 0, 0});
  ExpectAligned(end, "Brick3", "Brick1", {4.04, 0, 0});
  ExpectAligned(end, "Brick4", "Brick1", {1.01, 0, 0.5});
  ExpectAligned(end, "Brick5", "Brick1", {3.03, 0, 0.5});
  ExpectAligned(end, "Brick6", "Brick1", {2.02, 0, 1});
}

void ThePiecesAreInPlace(const Json& end) {
  // The L keeps the rotation in which it began, as does what lies on the cross.
  ExpectNear(PositionOf(end, "Angle"), {-2.8, 1, 0.3}, kMillimeter, "Angle");
  ExpectNear(RotationOf(end, "Angle"), {0, 0, 30}, kOneDegree, "Angle");
  ExpectNear(PositionOf(end, "Cube"), {-2.5, 0.88, 0.9}, kMillimeter, "Cube");
  ExpectNear(RotationOf(end, "Triangle"), {0, 0, 90}, kOneDegree, "Triangle");
  ExpectNear(PositionOf(end, "Cross"), {2.8, 1, 0.25}, kMillimeter, "Cross");
  ExpectNear(RotationOf(end, "Cross"), {0, 0, 45}, kOneDegree, "Cross");
  ExpectNear(PositionOf(end, "Ring"), {2.8, 1, 0.7}, kMillimeter, "Ring");
}

void TheTowerStandsOnThePedestal(const Json& end) {
  const std::map<std::string, Vector> places{
      {"Pedestal", {1.4, 1, 0.75}}, {"RedBlock", {1.4, 1, 2}}, {"GreenBlock", {1.4, 1, 3}}};
  for (const auto& [object, position] : places) {
    ExpectNear(PositionOf(end, object), position, kMillimeter, object);
    ExpectNear(RotationOf(end, object), {0, 0, 20}, kOneDegree, object);
  }
}

void TheTowerIsTakenApart(const Json& end) {
  ExpectAligned(end, "GreenBlock", "RedBlock", {1.6, 0, 0});
  ExpectAligned(end, "BlueBlock", "RedBlock", {3.2, 0, 0});
}

void TheBlocksAreExchanged(const Json& end) {
  ExpectAligned(end, "RedBlock", "LightPlate", {0, 0, 0.6});
  ExpectAligned(end, "BlueBlock", "DarkPlate", {0, 0, 0.6});
}

void TheBlockIsBesideTheWall(const Json& end) {
  ExpectNear(PositionOf(end, "BlueBlock"), {0.63, 1.57, 0.5}, kMillimeter, "BlueBlock");
  ExpectNear(RotationOf(end, "BlueBlock"), {0, 0, 15}, kOneDegree, "BlueBlock");
}

void TheTowerOfHanoiHasMoved(const Json& end) {
  ExpectAligned(end, "LargeDisc", "PlateC", {0, 0, 0.4});
  ExpectAligned(end, "MediumDisc", "PlateC", {0, 0, 1});
  ExpectAligned(end, "SmallDisc", "PlateC", {0, 0, 1.6});
}

void TheBallIsInTheCup(const Json& end) {
  // On its floor, 0.15 thick, and 0.15 from the wall at most.
  ExpectNear(PositionOf(end, "Ball"), {1.5, 1.2, 0.5}, 0.15, "Ball");
  EXPECT_NEAR(PositionOf(end, "Ball")[2], 0.5, kMillimeter);
  ExpectNear(PositionOf(end, "Cup"), {1.5, 1.2, 0.55}, kMillimeter, "Cup");
}

void TheBlockIsUnderTheLid(const Json& end) {
  ExpectAligned(end, "Cherry", "Pot", {0, 0, -0.1});
  ExpectAligned(end, "Lid", "Pot", {0, 0, 0.75});
}

void ThePlankIsOnItsSide(const Json& end) {
  EXPECT_NEAR(PositionOf(end, "Plank")[2], 0.5, kMillimeter);
  ExpectNear(RotationOf(end, "Plank"), {90, 0, 0}, kOneDegree, "Plank");
}

void TheBlocksHaveDroppedThroughTheHatch(const Json& end) {
  ExpectAligned(end, "HatchDoor", "Hatch", {3.3, 0, 0.3});
  for (const char* block : {"Cherry", "Sky"}) {
    const Vector hatch = PositionOf(end, "Hatch"), at = PositionOf(end, block);
    EXPECT_NEAR(at[0], hatch[0], 1.1) << block;
    EXPECT_NEAR(at[2], 0.4, kMillimeter) << block;
  }
}

void TheSpareIsInTheRack(const Json& end) {
  ExpectAligned(end, "Spare", "Rack", {1.1, 0.8, 0.95});
  ExpectAligned(end, "Drive1", "Rack", {-1.1, 0.8, 0.95});
  ExpectAligned(end, "Drive2", "Bin", {0, 0, 0.65});
  EXPECT_EQ(end["controls"]["RackLight2"], "ready");
}

void TheStringIsCutAndTheWeightInTheBox(const Json& end) {
  // In the box, whose floor is 0.15 thick.
  ExpectNear(PositionOf(end, "Weight"), {-1, 3, 0.45}, 0.6, "Weight");
  EXPECT_NEAR(PositionOf(end, "Weight")[2], 0.45, kMillimeter);
  ExpectNear(PositionOf(end, "Scissors"), {3, 0, 0.4}, kMillimeter, "Scissors");
}

void TheFuseIsReplacedAndTheCoverClosed(const Json& end) {
  ExpectAligned(end, "Cover", "Housing", {0, 0, 1.05});
  // The socket leaves the fuse 0.1 to the sides, 0.08 to the front and the back.
  ExpectNear(PositionOf(end, "Spare"), {-1, 1, 0.5}, 0.1, "Spare");
  ExpectNear(PositionOf(end, "DeadFuse"), {-4.9, 1, 0.5}, 0.1, "DeadFuse in the bin");
  const std::map<std::string, Vector> tight{{"ScrewNW", {-2.55, 1.75, 1.3}},
                                            {"ScrewNE", {0.55, 1.75, 1.3}},
                                            {"ScrewSW", {-2.55, 0.25, 1.3}},
                                            {"ScrewSE", {0.55, 0.25, 1.3}}};
  for (const auto& [screw, position] : tight) {
    ExpectNear(PositionOf(end, screw), position, kMillimeter, screw);
    EXPECT_NEAR(RotationOf(end, screw)[2], -90, kOneDegree) << screw << " at its second stage";
  }
}

void TheBoltIsTightAndTheSignIsGlued(const Json& end) {
  // The third stage, after a use of the wrench and a turn of it.
  ExpectNear(PositionOf(end, "Bolt"), {-3, 2, 1}, kMillimeter, "Bolt");
  ExpectNear(PositionOf(end, "Sign"), {3, 2, 0.46}, kMillimeter, "Sign");
}

const std::vector<Example>& AllExamples() {
  static const std::vector<Example> kExamples{
      {"tower", "", TheTowerStands},
      {"um", "", TheLettersStand},
      {"um", "--no-robot", TheLettersStand},
      {"row", "", TheRowIsSorted},
      {"row", "--no-robot", TheRowIsSorted},
      {"bridge", "", TheBridgeStands},
      {"bridge", "--no-robot", TheBridgeStands},
      {"box", "", TheBoxIsPacked},
      {"box", "--no-robot", TheBoxIsPacked},
      {"sizes", "--no-robot", TheCubesAreSortedBySize},
      {"pyramid", "--no-robot", ThePyramidStands},
      {"bricks", "--no-robot", TheWallStands},
      {"pieces", "--no-robot", ThePiecesAreInPlace},
      {"pedestal", "--no-robot", TheTowerStandsOnThePedestal},
      {"unstack", "--no-robot", TheTowerIsTakenApart},
      {"swap", "--no-robot", TheBlocksAreExchanged},
      {"beside", "--no-robot", TheBlockIsBesideTheWall},
      {"hanoi", "--no-robot", TheTowerOfHanoiHasMoved},
      {"ball", "--no-robot", TheBallIsInTheCup},
      {"lid", "--no-robot", TheBlockIsUnderTheLid},
      {"plank", "--no-robot", ThePlankIsOnItsSide},
      {"hatch", "", TheBlocksHaveDroppedThroughTheHatch},
      {"hatch", "--no-robot", TheBlocksHaveDroppedThroughTheHatch},
      {"cover", "--no-robot", TheFuseIsReplacedAndTheCoverClosed},
      {"drive", "", TheSpareIsInTheRack},
      {"drive", "--no-robot", TheSpareIsInTheRack},
      {"scissors", "", TheStringIsCutAndTheWeightInTheBox},
      {"scissors", "--no-robot", TheStringIsCutAndTheWeightInTheBox},
      {"robot_poses", "", TheRobotIsReadyAndHasTouchedNothing, "tower"},
      {"scenes/controls", "--no-robot", TheSignalIsGreen},
      {"scenes/dial", "--no-robot", TheDigitIsSeven},
      {"scenes/dock", "--no-robot", TheSpareHasReplacedTheFailedDrive},
      {"scenes/dock", "", TheSpareHasReplacedTheFailedDrive},
      {"scenes/fastening", "--no-robot", TheBoltIsTightAndTheSignIsGlued},
      {"scenes/lidbox", "--no-robot", TheRedBlockIsOutAndTheLidShut},
      {"scenes/panel", "--no-robot", TheScrewIsOutAndTheCoverOff},
      {"scenes/screws", "--no-robot", BothScrewsAreTight},
      {"scenes/strings", "--no-robot", TheWeightLiesOnTheAnvil},
      {"scenes/trapdoor", "--no-robot", TheBlocksHaveDropped},
      {"scenes/valve", "--no-robot", TheGaugeIsFull},
  };
  return kExamples;
}

/// Returns the state hash at the end of each example, by its name
/// (tools/make_golden_recordings.sh).
std::map<std::string, std::string> GoldenHashes() {
  std::ifstream file(SMILE_SOURCE_DIR "/tests/golden/recordings/hashes.txt");
  std::map<std::string, std::string> hashes;
  for (std::string name, hash; file >> name >> hash;) hashes[name] = hash;
  return hashes;
}

/// Returns whether the golden hash is of the example with these options: most are without robot.
bool HasGoldenHash(const Example& example) {
  const std::string script = example.script;
  return script == "tower" || script == "robot_poses" ||
         example.options == std::string("--no-robot");
}

class Examples : public ProgramTest, public ::testing::WithParamInterface<Example> {};

TEST_P(Examples, EndAsTheyShouldAndReplayIdentically) {
  const std::string script = GetParam().script;
  std::string scene = GetParam().scene;
  if (scene.empty()) scene = std::filesystem::path(script).filename().string();
  // Few and small pictures: no check reads them.
  const Answer run = Smile("run '" + Shipped("scenes/" + scene + ".xml") + "' --commands '" +
                           Shipped("examples/" + script + ".jsonl") +
                           "' --record demo --rate 0.5 --size 80x60 --json " + GetParam().options);
  ASSERT_EQ(run.exit_code, 0) << run.err;
  GetParam().claim(run.json());
  if (HasGoldenHash(GetParam())) {
    const std::string name = std::filesystem::path(script).filename();
    EXPECT_EQ(run.json().at("hash"), GoldenHashes().at(name));
  }
  const Answer replay = Smile("replay demo --verify");
  EXPECT_EQ(replay.exit_code, 0) << replay.out << replay.err;
}

INSTANTIATE_TEST_SUITE_P(All, Examples, ::testing::ValuesIn(AllExamples()),
                         [](const auto& parameter) { return NameOf(parameter.param); });

TEST_F(ProgramTest, EveryExampleHasItsClaimAndItsGoldenHash) {
  const std::filesystem::path root = Shipped("examples");
  std::size_t num_examples = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root)) {
    if (entry.path().extension() != ".jsonl") continue;
    // Of one hand each: two_hands_test.cc has the claims of both together.
    if (entry.path().parent_path().filename() == "two_hands") continue;
    ++num_examples;
    const std::string script =
        entry.path().lexically_relative(root).replace_extension().generic_string();
    EXPECT_TRUE(std::ranges::any_of(AllExamples(), [&](const Example& example) {
      return example.script == script && HasGoldenHash(example);
    })) << entry.path();
    EXPECT_TRUE(GoldenHashes().contains(entry.path().stem()))
        << entry.path() << ": run tools/make_golden_recordings.sh";
  }
  EXPECT_EQ(num_examples, GoldenHashes().size());
}

}  // namespace
}  // namespace smile
