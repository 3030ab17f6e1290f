#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <stdexcept>

#include "app/commands.h"
#include "app/interrupt.h"
#include "app/open_recording.h"
#include "app/options.h"
#include "app/progress.h"
#include "editing/edit_json.h"
#include "editing/edit_texts.h"
#include "editing/overlay.h"
#include "editing/re_simulation.h"
#include "picture/rendered_eye.h"
#include "recording/view_sample.h"

namespace smile::app {
namespace {

/// Edit with the text of its option.
struct TypedEdit {
  std::string text;
  editing::Edit edit;
};

struct EditOptions {
  std::string demo, out;
  std::vector<TypedEdit> edits;  ///< in the order of the command line
  std::string overlay, overlay_hand;
  double overlay_at = 0;  ///< [s]
  bool dry_run = false, no_pictures = false, json = false;
};

void Print(const editing::EditReport& report) {
  std::printf("lasts %.2f s, was %.2f s\n", sim::SecondsOf(report.ticks_after),
              sim::SecondsOf(report.ticks_before));
  for (const editing::SkippedCommand& command : report.skipped) {
    std::printf("line %zu of the %s is skipped: %s\n", command.line,
                command.is_of_overlay ? "overlay's log" : "log", command.reason.c_str());
  }
  for (const editing::Displaced& object : report.displaced) {
    std::printf("%s ends %.1f mm and %.1f degrees from its previous pose\n", object.id.c_str(),
                object.gap.millimeters(), object.gap.degrees());
  }
  for (const std::string& id : report.gone) {
    std::printf("%s is missing at the end\n", id.c_str());
  }
  for (const std::string& id : report.there_again) {
    std::printf("%s is present at the end; it was missing before\n", id.c_str());
  }
  for (const editing::ChangedState& control : report.controls) {
    std::printf("%s ends in state %s, was %s\n", control.id.c_str(), control.after.c_str(),
                control.before.c_str());
  }
  for (const editing::ChangedState& host : report.host_points) {
    std::printf("%s ends with tightness %s, was %s\n", host.id.c_str(), host.after.c_str(),
                host.before.c_str());
  }
  for (const std::string& joint : report.joints) {
    std::printf("the robot's %s ends in another position\n", joint.c_str());
  }
  if (report.ends_the_same()) std::printf("the final state is unchanged\n");
}

/// Performs the edits in order. An error begins with the text of its option.
recording::Demonstration Perform(const std::vector<TypedEdit>& edits,
                                 recording::Demonstration demonstration) {
  for (const TypedEdit& typed : edits) {
    try {
      demonstration = Edited(std::move(demonstration), typed.edit);
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(typed.text + ": " + error.what());
    }
  }
  return demonstration;
}

/// Adds the hands of the other recording, if there is one.
recording::Demonstration WithOverlay(const EditOptions& options,
                                     const recording::Recording& recording,
                                     recording::Demonstration edited) {
  if (options.overlay.empty()) return edited;
  const recording::Recording other = OpenAndReport(options.overlay);
  editing::Overlay overlay{
      .demonstration = DemonstrationOf(other),
      .begin = static_cast<std::uint64_t>(std::llround(options.overlay_at * sim::kTicksPerSecond)),
      .hand = demonstrator::ParseHandName(options.overlay_hand)};
  try {
    return Overlaid(edited, overlay, recording.log.lines().size());
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument("--overlay " + options.overlay + ": " + error.what());
  }
}

/// Simulates the edited demonstration from its start. Records it unless this is a dry run.
editing::EditReport Simulate(const recording::Recording& recording,
                             const recording::Demonstration& edited, const EditOptions& options) {
  // Only an actual recording needs a renderer.
  std::optional<picture::RenderedEye> eye;
  std::optional<editing::EditOutput> output;
  if (!options.dry_run) {
    const auto spec = EyeOf(recording.info);
    if (spec && !options.no_pictures) eye.emplace(*spec);
    output = {.directory = options.out, .eye = eye ? &*eye : nullptr};
  }
  ProgressLine progress("simulating");
  const auto show = [&progress](double done, double total) {
    progress.Show(done, total);
    return !IsInterrupted();
  };
  const auto report = output ? editing::MakeEdited(recording, edited, *output, show)
                             : editing::ReSimulate(recording, edited, std::nullopt, show);
  if (IsInterrupted()) throw std::runtime_error("interrupted");
  return report;
}

void EditDemo(const EditOptions& options) {
  if (options.out.empty() && !options.dry_run) {
    throw std::invalid_argument("the result has no destination: give --out or --dry-run");
  }
  const recording::Recording recording = OpenAndReport(options.demo);
  const auto edited =
      WithOverlay(options, recording, Perform(options.edits, DemonstrationOf(recording)));
  const editing::EditReport report = Simulate(recording, edited, options);
  if (options.json) {
    std::printf("%s\n", ToText(ToJson(report), 2).c_str());
  } else {
    Print(report);
    if (!options.dry_run) std::printf("recorded in %s\n", options.out.c_str());
  }
}

/// Adds the options of edits, which are collected in the order of the command line, since edits do
/// not commute.
void AddEditOptions(CLI::App* edit, const std::shared_ptr<EditOptions>& options) {
  for (const editing::EditOption& option : editing::AllEditOptions()) {
    const auto take = [options, option](const std::string& text) {
      const std::string typed = std::string(option.name) + " " + text;
      try {
        options->edits.push_back({typed, option.parse(text)});
      } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(std::string(option.name) + ": " + error.what());
      }
    };
    // A callback of every occurrence, since CLI11 otherwise groups the values by option.
    edit->add_option_function<std::string>(option.name, take, option.meaning)
        ->type_name(option.form)
        ->trigger_on_parse();
  }
}

}  // namespace

void AddEdit(CLI::App* program, ExitAnswer) {
  auto options = std::make_shared<EditOptions>();
  CLI::App* edit = program->add_subcommand(
      "edit", "Edit a recording into a new one; segment N is that of N.txt");
  edit->add_option("DEMO", options->demo, "directory of a recording; it is not changed")
      ->required();
  edit->add_option("--out", options->out, "new directory for the result")->check(NotEmpty());
  AddEditOptions(edit, options);
  edit->add_option("--overlay", options->overlay,
                   "recording whose hands act at the same time, after all other edits")
      ->type_name("DEMO2");
  edit->add_option("--overlay-at", options->overlay_at, "when DEMO2 starts [s] (default: 0)")
      ->type_name("SECONDS")
      ->check(CLI::Range(0.0, editing::kMaxSeconds))
      ->needs("--overlay");
  edit->add_option("--overlay-hand", options->overlay_hand, "hand that does all of DEMO2")
      ->type_name("HAND")
      ->check(CLI::IsMember({"left", "right"}))
      ->needs("--overlay");
  edit->add_flag("--dry-run", options->dry_run, "report the effect only; write nothing");
  edit->add_flag("--no-pictures", options->no_pictures, "text only");
  edit->add_flag("--json", options->json, "result as one JSON object on stdout");
  edit->callback([options] { EditDemo(*options); });
}

}  // namespace smile::app
