#include "study/definition.h"

#include "study/internal_json_lines.h"
#include "study_fixture.h"

namespace smile::study {
namespace {

class DefinitionFile : public StudyTest {};

TEST_F(DefinitionFile, IsRead) {
  const Definition study = ReadDefinition(file());
  EXPECT_EQ(study.name, "aids");
  EXPECT_EQ(study.consent, "You may stop at any time.\n");
  ASSERT_EQ(study.conditions.size(), 3u);
  EXPECT_FALSE(study.conditions[0].aids.has_ghost);
  EXPECT_TRUE(study.conditions[1].aids.has_ghost);
  EXPECT_EQ(study.conditions[2].aids.snap, std::vector<std::string>{"faces"});
  EXPECT_EQ(study.practice->max_attempts, 2);
  ASSERT_EQ(study.tasks.size(), 1u);
  EXPECT_EQ(study.tasks[0].goal[0], (model::Relation{.object = "a", .support = "b"}));
  EXPECT_EQ(study.after_condition[0].questions.size(), 6u);
  EXPECT_EQ(study.at_end[0].questions.size(), 10u);
}

TEST_F(DefinitionFile, ReportsFaultsWithLineAndElement) {
  const auto with = [](const std::function<void(Json*)>& change) {
    Json study = Study();
    change(&study);
    return study;
  };
  EXPECT_EQ(Fault(with([](Json* study) { (*study)["tasks"][0]["goal"][0]["on"] = "c"; })),
            "50: <tasks/0/goal/0/on>: found \"c\", expected an object of the scene");
  EXPECT_EQ(
      Fault(with([](Json* study) { (*study)["conditions"][2]["snap"][0] = "face"; })),
      "19: <conditions/2/snap/0>: found \"face\", expected rails, faces, edges, grid or angles");
  EXPECT_EQ(Fault(with([](Json* study) { (*study)["format"] = 2; })),
            "2: <format>: found 2, expected a whole number from 1 to 1");
  EXPECT_EQ(Fault(with([](Json* study) { (*study)["name"] = "My study"; })),
            "3: <name>: found \"My study\", expected small letters, digits, - and _");
  EXPECT_EQ(Fault(with([](Json* study) { (*study)["tasks"][0]["scene"] = "no.xml"; })),
            "46: <tasks/0/scene>: found \"no.xml\", expected a file");
  EXPECT_EQ(Fault(with([](Json* study) { (*study)["conditions"][1]["name"] = "none"; })),
            "13: <conditions/1/name>: found \"none\" twice");
  EXPECT_EQ(
      Fault(with([](Json* study) { (*study)["tasks_per_condition"] = "one"; })),
      "78: <tasks_per_condition>: there are 1 tasks and 3 conditions, expected equal numbers");
  EXPECT_EQ(
      Fault(with([](Json* study) { (*study)["completion_url"] = "http://a"; })),
      "78: <completion_url>: found \"http://a\", expected an address that begins with https://");
  EXPECT_EQ(Fault(with([](Json* study) { (*study)["at_end"][0]["type"] = "sos"; })),
            "64: <at_end/0/type>: found \"sos\", expected nasa-tlx, sus, survey-likert or "
            "survey-text; did you mean \"sus\"?");
}

TEST_F(DefinitionFile, NamesNoFileOutsideItsFolder) {
  Json study = Study();
  study["consent"] = "/etc/hostname";
  EXPECT_NE(Fault(study).find("expected a file below the folder of the study"), std::string::npos);
}

TEST_F(DefinitionFile, ReportsUnknownMembersAndBrokenText) {
  Json study = Study();
  study["task"] = Json::array();
  EXPECT_NE(Fault(study).find("did you mean \"tasks\"?"), std::string::npos);
  Write("STUDY.json", "{\"format\": 1,\n");
  EXPECT_THROW(ReadDefinition(file()), InputError);
}

TEST_F(DefinitionFile, NamesALanguageOfThePage) {
  Json study = Study();
  study["language"] = "de";
  Fault(study);
  EXPECT_EQ(ReadDefinition(file()).language, "de");
  study["language"] = "xx";
  EXPECT_NE(Fault(study).find("found \"xx\", expected de or en"), std::string::npos)
      << Fault(study);
}

TEST(JsonLines, FindsTheLineOfAnElement) {
  const std::string text = "{\n \"a\": [1,\n  {\"b\": \"x\\\"}\"}],\n \"c\": 2\n}";
  EXPECT_EQ(LineOf(text, ""), 1);
  EXPECT_EQ(LineOf(text, "a"), 2);
  EXPECT_EQ(LineOf(text, "a/1/b"), 3);
  EXPECT_EQ(LineOf(text, "c"), 4);
  EXPECT_EQ(LineOf(text, "a/1/missing"), 3);
}

}  // namespace
}  // namespace smile::study
