#include "report/experiment_page.h"

#include <filesystem>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "base/files.h"
#include "image/png.h"
#include "picture/recording_renderer.h"
#include "recording/recording_history.h"
#include "recording/time_range.h"
#include "report/internal_account.h"
#include "report/internal_activity.h"
#include "report/internal_placements.h"
#include "report/internal_table.h"
#include "report/markup.h"
#include "report/wording.h"
#include "scene/units.h"
#include "task/imitation_result.h"

// The page of one experiment: demonstration and imitation next to each other, in pictures, poses
// and time. It is drawn from the two recordings and the result, without simulation.

namespace smile::report {
namespace {

// In pixels: two pictures fit beside each other.
constexpr int kPictureWidth = 560, kPictureHeight = 420;

/// Returns a picture with words below it.
Markup Captioned(const Markup& picture, const std::string& words) {
  Markup figure = picture;
  figure += Element("figcaption", {}, words);
  return Element("figure", {}, figure);
}

/// Returns pictures of the first and the last tick, from a view for people and from the robot's
/// eye.
Markup PicturesOf(const recording::Recording& recording, const std::string& whose) {
  const recording::TickRange ticks = TicksOf(recording);
  const model::Model& model = *recording.model;
  Markup gallery;
  for (const char* camera : {"nice", model::kEyeCamera}) {
    const bool is_eye = camera == std::string_view(model::kEyeCamera);
    // The eye is a camera of the robot.
    if (is_eye && !recording.robot()) continue;
    picture::RecordingRenderer renderer(model, {.camera = camera,
                                                .eye = recording.info.eye_camera,
                                                .width_px = kPictureWidth,
                                                .height_px = kPictureHeight,
                                                .channels = {}});
    for (std::uint64_t tick : {ticks.first, ticks.last}) {
      const auto moment = MomentAt(recording, tick);
      if (!moment) continue;
      const std::string words = whose + (tick == ticks.first ? ", start" : ", end") +
                                (is_eye ? ", view of the robot's eye" : "");
      gallery += Captioned(Picture(EncodePng(renderer.Take(*moment)), words), words);
    }
  }
  return Element("div", {{"class", "gallery"}}, gallery);
}

bool HasSucceeded(const Json& result) {
  // JsonNode keeps a reference to the name, for messages.
  static const std::string file = "result.json";
  return task::ReadSuccess(JsonNode(result, file, ""));
}

/// Returns the reason of a failure.
std::string FailureText(const Json& result) {
  // Results of older versions have only the status of the brain.
  if (result.contains("cause") && !result.at("cause").is_null()) {
    return result.at("cause").at("word").get<std::string>() + ": " +
           result.at("cause").at("text").get<std::string>();
  }
  const auto status = result.at("brain").at("status").get<std::string>();
  if (status == "running") return "the brain was still running when the episode ended";
  return "the brain " + status + ", and the structure differs from the demonstration";
}

Markup HeaderOf(const ExperimentOutcome& outcome) {
  const bool has_succeeded = HasSucceeded(outcome.result);
  Markup header = Element("p", {{"class", "eyebrow"}}, "SMILE experiment: " + outcome.name);
  header += Element("h1", {},
                    has_succeeded ? "The robot watched and rebuilt the structure"
                                  : "The robot watched but failed to rebuild the structure");
  header += Badge(has_succeeded, has_succeeded ? "success" : "failure");
  if (!has_succeeded) {
    header += Element("p", {{"class", "lead"}}, FailureText(outcome.result));
    const auto message = outcome.result.at("brain").at("message").get<std::string>();
    if (!message.empty()) header += Element("pre", {}, message);
  }
  return Element("header", {}, header);
}

/// Returns what the brain claimed about its run; nullptr if it claimed nothing, and in results of
/// older versions.
const Json* ClaimIn(const Json& result) {
  const Json& brain = result.at("brain");
  return brain.contains("claim") && brain.at("claim").is_object() ? &brain.at("claim") : nullptr;
}

/// Returns a claim in a few words, and whether it is true.
std::string ClaimText(const Json& claim, const Json& result) {
  return std::string(claim.at("done").get<bool>() ? "done" : "gave up") +
         (result.at("claim_right").get<bool>() ? " (right)" : " (wrong)");
}

/// Returns a section with the reason that the brain gave for its claim, if it gave one.
Markup ClaimOf(const Json& result) {
  const Json* claim = ClaimIn(result);
  if (claim == nullptr || claim->at("reason") == "") return {};
  const auto reason = claim->at("reason").get<std::string>();
  return Section("What it claims",
                 Element("p", {{"class", "lead"}}, ClaimText(*claim, result) + ": " + reason));
}

/// Returns the score, the mean errors and the duration.
Markup Numbers(const Json& result) {
  const auto number = [&result](const char* name) { return result.at(name).get<double>(); };
  Markup facts = Fact("Structure in place", Percent(number("score")));
  if (const Json* claim = ClaimIn(result)) {
    facts += Fact("The brain's claim", ClaimText(*claim, result));
  }
  facts += Fact("Mean error", Fixed(number("mean_error_mm"), 1) + " mm");
  if (result.contains("mean_error_degrees") && !result.at("mean_error_degrees").is_null()) {
    facts += Fact("Mean rotation error", Fixed(number("mean_error_degrees"), 1) + "°");
  }
  facts += Fact("Robot time", Fixed(number("seconds"), 1) + " s");
  facts += Fact("Speed, wall-clock", Fixed(number("realtime_factor"), 1) + " × real time");
  return Element("section", {}, Element("dl", {{"class", "facts figure"}}, facts));
}

/// Returns a position as in scene files, to 0.01 units.
std::string PositionText(const RigidTransform& X_WB, double meters_per_unit) {
  const Vector3 p = scene::ToFileUnits(X_WB.translation(), meters_per_unit);
  return Fixed(p.x(), 2) + ", " + Fixed(p.y(), 2) + ", " + Fixed(p.z(), 2);
}

/// Returns one row per object: where it was wanted, where it is, and if that is near enough.
Markup PlacementTable(const std::vector<Placement>& placements, double meters_per_unit,
                      double tolerance_mm) {
  Markup rows;
  for (const Placement& placement : placements) {
    const bool is_near = placement.IsWithin(tolerance_mm);
    rows += Row(
        {RowHead(placement.object), NumberCell(PositionText(placement.X_WWanted, meters_per_unit)),
         NumberCell(placement.X_WReached ? PositionText(*placement.X_WReached, meters_per_unit)
                                         : "missing"),
         NumberCell(Fixed(placement.error_mm, 1)), NumberCell(Fixed(placement.error_degrees, 1)),
         Element("td", {},
                 Badge(is_near, is_near                ? "in place"
                                : placement.X_WReached ? "too far"
                                                       : "missing"))});
  }
  return Table(
      "Positions x, y, z in units of the scene. The structure may be built anywhere, so the wanted "
      "positions are those of the best fit.",
      Row({Head("Object"), NumberHead("Wanted"), NumberHead("Reached"), NumberHead("Error, mm"),
           NumberHead("Rotation error, °"), Head("")}),
      rows);
}

/// Returns the wanted and the reached poses: two views, a table and the errors as bars.
Markup Places(const ExperimentOutcome& outcome) {
  // The tolerance of a result is in units of the scene.
  const scene::SceneSpec& scene = outcome.imitation.scene();
  const double tolerance_mm =
      1000 * scene.meters_per_unit * outcome.result.at("tolerance").get<double>();
  const std::vector<Placement> placements = PlacementsOf(outcome.result, scene.meters_per_unit);
  const std::string note = "Filled: final pose. Dashed: wanted pose.";
  const auto view = [&](ViewDirection direction) {
    Markup content = DrawPlacements(scene, outcome.result, placements, direction);
    content += Element("p", {{"class", "note"}}, note);
    return content;
  };
  Markup pair = Section("From above", view(ViewDirection::kTop));
  pair += Section("From the front", view(ViewDirection::kFront));
  Markup content = Element("div", {{"class", "pair"}}, pair);
  Markup table = PlacementTable(placements, scene.meters_per_unit, tolerance_mm);
  table += ErrorBars(placements, tolerance_mm);
  content += Section("Wanted and reached", table);
  return content;
}

/// Returns the other goals, and which of them were achieved; empty without any, and for results of
/// older versions.
Markup EffectsOf(const Json& result) {
  Markup rows;
  for (const Json& effect : result.value("effects", Json::array())) {
    if (!effect.contains("text")) continue;
    const bool is_achieved = effect.at("achieved").get<bool>();
    rows += Row({WideCell(effect.at("text").get<std::string>()),
                 Element("td", {}, Badge(is_achieved, is_achieved ? "achieved" : "missing"))});
  }
  if (rows.is_empty()) return {};
  return Section("Other changes", Table("What the demonstration changed besides places.",
                                        Row({Head("Change"), Head("")}), rows));
}

/// Returns what the demonstrator did. Undone steps and those without an action are left out.
Markup StepsOf(const recording::Recording& recording) {
  Markup rows;
  for (const recording::Segment& step : recording::HistoryOf(recording)) {
    if (!step.is_on_path || !step.summary) continue;
    rows += Row({NumberCell(Fixed(SecondsInto(recording, step.begin.tick), 1) + " s"),
                 WideCell(WordsOf(step))});
  }
  return Table("Steps of the hands.", Row({NumberHead("At"), Head("Step")}), rows);
}

/// Returns the times in which grippers held objects.
Markup RobotStepsOf(const std::vector<Carry>& carries) {
  Markup rows;
  for (const Carry& carry : carries) {
    rows += Row({NumberCell(Fixed(carry.begin, 1) + " s"), NumberCell(Fixed(carry.end, 1) + " s"),
                 WideCell(carry.who + " carries " + carry.object)});
  }
  return Table("Objects held by the robot's grippers.",
               Row({NumberHead("From"), NumberHead("To"), Head("Step")}), rows);
}

/// Returns the demonstration and the imitation, side by side, each as timeline and table.
Markup Work(const ExperimentOutcome& outcome) {
  const auto length = [](const recording::Recording& recording) {
    return SecondsInto(recording, TicksOf(recording).last);
  };
  const std::vector<Carry> carries = CarriesOf(outcome.imitation);
  Markup shown = TimelineOf(CarriesOf(outcome.demonstration), length(outcome.demonstration),
                            "Times at which the hands held each object");
  shown += StepsOf(outcome.demonstration);
  Markup done = TimelineOf(carries, length(outcome.imitation),
                           "Times at which the robot's grippers held each object");
  done += RobotStepsOf(carries);
  Markup pair = Section("Demonstration", shown);
  pair += Section("Imitation", done);
  return Element("div", {{"class", "pair"}}, pair);
}

/// Returns what the brain printed: what it understood of the demonstration, planned and did. Of a
/// long output, the middle is left out. Empty without any.
Markup WordsOfBrain(const recording::Recording& imitation) {
  constexpr std::size_t kMaxBytes = 16'000'000;  // more than brain.log may have
  constexpr std::size_t kFirstLines = 200, kLastLines = 50;
  const std::filesystem::path file = imitation.directory / "brain.log";
  std::error_code error;
  if (!std::filesystem::exists(file, error)) return {};
  std::vector<std::string> lines;
  std::istringstream text(ReadFile(file, kMaxBytes));
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  if (lines.size() > kFirstLines + kLastLines) {
    const std::size_t num_left_out = lines.size() - kFirstLines - kLastLines;
    const auto middle = lines.begin() + kFirstLines;
    lines.erase(middle, lines.end() - kLastLines);
    lines.insert(lines.begin() + kFirstLines,
                 "[" + std::to_string(num_left_out) + " lines left out]");
  }
  Markup content;
  for (const std::string& line : lines) content += Text(line + "\n");
  return Section("What the robot's program said", Element("pre", {}, content));
}

/// Returns links to files next to the page; empty without any.
Markup Enclosures(const std::vector<Enclosure>& enclosures) {
  Markup list;
  for (const Enclosure& enclosure : enclosures) {
    list += Element("li", {}, LinkTo(enclosure.file, enclosure.words));
  }
  return list.is_empty() ? Markup() : Section("Files", Element("ul", {}, list));
}

}  // namespace

std::string PageOf(const ExperimentOutcome& outcome) {
  Markup body = HeaderOf(outcome);
  body += Numbers(outcome.result);
  body += Section("The demonstration", PicturesOf(outcome.demonstration, "The demonstration"));
  body += Section("The imitation", PicturesOf(outcome.imitation, "The imitation"));
  body += AccountOf(outcome.imitation);
  body += ClaimOf(outcome.result);
  body += Places(outcome);
  body += EffectsOf(outcome.result);
  body += Work(outcome);
  body += WordsOfBrain(outcome.imitation);
  body += Enclosures(outcome.enclosures);
  return Page("Experiment: " + outcome.name, body);
}

}  // namespace smile::report
