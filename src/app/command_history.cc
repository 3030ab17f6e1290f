#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <memory>

#include "app/commands.h"
#include "app/exit_code.h"
#include "app/open_recording.h"
#include "base/json.h"
#include "base/wording.h"
#include "recording/recording_history.h"
#include "recording/time_range.h"

namespace smile::app {
namespace {

/// Largest indentation; deeper branches share a column.
constexpr int kMaxDepth = 20;

struct HistoryOptions {
  std::string demo;
  bool json = false;
};

Json ToJson(const recording::Recording& recording, const std::vector<recording::Segment>& steps) {
  std::vector<Json> effects(steps.size(), Json::array());
  for (const recording::SegmentEffect& effect : recording::EffectsOf(recording, steps)) {
    effects[effect.step].push_back(
        {{"at", SecondsInto(recording, effect.tick)}, {"words", effect.words}});
  }
  Json list = Json::array();
  for (std::size_t i = 0; i < steps.size(); ++i) {
    list.push_back({{"step", i},
                    {"parent", steps[i].parent ? Json(*steps[i].parent) : Json()},
                    {"words", WordsOf(steps[i])},
                    {"deed", sim::ToJson(steps[i].summary)},
                    {"begin", SecondsInto(recording, steps[i].begin.tick)},
                    {"end", SecondsInto(recording, steps[i].end.tick)},
                    {"on_way", steps[i].is_on_path},
                    {"effects", std::move(effects[i])}});
  }
  return {{"title", recording.info.title}, {"steps", list}};
}

/// Prints what contact and tools did within a step, below it and in its column.
void PrintEffects(const recording::Recording& recording,
                  const std::vector<recording::SegmentEffect>& effects, std::size_t step,
                  const std::string& indentation) {
  for (const recording::SegmentEffect& effect : effects) {
    if (effect.step != step) continue;
    std::printf("%s      %7.2f s    %s\n", indentation.c_str(), SecondsInto(recording, effect.tick),
                Printable(effect.words).c_str());
  }
}

/// Prints the tree of steps: for each step first the branches that were left, one column farther
/// right each time, then its continuation. Without recursion, as histories can be long.
void PrintTree(const recording::Recording& recording,
               const std::vector<recording::Segment>& steps) {
  std::vector<std::vector<std::size_t>> children(steps.size());
  for (std::size_t i = 1; i < steps.size(); ++i) children[*steps[i].parent].push_back(i);
  struct Row {
    std::size_t step = 0;
    int depth = 0;
  };
  const std::vector<recording::SegmentEffect> effects = recording::EffectsOf(recording, steps);
  std::vector<Row> rows{{}};  // to be printed, the next one last
  while (!rows.empty()) {
    const Row row = rows.back();
    rows.pop_back();
    const recording::Segment& step = steps[row.step];
    const std::string indentation(2 * std::min(row.depth, kMaxDepth), ' ');
    std::printf("%s%s %3zu  %7.2f s  %s%s\n", indentation.c_str(), step.is_on_path ? "*" : "-",
                row.step, SecondsInto(recording, step.begin.tick), Printable(WordsOf(step)).c_str(),
                step.is_on_path ? "" : " (undone)");
    PrintEffects(recording, effects, row.step, indentation);
    // The continuation stays in the same column: the child on the path, or else the newest one. It
    // is pushed first, so that it is printed last.
    const auto& next = children[row.step];
    for (std::size_t k = next.size(); k-- > 0;) {
      const bool is_main = steps[next[k]].is_on_path || (k + 1 == next.size() && !step.is_on_path);
      if (is_main) rows.push_back({next[k], row.depth});
    }
    for (std::size_t k = next.size(); k-- > 0;) {
      const bool is_main = steps[next[k]].is_on_path || (k + 1 == next.size() && !step.is_on_path);
      if (!is_main) rows.push_back({next[k], row.depth + 1});
    }
  }
}

int ShowHistory(const HistoryOptions& options) {
  const recording::Recording recording = OpenAndReport(options.demo);
  const std::vector<recording::Segment> steps = recording::HistoryOf(recording);
  if (options.json) {
    std::printf("%s\n", ToText(ToJson(recording, steps), 2).c_str());
  } else {
    PrintTree(recording, steps);
  }
  return kDone;
}

}  // namespace

void AddHistory(CLI::App* program, ExitAnswer answer) {
  auto options = std::make_shared<HistoryOptions>();
  CLI::App* history =
      program->add_subcommand("history", "List the steps of a recording, including undone ones");
  history->add_option("DEMO", options->demo, "directory of a recording")->required();
  history->add_flag("--json", options->json, "result as one JSON object on stdout");
  history->callback([options, answer] { *answer = ShowHistory(*options); });
}

}  // namespace smile::app
