#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <thread>

#include "analysis/analysis.h"
#include "analysis/analysis_json.h"
#include "app/commands.h"
#include "app/interrupt.h"
#include "app/open_recording.h"
#include "app/options.h"
#include "app/progress.h"
#include "base/files.h"
#include "base/wording.h"
#include "experiment/content_hash.h"
#include "experiment/folder_lock.h"
#include "report/analysis_page.h"

namespace smile::app {
namespace {

/// Kept in the output directory until the analysis is complete.
constexpr const char* kProgressFile = "progress.jsonl";

struct AnalyzeOptions {
  std::string demo, out;
  std::vector<std::string> ignored;
  int jobs = 0;
  bool json = false;
};

void PrintProperties(const analysis::Analysis& analysis) {
  for (const analysis::PropertyFinding& one : analysis.properties) {
    const bool is_color = one.property == analysis::PropertyFinding::Property::kColor;
    const std::string what =
        is_color ? "color of " + one.object : std::string("everything that is not fixed");
    std::printf("%s%s%s: %s\n", Printable(what).c_str(), one.tried.empty() ? "" : ", ",
                one.tried.c_str(), Printable(one.harm.value_or("without harm")).c_str());
  }
  if (!analysis.why_not_moved.empty()) {
    std::printf("another place was not tried: %s\n", analysis.why_not_moved.c_str());
  }
}

void Print(const analysis::Analysis& analysis) {
  for (const analysis::GoalFinding& one : analysis.goals) {
    if (!one.counts) std::printf("does not count: %s\n", Printable(one.goal.words).c_str());
  }
  for (std::size_t i = 0; i < analysis.subtasks.size(); ++i) {
    const analysis::SubtaskFinding& finding = analysis.subtasks[i];
    std::printf("%zu. %s: %s\n", i + 1, Printable(finding.subtask.words).c_str(),
                finding.harm ? "necessary" : "redundant");
  }
  if (analysis.sufficient.size() < analysis.subtasks.size()) {
    std::printf("the same is achieved with fewer subtasks: %s\n",
                analysis::NumbersOf(analysis.sufficient).c_str());
  }
  for (const analysis::Precedence& one : analysis.precedences) {
    std::printf("%zu must come after %zu: otherwise %s\n", one.after + 1, one.before + 1,
                Printable(one.harm).c_str());
  }
  std::printf("%s subtasks can be done in any order\n",
              analysis.precedences.empty() ? "all" : "other");
  PrintProperties(analysis);
}

void AnalyzeDemo(const AnalyzeOptions& options) {
  const recording::Recording recording = OpenAndReport(options.demo);
  if (!options.out.empty()) {
    RequireOutsideOfRecordings(options.out);
    std::filesystem::create_directories(options.out);
  }
  std::optional<experiment::FolderLock> lock;
  if (!options.out.empty()) lock.emplace(options.out, "analysis");
  ProgressLine progress("simulating");
  // hardware_concurrency() may return 0 where it does not know.
  const unsigned threads = options.jobs > 0 ? static_cast<unsigned>(options.jobs)
                                            : std::max(1u, std::thread::hardware_concurrency());
  const analysis::Analysis analysis = analysis::Analyze(
      recording,
      {.num_threads = threads,
       .ignored = options.ignored,
       .progress_file = options.out.empty() ? std::filesystem::path()
                                            : std::filesystem::path(options.out) / kProgressFile,
       .build = experiment::ContentOf(std::filesystem::read_symlink("/proc/self/exe")),
       .say =
           [](std::string_view message) {
             std::fprintf(stderr, "%s\n", Printable(message).c_str());
           },
       .progress =
           [&progress](std::size_t done, std::size_t at_most) {
             progress.Show(static_cast<double>(done), static_cast<double>(at_most),
                           "simulations at most");
             return !IsInterrupted();
           }});
  progress.Wipe();
  const std::string json = ToText(ToJson(analysis), 2);
  if (!options.out.empty()) {
    const std::filesystem::path out = options.out;
    const std::string name = std::filesystem::absolute(options.demo).lexically_normal().filename();
    WriteFile(out / "analysis.json", json + "\n");
    WriteFile(out / "report.html", report::PageOf(analysis, name));
  }
  if (options.json) {
    std::printf("%s\n", json.c_str());
  } else {
    Print(analysis);
    if (!options.out.empty()) std::printf("written to %s\n", options.out.c_str());
  }
}

}  // namespace

void AddAnalyze(CLI::App* program, ExitAnswer) {
  auto options = std::make_shared<AnalyzeOptions>();
  CLI::App* analyze = program->add_subcommand(
      "analyze", "Find out which subtasks of a demonstration matter, and in which order");
  analyze->add_option("DEMO", options->demo, "directory of a recording; it is not changed")
      ->required();
  analyze->add_option("--out", options->out, "directory for analysis.json and report.html")
      ->check(NotEmpty());
  Repeatable(analyze->add_option("--ignore", options->ignored,
                                 "goal that does not count: id of an object whose place is "
                                 "meant, or an effect in the words of analysis.json"))
      ->check(NotEmpty());
  analyze->add_option("--jobs", options->jobs, "simulations at the same time (default: cores)")
      ->check(CLI::Range(1, 256));
  analyze->add_flag("--json", options->json, "result as one JSON object on stdout");
  analyze->callback([options] { AnalyzeDemo(*options); });
}

}  // namespace smile::app
