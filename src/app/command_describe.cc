#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "app/commands.h"
#include "app/exit_code.h"
#include "app/open_recording.h"
#include "base/wording.h"
#include "task/demonstrated_structure.h"
#include "task/structure_json.h"

namespace smile::app {
namespace {

struct DescribeOptions {
  std::string demo;
  bool json = false;
};

int DescribeDemo(const DescribeOptions& options) {
  const recording::Recording recording = OpenAndReport(options.demo);
  const task::Structure structure = task::StructureOf(recording);
  const double unit = recording.scene().meters_per_unit;
  if (options.json) {
    std::printf("%s\n", ToText(task::ToJson(structure, unit), 2).c_str());
    return kDone;
  }
  for (const std::string& line : task::WordsOf(structure, unit)) {
    std::printf("%s\n", Printable(line).c_str());
  }
  return kDone;
}

}  // namespace

void AddDescribe(CLI::App* program, ExitAnswer answer) {
  auto options = std::make_shared<DescribeOptions>();
  CLI::App* describe = program->add_subcommand(
      "describe", "Describe the result of a recording: placed objects in order, and other effects");
  describe->add_option("DEMO", options->demo, "directory of a recording")->required();
  describe->add_flag("--json", options->json, "result as one JSON object on stdout");
  describe->callback([options, answer] { *answer = DescribeDemo(*options); });
}

}  // namespace smile::app
