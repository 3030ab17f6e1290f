#include "report/experiment_page.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include "base/files.h"
#include "recorder/recorder.h"

namespace smile::report {
namespace {

constexpr const char* kBlock = "b1";
constexpr const char* kHostile = "<img src=http://x>";

scene::SceneSpec OneBlock() {
  scene::SceneSpec scene;
  scene.objects.push_back(
      {.whole = {
           .id = kBlock, .X_PE = RigidTransform(Vector3(0, 0, 0.05)), .shape = scene::Block{}}});
  return scene;
}

Json Pose(double x) { return {{"position", {x, 0, 0.5}}, {"rotation", {0, 0, 0}}}; }

Json ResultOf(const Json& final_objects) {
  return {{"format", 2},
          {"task", kHostile},
          {"success", false},
          {"score", 0.0},
          {"tolerance", 0.25},
          {"match", {{kBlock, kBlock}}},
          {"goal", {{"objects", {{kBlock, Pose(1)}}}}},
          {"final", {{"objects", final_objects}}},
          {"mean_error_mm", 100.0},
          {"seconds", 1.0},
          {"realtime_factor", 2.0},
          {"claim_right", false},
          {"brain",
           {{"status", "failed"},
            {"message", std::string("oh ") + kHostile},
            {"claim", {{"done", true}, {"reason", std::string("see ") + kHostile}}}}}};
}

class ExperimentPage : public ::testing::Test {
 protected:
  /// Of a table without a robot, for a moment.
  ExperimentPage() {
    sim::Simulation simulation(OneBlock());
    recorder::Recorder recorder(directory_, {}, nullptr, simulation);
    simulation.AddListener(&recorder);
    for (int i = 0; i < 3; ++i) simulation.Tick();
  }
  ~ExperimentPage() override { std::filesystem::remove_all(directory_); }

  std::string PageWith(const Json& result) const {
    const recording::Recording recording = recording::OpenRecording(directory_);
    return PageOf({.name = kHostile,
                   .demonstration = recording,
                   .imitation = recording,
                   .result = result,
                   .enclosures = {{kHostile, kHostile}}});
  }

  std::filesystem::path directory_ = std::filesystem::temp_directory_path() /
                                     ("smile_" + std::to_string(getpid()) + "_experiment_page");
};

TEST_F(ExperimentPage, HostileNamesAndMessagesAreTextsOnly) {
  const std::string page = PageWith(ResultOf({{kBlock, Pose(0)}}));
  EXPECT_EQ(page.find("<img src=http"), std::string::npos);
  EXPECT_EQ(page.find("\"http"), std::string::npos);
  EXPECT_NE(page.find("oh &lt;img src=http://x&gt;"), std::string::npos);
  EXPECT_NE(page.find("href=\"./%3Cimg%20src%3Dhttp%3A//x%3E\""), std::string::npos);
}

TEST_F(ExperimentPage, ShowsPicturesPlacesAndErrors) {
  Json result = ResultOf({{kBlock, Pose(0)}});
  result["effects"] = {{{"kind", "pressed"}, {"text", "Bell pressed"}, {"achieved", false}}};
  const std::string page = PageWith(result);
  EXPECT_NE(page.find("Bell pressed"), std::string::npos);
  EXPECT_NE(page.find("src=\"data:image/png;base64,iVBOR"), std::string::npos);
  EXPECT_NE(page.find("1.00, 0.00, 0.50"), std::string::npos);
  EXPECT_NE(page.find("too far"), std::string::npos);
  EXPECT_NE(page.find("100.0"), std::string::npos);  // one unit off [mm]
  EXPECT_NE(page.find("<dd>done (wrong)</dd>"), std::string::npos);
  EXPECT_NE(page.find("done (wrong): see &lt;img src=http://x&gt;"), std::string::npos);
}

TEST_F(ExperimentPage, QuotesWhatTheBrainPrinted) {
  std::string log = std::string("I saw ") + kHostile + "\n";
  for (int i = 0; i < 1000; ++i) log += "line " + std::to_string(i) + "\n";
  WriteFile(directory_ / "brain.log", log);
  const std::string page = PageWith(ResultOf({{kBlock, Pose(0)}}));
  EXPECT_NE(page.find("I saw &lt;img src=http://x&gt;"), std::string::npos);
  EXPECT_NE(page.find("line 198\n[751 lines left out]\nline 950\n"), std::string::npos);
  EXPECT_NE(page.find("line 999"), std::string::npos);
}

TEST_F(ExperimentPage, ShowsWhatTheBrainUnderstoodPlannedAndSaw) {
  const std::string top = R"([{"middle":[0,0,1],"sides":[1,1],"yaw":0}])";
  WriteFile(directory_ / "notes.jsonl",
            R"({"tick":0,"note":"understood","text":"The goal:"})"
            "\n"
            R"({"tick":0,"note":"understood","text":"b1 is on <b>"})"
            "\nno note\n"
            R"({"tick":0,"note":"action","text":"carries b1"})"
            "\n"
            R"({"tick":2,"note":"contradicted","text":"b1: it is not there","expected":)" +
                top + ",\"found\":" + top + "}\n");
  const std::string page = PageWith(ResultOf({{kBlock, Pose(0)}}));
  EXPECT_NE(page.find("<h3>The goal:</h3><ul><li>b1 is on &lt;b&gt;</li></ul>"), std::string::npos);
  EXPECT_NE(page.find("0.0 s: carries b1"), std::string::npos);
  EXPECT_NE(page.find("<span class=\"badge bad\">contradicted</span> b1: it is not there"),
            std::string::npos);
  EXPECT_NE(page.find("class=\"expected bad moved\""), std::string::npos);
  EXPECT_NE(page.find("class=\"found\""), std::string::npos);
  EXPECT_NE(page.find("What it claims"), std::string::npos);
}

TEST_F(ExperimentPage, ShowsTheCameraOfANote) {
  const auto noted = [](const std::string& camera) {
    return R"({"tick":2,"note":"saw","text":"1 more","camera":")" + camera +
           R"(","found":[{"middle":[0,0,1],"sides":[1,1],"yaw":0}]})"
           "\n";
  };
  WriteFile(directory_ / "notes.jsonl", noted("eye"));
  std::string page = PageWith(ResultOf({{kBlock, Pose(0)}}));
  EXPECT_NE(page.find("<span class=\"badge good\">saw</span> 1 more"), std::string::npos);
  EXPECT_NE(page.find("What the camera eye saw"), std::string::npos);
  EXPECT_NE(page.find("class=\"found\""), std::string::npos);
  // The file may be another program's: a camera that is not there has no picture.
  WriteFile(directory_ / "notes.jsonl", noted(kHostile));
  page = PageWith(ResultOf({{kBlock, Pose(0)}}));
  EXPECT_NE(page.find("</span> 1 more"), std::string::npos);
  EXPECT_EQ(page.find("class=\"found\""), std::string::npos);
}

TEST_F(ExperimentPage, ReportsMissingObjects) {
  const std::string page = PageWith(ResultOf(Json::object()));
  EXPECT_NE(page.find("missing"), std::string::npos);
  EXPECT_EQ(page.find("too far"), std::string::npos);
}

}  // namespace
}  // namespace smile::report
