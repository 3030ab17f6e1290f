#include "classic/classic_reader.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <random>

#include "base/diagnostic.h"
#include "base/files.h"
#include "classic/placeholder_objects.h"
#include "damage.h"
#include "image/png.h"
#include "scene_xml/scene_reader.h"
#include "scene_xml/scene_writer.h"

namespace smile::classic {
namespace {

/// A cup and a lamp with its button; the cup is carried off, a scene is loaded in between, a hand
/// releases an object without a recorded grasp.
const std::vector<ClassicText> kEvening{
    {"0.txt",
     "0,create,Cup,shape,block,label,white\\, chipped,bboxx,2,bboxz,0.5\n"
     "0,create,Lamp,shape,composite,color,green\n"
     "0,create,ball\n"
     "0,initializeControl,Button,toggleSwitch,Lamp,1\n"
     "0,initializeControl,Glow,indicatorLights,Lamp,dim\n"
     "0,move,Cup,2.0,-0.0,1.0E-4,0.0,-0.0,14.25\n"
     "0,move,Lamp,-3.5,1.0E1,0.75,0.0,-90.0,20.0\n"
     "0,move,ball,0.0,0.0,0.5,0.0,0.0,0.0\n"
     "2,move,ball,0.0,0.0,-4.5,0.0,0.0,0.0\n"
     "2,delete,ball\n"},
    {"1.txt",
     "4,grasp,BothHands,Cup\r\n"
     "4,attend,BothHands,Cup,color,size\r\n"
     "6,move,Cup,2.0,3.0,1.0,0.0,-0.0,14.25\r\n"},
    {"2.txt", "7,release,BothHands\n"},
    {"3.txt", "7,trigger,LeftHand,Button\n7,changeControlState,Button,0\n"},
    {"4.txt", "8,pointTo,AnyHand,Shade,Lamp\n"},
    {"5.txt",
     "9,fasten,RightHand,Socket,Lamp,Plug,Cup,2\n"
     "9,move,Cup,1.0,3.0,1.0,0.0,0.0,0.0\n"},
    {"6.txt", "9,grasp,RightHand,Cup\n"},
    {"7.txt", "10,delete,Cup\n10,destroy,RightHand\n"},
    {"8.txt",
     "12,release,LeftHand\n"
     "12,delete,Lamp\n"
     "12,create,Cup,shape,sphere\n"
     "13,move,Cup,5.0,0.0,0.0,0.0,0.0,0.0\n"}};

template <class What>
const What& At(const ClassicRecording& recording, std::size_t segment, std::size_t line) {
  return std::get<What>(recording.segments.at(segment).lines.at(line).what);
}

/// Finding in a refused text.
std::string Refusal(const std::vector<ClassicText>& texts, const ClassicLimits& limits = {}) {
  try {
    ReadClassicTexts(texts, limits);
  } catch (const InputError& error) {
    return error.what();
  }
  return "was read";
}

TEST(ClassicReader, ReadsEveryKindOfLine) {
  const ClassicRecording evening = ReadClassicTexts(kEvening);
  EXPECT_EQ(evening.last_frame(), 13u);
  EXPECT_EQ(evening.Objects(), (std::vector<std::string>{"Cup", "Lamp", "ball"}));
  EXPECT_EQ(At<ClassicCreate>(evening, 0, 0).descriptions.at(1),
            (scene::Description{"label", "white, chipped"}));
  EXPECT_TRUE(At<ClassicCreate>(evening, 0, 2).descriptions.empty());
  const auto& glow = At<ClassicControl>(evening, 0, 4);
  EXPECT_EQ(glow.control + glow.kind + glow.object + glow.state, "GlowindicatorLightsLampdim");
  EXPECT_EQ(At<ClassicMove>(evening, 0, 5).position, Vector3(2, 0, 1e-4));
  EXPECT_EQ(At<ClassicMove>(evening, 0, 6).angles_deg, Vector3(0, -90, 20));
  EXPECT_EQ(At<ClassicAction>(evening, 1, 1).properties,
            (std::vector<std::string>{"color", "size"}));
  EXPECT_EQ(evening.segments[1].lines[2].frame, 6u);
  EXPECT_EQ(evening.segments[1].lines[2].number, 3);
  EXPECT_EQ(At<ClassicControlChange>(evening, 3, 1).state, "0");
  EXPECT_EQ(At<ClassicControlChange>(evening, 3, 1).object, "Lamp");
  EXPECT_EQ(At<ClassicAction>(evening, 4, 0).part, "Shade");
  const auto& fasten = At<ClassicAction>(evening, 5, 0);
  EXPECT_EQ(fasten.host + fasten.host_object + fasten.guest + fasten.object, "SocketLampPlugCup");
  EXPECT_EQ(fasten.tightness, 2);
}

TEST(ClassicReader, ReadsWhatContactAndToolsDidWithoutACommand) {
  const ClassicRecording work = ReadClassicTexts(std::vector<ClassicText>{
      {"0.txt",
       "0,create,Panel\n0,create,Shears\n0,initializeControl,Power,toggleSwitch,Panel,0\n"
       "1,press,Power,left_gripper\n2,press,Power,Shears\n3,press,Power\n"
       "4,use,left_gripper,Shears,cut,String between link 4 and 5\n"
       "5,use,hand,Shears,fasten,Panel\n"}});
  const auto words = [&](std::size_t line) {
    const auto& effect = At<ClassicEffect>(work, 0, line);
    return effect.arm + "," + effect.by + "," + effect.control + "," + effect.object + "," +
           effect.verb + "," + effect.part;
  };
  EXPECT_EQ(words(3), "left,,Power,Panel,,");
  EXPECT_EQ(words(4), ",Shears,Power,Panel,,");
  EXPECT_EQ(words(5), ",,Power,Panel,,");
  EXPECT_EQ(words(6), "left,Shears,,,cut,String between link 4 and 5");
  EXPECT_EQ(words(7), ",Shears,,,fasten,Panel");
  const auto refused = [](const std::string& line) {
    return Refusal({{"0.txt", "0,create,a\n" + line + "\n"}});
  };
  EXPECT_EQ(refused("0,press,Power,left_gripper"),
            "0.txt:2: \"Power\" is not a control, expected its initialization before");
  EXPECT_EQ(refused("0,use,left_gripper,b,cut,a"),
            "0.txt:2: \"b\" does not exist, expected a create line before");
  EXPECT_EQ(refused("0,use,left_gripper,a,saw,b"),
            "0.txt:2: found \"saw\", expected cut, fasten or loosen");
}

TEST(ClassicReader, ReadsReleasesAndDestructionsThatAreRecorded) {
  const ClassicRecording evening = ReadClassicTexts(kEvening);
  EXPECT_EQ(At<ClassicAction>(evening, 2, 0).object, "Cup");
  const auto& destroy = At<ClassicAction>(evening, 7, 0);
  EXPECT_EQ(destroy.kind, sim::EventKind::kDestroyed);
  EXPECT_EQ(destroy.object, "Cup");
  EXPECT_EQ(At<ClassicDelete>(evening, 7, 1).object, "Cup");
  EXPECT_EQ(At<ClassicAction>(evening, 8, 0).object, "");
}

TEST(ClassicReader, ReportsWhereWhatWasFoundAndExpected) {
  const auto refused = [](const std::string& line) {
    return Refusal({{"0.txt", "0,create,a\n" + line + "\n"}});
  };
  EXPECT_EQ(refused("0,move,a,1.0,2.0,3.0,0.0,0.0,x"),
            "0.txt:2: found \"x\", expected an angle about z: a number within +-1e+06");
  EXPECT_EQ(refused("0,move,a,1.0,NaN,3.0,0.0,0.0,0.0"),
            "0.txt:2: found \"NaN\", expected a position y: a number within +-1e+09");
  EXPECT_EQ(refused("0,move,a,1.0"), "0.txt:2: ends too early, expected a position y");
  EXPECT_EQ(refused("0,delete,a,b"), "0.txt:2: found \"b\", expected the end of the line");
  EXPECT_EQ(refused("0,create,b,shape"),
            "0.txt:2: ends too early, expected the value of \"shape\"");
  EXPECT_EQ(refused("-1,delete,a"), "0.txt:2: found \"-1\", expected a frame: 0 to 100000");
  EXPECT_EQ(refused("0,grasp,Lefthand,a"),
            "0.txt:2: found \"Lefthand\", expected LeftHand, RightHand, BothHands or AnyHand");
  EXPECT_EQ(refused("0,create,"),
            "0.txt:2: found \"\", expected an object: 1 to 100 characters without blanks");
  EXPECT_EQ(refused("0,create,b,label,\xff"), "0.txt:2: found an invalid byte, expected UTF-8");
  EXPECT_NE(refused("0,moved,a").find("0.txt:2: found \"moved\", expected create, delete, move,"),
            std::string::npos);
  EXPECT_NE(refused("0,moved,a").find("did you mean \"move\"?"), std::string::npos);
  // All of them at once.
  EXPECT_EQ(Refusal({{"0.txt", "x\n0,create,a\ny\n"}, {"1.txt", "z\n"}}),
            "0.txt:1: found \"x\", expected a frame: 0 to 100000\n"
            "0.txt:3: found \"y\", expected a frame: 0 to 100000\n"
            "1.txt:1: found \"z\", expected a frame: 0 to 100000");
}

TEST(ClassicReader, RefusesWhatContradictsTheLinesBefore) {
  const auto refused = [](const std::string& start, const std::string& next) {
    return Refusal({{"0.txt", "0,create,a\n" + start}, {"1.txt", next}});
  };
  EXPECT_EQ(refused("0,move,b,0,0,0,0,0,0\n", "1,grasp,AnyHand,a\n"),
            "0.txt:2: \"b\" does not exist, expected a create line before");
  EXPECT_EQ(refused("0,delete,a\n", "1,grasp,AnyHand,a\n"),
            "1.txt:1: \"a\" does not exist, expected a create line before");
  EXPECT_EQ(refused("0,create,a\n", "1,grasp,AnyHand,a\n"),
            "0.txt:2: \"a\" is created, but already exists");
  EXPECT_EQ(refused("", "1,trigger,AnyHand,s\n"),
            "1.txt:1: \"s\" is not a control, expected its initialization before");
  EXPECT_EQ(refused("3,delete,a\n", "2,release,AnyHand\n"), "1.txt:1: found frame 2 after frame 3");
  EXPECT_EQ(refused("", "1,destroy,AnyHand\n"),
            "1.txt:1: found no delete after destroy, expected one that names the object");
  EXPECT_EQ(refused("", "1,release,AnyHand\n1,release,LeftHand\n"),
            "1.txt:2: found another action, expected one per segment, in its first line");
  EXPECT_EQ(refused("5,grasp,AnyHand,a\n", ""),
            "0.txt:2: found another action, expected one per segment, in its first line");
  const std::string no_action =
      "found no action, expected grasp, release, destroy, trigger, pointTo, fasten, loosen, "
      "create or delete in the first line of a segment";
  EXPECT_EQ(refused("", ""), "1.txt: " + no_action);
  EXPECT_EQ(refused("", "1,move,a,0,0,0,0,0,0\n"), "1.txt:1: " + no_action);
}

TEST(ClassicReader, RespectsItsLimits) {
  EXPECT_EQ(
      Refusal({{"0.txt", "0,create,a,label," + std::string(100, 'x')}}, {.max_line_bytes = 100}),
      "0.txt:1: is longer than 100 bytes");
  EXPECT_EQ(Refusal({{"0.txt", "0,create,a\n0,create,b\n"}}, {.max_objects = 1}),
            "0.txt:2: contains more than 1 objects");
  EXPECT_EQ(Refusal({{"0.txt", "0,create,a\n100001,delete,a\n"}}),
            "0.txt:2: found \"100001\", expected a frame: 0 to 100000");
  std::string lines;
  for (int i = 0; i < 1000; ++i) lines += "?\n";
  try {
    ReadClassicTexts(std::vector<ClassicText>{{"0.txt", lines}});
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_EQ(error.diagnostics().size(), 100u);
  }
}

class ClassicDirectory : public ::testing::Test {
 protected:
  ClassicDirectory() {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    root_ = std::filesystem::temp_directory_path() /
            ("smile_classic_" + std::to_string(getpid()) + "_" + test->name());
    for (int i = 0; i < 2; ++i) std::filesystem::create_directories(root_ / std::to_string(i));
    Write("0.txt", "0,create,a\n0,move,a,0,0,0,0,0,0\n");
    Write("1.txt", "3,grasp,AnyHand,a\n");
    WritePng(root_ / "0/0.png", {.width_px = 2, .height_px = 1, .color = {1, 2, 3, 4, 5, 6}});
  }
  ~ClassicDirectory() override { std::filesystem::remove_all(root_); }

  void Write(const std::string& name, const std::string& text) const {
    std::ofstream(root_ / name) << text;
  }
  /// Finding, without the directory.
  std::string Answer() const {
    try {
      ReadClassic(root_);
    } catch (const InputError& error) {
      return std::string(error.what()).substr(root_.string().size());
    }
    return "";
  }

  std::filesystem::path root_;
};

TEST_F(ClassicDirectory, HasTextsAndPicturesAndMayHaveOtherThings) {
  Write("readme.txt", "hello");
  Write("01.txt", "hello");
  Write("0/notes", "hello");
  WritePng(root_ / "1/12.png", {.width_px = 2, .height_px = 1, .color = {1, 2, 3, 4, 5, 6}});
  const ClassicRecording recording = ReadClassic(root_);
  EXPECT_EQ(recording.segments.size(), 2u);
  EXPECT_EQ(recording.pictures, (std::vector<ClassicPicture>{{0, 0}, {1, 12}}));
  EXPECT_EQ(recording.picture_width_px, 2);
  EXPECT_EQ(recording.last_frame(), 12u);
}

TEST_F(ClassicDirectory, IsCompleteAndIsNoRecording) {
  Write("3.txt", "");
  EXPECT_EQ(Answer(), ": has 3.txt, but no 2.txt");
  Write("demo.json", "{}");
  EXPECT_EQ(Answer(), ": has a demo.json: it is already a recording and does not need an import");
  std::filesystem::remove_all(root_);
  EXPECT_EQ(Answer(), ": is not a directory, expected the directory of a classic recording");
  std::filesystem::create_directories(root_);
  EXPECT_EQ(Answer(),
            ": has no 0.txt, expected a classic recording: 0.txt, 1.txt, … and a folder of "
            "pictures for each");
}

TEST_F(ClassicDirectory, DoesNotFollowLinks) {
  std::filesystem::create_symlink("/etc/hostname", root_ / "0/1.png");
  EXPECT_EQ(Answer(), "/0/1.png: is a link, expected the file itself");
  std::filesystem::create_symlink("/etc/hostname", root_ / "2.txt");
  EXPECT_EQ(Answer(), "/2.txt: is a link, expected the file itself");
  std::filesystem::remove(root_ / "2.txt");
  std::filesystem::remove_all(root_ / "0");
  std::filesystem::create_directory_symlink("/etc", root_ / "0");
  EXPECT_EQ(Answer(), "/0: is a link, expected the file itself");
}

TEST_F(ClassicDirectory, HasSoundPicturesOfOneSize) {
  WritePng(root_ / "1/3.png", {.width_px = 1, .height_px = 1, .color = {1, 2, 3}});
  EXPECT_EQ(Answer(), "/1/3.png: is 1x1 pixels, expected 2x1 as the first picture");
  Write("1/3.png", "no picture");
  EXPECT_EQ(Answer(), "/1/3.png: is not a readable PNG of at most 8192 pixels per side");
}

TEST(Placeholders, FollowTheDescriptions) {
  const scene::SceneSpec scene = MakePlaceholders(ReadClassicTexts(kEvening));
  ASSERT_EQ(scene.objects.size(), 3u);
  const scene::ObjectSpec& cup = scene.objects[0];
  EXPECT_EQ(std::get<scene::Block>(cup.whole.shape).size, Vector3(0.2, 0.1, 0.05));
  EXPECT_LT((cup.pose_in_world().translation() - Vector3(0.2, 0, 1e-5)).norm(), 1e-12);
  EXPECT_EQ(cup.descriptions[1], (scene::Description{"label", "white, chipped"}));
  EXPECT_EQ(scene.objects[1].whole.color, *ParseColor("green"));
  EXPECT_EQ(scene.objects[2].descriptions[0], (scene::Description{"shape", "block"}));
  EXPECT_NE(cup.whole.color, scene.objects[2].whole.color);
}

TEST(Placeholders, HaveIdsASceneMayHave) {
  const scene::SceneSpec scene = MakePlaceholders(ReadClassicTexts(std::vector<ClassicText>{
      {"0.txt", "0,create,rope-start\n0,create,rope_start\n0,create,b#2\n0,create,#\n"}}));
  std::vector<std::string> ids;
  for (const auto& object : scene.objects) ids.push_back(object.id());
  EXPECT_EQ(ids, (std::vector<std::string>{"rope_start", "rope_start#0", "b#2", "_"}));
}

TEST(Placeholders, ReportInvalidSizes) {
  for (const std::string size : {"big", "0", "-1", "1e9"}) {
    const auto recording = ReadClassicTexts(
        std::vector<ClassicText>{{"0.txt", "0,create,a\n0,create,b,bboxy," + size + "\n"}});
    try {
      MakePlaceholders(recording);
      ADD_FAILURE() << size;
    } catch (const InputError& error) {
      EXPECT_EQ(error.diagnostics().at(0).line, 2) << error.what();
    }
  }
}

class DamagedTexts : public ::testing::TestWithParam<unsigned> {};

INSTANTIATE_TEST_SUITE_P(Seeds, DamagedTexts, testing::Range(1u, 9u));

TEST_P(DamagedTexts, AreRefusedWithAPlaceOrRead) {
  std::mt19937 random(GetParam());
  int num_read = 0;
  for (int round = 0; round < 300; ++round) {
    std::vector<ClassicText> texts = kEvening;
    for (unsigned i = 0; i <= random() % 3; ++i) {
      Damage(&texts[random() % texts.size()].text, &random);
    }
    try {
      const scene::SceneSpec scene = MakePlaceholders(ReadClassicTexts(texts));
      const auto reading =
          scene_xml::ReadSceneText(scene_xml::WriteScene(scene), "placeholders.xml");
      ASSERT_TRUE(reading.scene) << ToString(reading.diagnostics.at(0));
      EXPECT_EQ(reading.scene->objects, scene.objects);
      ++num_read;
    } catch (const InputError& error) {
      for (const Diagnostic& finding : error.diagnostics()) {
        EXPECT_TRUE(finding.file.ends_with(".txt")) << ToString(finding);
        EXPECT_FALSE(finding.message.empty());
      }
    }
  }
  EXPECT_GT(num_read, 10);
  EXPECT_LT(num_read, 290);
}

}  // namespace
}  // namespace smile::classic
