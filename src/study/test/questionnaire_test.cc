#include "study/questionnaire.h"

#include "study_fixture.h"

namespace smile::study {
namespace {

class Questionnaires : public StudyTest {
 protected:
  Questionnaire Read(const Json& json) const {
    const std::string name = "study";
    return ReadQuestionnaire(JsonNode(json, name, ""));
  }
};

TEST_F(Questionnaires, ScoreTheTaskLoadByTheMean) {
  const Questionnaire load = Read({{"type", "nasa-tlx"}});
  const Answers answers = CheckedAnswers(load, {{"mental", 10},
                                                {"physical", 20},
                                                {"temporal", 30},
                                                {"performance", 40},
                                                {"effort", 50},
                                                {"frustration", 60}});
  EXPECT_EQ(ScoreOf(load, answers), 35);
}

TEST_F(Questionnaires, ScoreUsabilityAsBrookeDoes) {
  const Questionnaire usability = Read({{"type", "sus"}});
  // Full agreement with praise, and none with complaints, is 100; the middle is 50.
  Json best = Json::object();
  for (int k = 1; k <= 10; ++k) best["sus" + std::to_string(k)] = k % 2 == 1 ? 4 : 0;
  EXPECT_EQ(ScoreOf(usability, CheckedAnswers(usability, best)), 100);
  EXPECT_EQ(ScoreOf(usability, CheckedAnswers(usability, AnswersOf(usability, 2))), 50);
  // Full agreement with everything: 5 * 4 of 40 points.
  EXPECT_EQ(ScoreOf(usability, CheckedAnswers(usability, AnswersOf(usability, 4))), 50);
}

TEST_F(Questionnaires, RefuseWrongAnswers) {
  const Questionnaire load = Read({{"type", "nasa-tlx"}});
  Json answers = AnswersOf(load, 50);
  EXPECT_EQ(CheckedAnswers(load, answers).size(), 6u);
  for (const Json& wrong : {Json(52), Json(105), Json(-5), Json("50"), Json(nullptr)}) {
    answers["effort"] = wrong;
    EXPECT_THROW(CheckedAnswers(load, answers), std::invalid_argument) << wrong;
  }
  answers["effort"] = 50;
  answers["other"] = 1;
  EXPECT_THROW(CheckedAnswers(load, answers), std::invalid_argument);
  EXPECT_THROW(CheckedAnswers(load, Json::array()), std::invalid_argument);
  const Questionnaire text =
      Read(Json::parse(R"({"type": "survey-text", "questions": [{"prompt": "?", "name": "q"}]})"));
  EXPECT_THROW(CheckedAnswers(text, {{"q", std::string(kMaxAnswerBytes + 1, 'x')}}),
               std::invalid_argument);
}

TEST_F(Questionnaires, ReadQuestionsOfJsPsych) {
  const Questionnaire likert = Read(Json::parse(
      R"({"type": "survey-likert", "name": "opinion", "preamble": "How was it?",
          "questions": [{"prompt": "Easy", "name": "easy", "labels": ["no", "so", "yes"],
                         "required": true}]})"));
  EXPECT_EQ(likert.questions[0].labels.size(), 3u);
  EXPECT_EQ(CheckedAnswers(likert, {{"easy", 2}}).at("easy"), 2);
  EXPECT_THROW(CheckedAnswers(likert, {{"easy", 3}}), std::invalid_argument);
}

// The examples of FIPS 180-4, as published by NIST.
TEST(Sha256Hash, IsThatOfTheStandard) {
  EXPECT_EQ(web_server::Sha256("abc"),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(web_server::Sha256(""),
            "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(web_server::Sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
}

}  // namespace
}  // namespace smile::study
