#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "app/commands.h"
#include "app/exit_code.h"
#include "app/options.h"
#include "base/json.h"
#include "scene/controls_of.h"
#include "scene_xml/scene_reader.h"
#include "scene_xml/scene_writer.h"

namespace smile::app {
namespace {

struct CheckOptions {
  std::vector<std::string> scenes;
  bool json = false, expand = false;
  PathOptions path;
};

/// Numbers of things in a scene.
struct SceneCounts {
  std::size_t objects = 0, fixed = 0, controls = 0;
  /// Sliders, joints between the pieces of chains, and initial bonds.
  std::size_t joints = 0;

  void operator+=(const SceneCounts& other) {
    objects += other.objects;
    fixed += other.fixed;
    controls += other.controls;
    joints += other.joints;
  }
};

/// Returns the number of guest points of a part and its children that are bound at the start.
std::size_t NumInitialBonds(const scene::Part& part) {
  const auto* composite = std::get_if<scene::Composite>(&part.shape);
  if (!composite) return 0;
  std::size_t count = 0;
  for (const scene::GuestPoint& guest : composite->guests) count += guest.initial_tightness > 0;
  for (const scene::Part& child : composite->parts) count += NumInitialBonds(child);
  return count;
}

SceneCounts CountsOf(const scene::SceneSpec& scene) {
  SceneCounts counts{.objects = scene.objects.size(), .joints = scene.sliders.size()};
  for (const scene::ObjectSpec& object : scene.objects) {
    counts.fixed += object.is_static();
    counts.controls += scene::ControlsOf(object.whole).size();
    counts.joints += NumInitialBonds(object.whole);
  }
  // A chain of n links has a joint at each end and n - 1 between them.
  for (const scene::ChainSpec& chain : scene.chains) counts.joints += chain.link_ids.size() + 1;
  return counts;
}

/// Sums over all given files.
struct Findings {
  SceneCounts counts;
  std::vector<Diagnostic> diagnostics;
};

/// Returns a number with a noun: `1 joint`, `2 joints`.
std::string Counted(std::size_t count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

Json ToJson(const Findings& findings) {
  Json diagnostics = Json::array();
  for (const Diagnostic& diagnostic : findings.diagnostics) {
    diagnostics.push_back({{"file", diagnostic.file},
                           {"line", diagnostic.line},
                           {"element", diagnostic.element},
                           {"message", diagnostic.message}});
  }
  return {{"ok", findings.diagnostics.empty()}, {"objects", findings.counts.objects},
          {"static", findings.counts.fixed},    {"controls", findings.counts.controls},
          {"joints", findings.counts.joints},   {"diagnostics", diagnostics}};
}

/// Checks all files, even after one with an error. Diagnostics go to stderr, all else to stdout.
int Check(const CheckOptions& options) {
  Findings findings;
  for (const std::string& file : options.scenes) {
    const scene_xml::SceneReading reading = scene_xml::ReadScene(file, options.path.reader());
    for (const Diagnostic& diagnostic : reading.diagnostics) {
      std::fprintf(stderr, "%s\n", ToString(diagnostic).c_str());
      findings.diagnostics.push_back(diagnostic);
    }
    if (!reading.scene) continue;
    const SceneCounts counts = CountsOf(*reading.scene);
    findings.counts += counts;
    if (options.expand) {
      std::printf("%s", scene_xml::WriteScene(*reading.scene, reading.origins,
                                              scene_xml::MeshNames::kWhereTheyAre)
                            .c_str());
    }
    if (!options.json && !options.expand) {
      std::printf("%s: ok, %s (%zu fixed), %s, %s\n", file.c_str(),
                  Counted(counts.objects, "object").c_str(), counts.fixed,
                  Counted(counts.controls, "control").c_str(),
                  Counted(counts.joints, "joint").c_str());
    }
  }
  if (options.json) std::printf("%s\n", ToText(ToJson(findings), 2).c_str());
  return findings.diagnostics.empty() ? kDone : kInputWrong;
}

}  // namespace

void AddCheck(CLI::App* program, ExitAnswer answer) {
  auto options = std::make_shared<CheckOptions>();
  CLI::App* check = program->add_subcommand(
      "check", "Check scene files; report each error as file:line: <element>: found, expected");
  check->add_option("SCENE", options->scenes, "scene files (docs/scene-format.md)")->required();
  auto* json = check->add_flag("--json", options->json, "result as one JSON object on stdout");
  check->add_flag("--expand", options->expand, "the scene with all values written out, on stdout")
      ->excludes(json);
  AddPathOption(check, &options->path);
  check->callback([options, answer] { *answer = Check(*options); });
}

}  // namespace smile::app
