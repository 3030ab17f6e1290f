#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <memory>

#include "app/commands.h"
#include "app/exit_code.h"
#include "app/options.h"
#include "base/json.h"
#include "scene_xml/scene_reader.h"
#include "scene_xml/scene_writer.h"

namespace smile::app {
namespace {

struct CheckOptions {
  std::vector<std::string> scenes;
  bool json = false, expand = false;
  PathOptions path;
};

/// The sums over all files asked for.
struct Findings {
  std::size_t objects = 0, fixed = 0;
  std::vector<Diagnostic> diagnostics;
};

Json ToJson(const Findings& findings) {
  Json diagnostics = Json::array();
  for (const Diagnostic& diagnostic : findings.diagnostics) {
    diagnostics.push_back({{"file", diagnostic.file},
                           {"line", diagnostic.line},
                           {"element", diagnostic.element},
                           {"message", diagnostic.message}});
  }
  return {{"ok", findings.diagnostics.empty()},
          {"objects", findings.objects},
          {"static", findings.fixed},
          {"controls", 0},
          {"joints", 0},
          {"diagnostics", diagnostics}};
}

int Check(const CheckOptions& options) {
  Findings findings;
  for (const std::string& file : options.scenes) {
    const scene_xml::SceneReading reading = scene_xml::ReadScene(file, options.path.reader());
    for (const Diagnostic& diagnostic : reading.diagnostics) {
      std::fprintf(stderr, "%s\n", ToString(diagnostic).c_str());
      findings.diagnostics.push_back(diagnostic);
    }
    if (!reading.scene) continue;
    const auto& objects = reading.scene->objects;
    const auto fixed = static_cast<std::size_t>(std::count_if(
        objects.begin(), objects.end(), [](const auto& object) { return object.is_static(); }));
    findings.objects += objects.size();
    findings.fixed += fixed;
    if (options.expand) {
      std::printf("%s", scene_xml::WriteScene(*reading.scene, reading.origins,
                                              scene_xml::MeshNames::kWhereTheyAre)
                            .c_str());
    }
    if (!options.json && !options.expand) {
      std::printf("%s: ok, %zu objects (%zu fixed)\n", file.c_str(), objects.size(), fixed);
    }
  }
  if (options.json) std::printf("%s\n", ToText(ToJson(findings), 2).c_str());
  return findings.diagnostics.empty() ? kDone : kInputWrong;
}

}  // namespace

void AddCheck(CLI::App* program, ExitAnswer answer) {
  auto options = std::make_shared<CheckOptions>();
  CLI::App* check = program->add_subcommand(
      "check", "Check scene files: every error as file:line: <element>: found, expected");
  check->add_option("SCENE", options->scenes, "scene files (docs/scene-format.md)")->required();
  auto* json = check->add_flag("--json", options->json, "print one JSON object on stdout");
  check->add_flag("--expand", options->expand, "print the scene with every value written out")
      ->excludes(json);
  AddPathOption(check, &options->path);
  check->callback([options, answer] { *answer = Check(*options); });
}

}  // namespace smile::app
