#include <filesystem>
#include <map>
#include <set>

#include "program.h"

namespace smile {
namespace {

class Rerender : public ProgramTest {
 protected:
  void SetUp() override {
    Write("pair.xml", PairOfBlocks());
    Write("stack.jsonl", StackPair());
    ASSERT_EQ(Smile("run pair.xml --commands stack.jsonl --size 160x120 --rate 8 --record demo")
                  .exit_code,
              0);
  }

  /// All files below a directory, with what is in them.
  std::map<std::string, std::string> FilesOf(const std::string& name) const {
    std::map<std::string, std::string> files;
    const auto root = directory_ / name;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root)) {
      if (!entry.is_regular_file()) continue;
      const std::string path = std::filesystem::relative(entry.path(), root).string();
      files[path] = Read(name + "/" + path);
    }
    return files;
  }

  /// The files that are not the same in both.
  std::set<std::string> Differing(const std::string& one, const std::string& other) const {
    const auto a = FilesOf(one), b = FilesOf(other);
    std::set<std::string> differing;
    for (const auto& [path, text] : a) {
      if (!b.contains(path) || b.at(path) != text) differing.insert(path);
    }
    for (const auto& [path, text] : b) {
      if (!a.contains(path)) differing.insert(path);
    }
    return differing;
  }
};

TEST_F(Rerender, InvisibleGivesIdenticalPictures) {
  const Answer answer = Smile("rerender demo --demonstrator invisible --out same");
  EXPECT_EQ(answer.exit_code, 0) << answer.err;
  EXPECT_EQ(Differing("demo", "same"), std::set<std::string>());
}

TEST_F(Rerender, ChangesOnlyPictures) {
  for (const std::string appearance : {"ghost", "forearm"}) {
    const Answer answer =
        Smile("rerender demo --demonstrator " + appearance + " --json --out " + appearance);
    ASSERT_EQ(answer.exit_code, 0) << answer.err;
    int num_pictures = 0;
    for (const std::string& path : Differing("demo", appearance)) {
      if (path == "demo.json") continue;
      EXPECT_TRUE(path.ends_with(".png")) << path;
      EXPECT_TRUE(Exists("demo/" + path) && Exists(appearance + "/" + path)) << path;
      ++num_pictures;
    }
    EXPECT_EQ(num_pictures, answer.json()["pictures"]);
    EXPECT_GT(num_pictures, 5);
    Json info = Json::parse(Read(appearance + "/demo.json"));
    EXPECT_EQ(info["demonstrator"], appearance);
    info.erase("demonstrator");
    EXPECT_EQ(info, Json::parse(Read("demo/demo.json")));
    EXPECT_EQ(Smile("replay " + appearance + " --verify").exit_code, 0);
  }
  // A film of the same appearance shows the same.
  ASSERT_EQ(
      Smile("render demo --camera eye --size 160x120 --rate 8 --demonstrator forearm --out f/")
          .exit_code,
      0);
  EXPECT_TRUE(Read("f/000004.png") == Read("forearm/1/4.png"));
  // A copy can be rendered again, here by the earlier name of the command.
  ASSERT_EQ(Smile("dress forearm --demonstrator invisible --out back").exit_code, 0);
  EXPECT_EQ(Differing("demo", "back"), std::set<std::string>());
}

TEST_F(Rerender, OmitsTextsOnRequest) {
  ASSERT_EQ(Smile("rerender demo --demonstrator forearm --no-symbols --out mute").exit_code, 0);
  for (const auto& [path, text] : FilesOf("mute")) EXPECT_FALSE(path.ends_with(".txt")) << path;
  EXPECT_EQ(Json::parse(Read("mute/demo.json"))["has_symbols"], false);
  EXPECT_TRUE(Read("mute/frames.csv") == Read("demo/frames.csv"));
  EXPECT_EQ(Smile("replay mute --verify").exit_code, 0);
  EXPECT_NE(Smile("rerender mute --demonstrator ghost --out texts").err.find("has no texts"),
            std::string::npos);
}

TEST_F(Rerender, ReportsInvalidRequests) {
  EXPECT_EQ(Smile("rerender demo --demonstrator gost --out x").err,
            "smile: demonstrator is \"gost\", expected invisible, ghost or forearm\n");
  EXPECT_EQ(Smile("rerender demo --demonstrator ghost --out demo").exit_code, 1);
  EXPECT_EQ(Smile("rerender demo --demonstrator ghost --out demo/new").exit_code, 1);
  EXPECT_EQ(Smile("render pair.xml --demonstrator ghost --out x.png").err,
            "smile: --demonstrator needs a recording, but 'pair.xml' is not one\n");
  ASSERT_EQ(Smile("run pair.xml --seconds 1 --no-pictures --record blind").exit_code, 0);
  EXPECT_NE(Smile("rerender blind --demonstrator ghost --out x").err.find("has no pictures"),
            std::string::npos);
  ASSERT_EQ(Smile("rerender demo --demonstrator ghost --out ghost").exit_code, 0);
  const Answer on = Smile("checkout ghost --seconds 1");
  EXPECT_EQ(on.exit_code, 1);
  EXPECT_EQ(
      on.err,
      "ghost: is a copy that shows its demonstrator; continue the original recording instead\n");
  Write("demo/frames.csv", "frame,tick,image\n0,0,../../x.png\n");
  EXPECT_EQ(Smile("rerender demo --demonstrator ghost --out x").err,
            "demo/frames.csv:2: found \"0,0,../../x.png\", expected a picture like 3/14.png\n");
  Write("demo/frames.csv", "frame,tick,image\n0,999999,0/0.png\n");
  EXPECT_EQ(Smile("rerender demo --demonstrator ghost --out x").exit_code, 1);
  EXPECT_FALSE(Exists("x"));
}

}  // namespace
}  // namespace smile
