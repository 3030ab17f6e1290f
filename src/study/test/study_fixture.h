#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "base/diagnostic.h"
#include "base/files.h"
#include "base/json.h"
#include "base/temporary_directory.h"
#include "study/definition.h"
#include "study/event_log.h"
#include "study/participants.h"
#include "study/steps.h"
#include "web_server/digest.h"

namespace smile::study {

/// A study of three conditions in a folder of its own, and the data of its participants.
class StudyTest : public ::testing::Test {
 protected:
  StudyTest() {
    Write("consent.txt", "You may stop at any time.\n");
    Write("pair.xml",
          "<tabletop xmlns=\"http://synapse.cs.umd.edu/tabletop-xml\">\n"
          "<block id=\"a\" color=\"red\" location=\"(0, -3, 0.5)\"/>\n"
          "<block id=\"b\" color=\"blue\" location=\"(2, -3, 0.5)\"/>\n</tabletop>\n");
    WriteStudy(Study());
  }

  static Json Study() {
    return Json::parse(R"({
      "format": 1, "name": "aids", "title": "Aids", "consent": "consent.txt",
      "conditions": [{"name": "none", "ghost": false, "rings": false},
                     {"name": "ghost", "rings": false}, {"name": "snap", "snap": ["faces"]}],
      "instructions": [{"title": "Hello", "text": "Read this."}],
      "practice": {"title": "Try", "text": "Put a on b.", "scene": "pair.xml",
                   "goal": [{"object": "a", "on": "b"}], "max_attempts": 2},
      "tasks": [{"name": "stack", "title": "Stack", "text": "Put a on b.", "scene": "pair.xml",
                 "goal": [{"object": "a", "on": "b"}], "limit_seconds": 60}],
      "break_seconds": 1,
      "after_condition": [{"type": "nasa-tlx"}],
      "at_end": [{"type": "sus"}, {"type": "survey-text", "name": "remarks",
                  "questions": [{"prompt": "Remarks?", "name": "remarks", "required": false}]}]
    })");
  }

  void Write(const std::string& name, const std::string& text) const {
    WriteFile(folder() / name, text);
  }
  void WriteStudy(const Json& study) const { Write("STUDY.json", ToText(study, 2) + "\n"); }

  const std::filesystem::path& folder() const { return directory_.path(); }
  std::filesystem::path file() const { return folder() / "STUDY.json"; }
  std::filesystem::path data_folder() const { return folder() / "data"; }

  StudyData Data(int count) const {
    StudyData data = StudyData::OpenOrMake(data_folder(), file(), ReadDefinition(file()));
    data.Add(count);
    return data;
  }

  /// Returns the message about a faulty study; empty if there is none.
  std::string Fault(const Json& study) const {
    WriteStudy(study);
    try {
      ReadDefinition(file());
    } catch (const InputError& error) {
      std::string message = error.what();
      const std::string prefix = file().string() + ":";
      return message.starts_with(prefix) ? message.substr(prefix.size()) : message;
    }
    return "";
  }

  /// Returns answers of this number to all questions.
  static Json AnswersOf(const Questionnaire& questionnaire, int number) {
    Json answers = Json::object();
    for (const Question& question : questionnaire.questions) {
      if (question.is_scale || !question.labels.empty()) answers[question.name] = number;
    }
    return answers;
  }

  /// Writes the events of a participant who does everything.
  /// @param seconds  wall-clock time of each trial.
  static void Complete(const StudyData& data, const Participant& participant, double seconds,
                       const std::string& recording = "") {
    EventLog log(participant.events_file());
    log.Add("consent", {{"agreed", true}, {"sha256", web_server::Sha256(data.study().consent)}});
    for (const Step& step : StepsOf(data.study(), participant.number)) {
      log.Add("begin", {{"step", step.name}});
      if (step.is_trial()) {
        log.Add("trial",
                {{"step", step.name}, {"attempt", 1}, {"folder", "trials/" + step.name + "-1"}});
        log.Add("trial_end", {{"step", step.name},
                              {"reason", "done"},
                              {"recording", recording},
                              {"wall_seconds", seconds},
                              {"success", true}});
      }
      if (step.kind == StepKind::kQuestions) {
        const int number = step.questionnaire.type == "sus" ? 3 : 40;
        log.Add("answers",
                {{"step", step.name}, {"answers", AnswersOf(step.questionnaire, number)}});
      }
      if (step.kind == StepKind::kThanks) log.Add("code", {{"code", "C0DE"}});
      log.Add("done", {{"step", step.name}});
    }
  }

 private:
  TemporaryDirectory directory_;
};

}  // namespace smile::study
