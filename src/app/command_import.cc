#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "app/commands.h"
#include "app/exit_code.h"
#include "app/options.h"
#include "base/json.h"
#include "classic/import_classic.h"
#include "recording/demo_info.h"
#include "scene_xml/scene_reader.h"

namespace smile::app {
namespace {

struct ImportCommandOptions {
  std::string classic, out, scene;
  classic::ImportOptions import;
  PathOptions path;
  bool json = false;
};

int Import(ImportCommandOptions* options) {
  recording::CheckTitle(options->import.title);
  if (!options->scene.empty()) {
    options->import.scene = scene_xml::LoadScene(options->scene, options->path.reader());
  }
  const classic::ImportReport report =
      classic::ImportClassic(options->classic, options->out, options->import);
  for (const std::string& remark : report.remarks) {
    std::fprintf(stderr, "%s: %s\n", options->classic.c_str(), remark.c_str());
  }
  if (options->json) {
    const Json json = {{"recording", options->out},   {"frames", report.frames},
                       {"segments", report.segments}, {"objects", report.objects},
                       {"pictures", report.pictures}, {"remarks", report.remarks}};
    std::printf("%s\n", ToText(json, 2).c_str());
  } else {
    std::printf("%s: %llu frames, %zu segments, %zu objects, %zu pictures\n", options->out.c_str(),
                static_cast<unsigned long long>(report.frames), report.segments, report.objects,
                report.pictures);
  }
  return kDone;
}

}  // namespace

void AddImport(CLI::App* program, ExitAnswer answer) {
  auto options = std::make_shared<ImportCommandOptions>();
  CLI::App* import =
      program->add_subcommand("import", "Import a classic recording, for viewing and rendering");
  import->add_option("CLASSIC", options->classic, "directory with 0.txt, 0/, 1.txt, …")->required();
  import->add_option("--out", options->out, "new directory")->required()->check(NotEmpty());
  import->add_option("--scene", options->scene,
                     "scene file of the recording; without it, objects are shown as blocks");
  AddPathOption(import, &options->path);
  import->add_option("--title", options->import.title, "title of the recording");
  import->add_option("--notes", options->import.notes, "notes about the recording");
  import->add_flag("--json", options->json, "result as one JSON object on stdout");
  import->callback([options, answer] { *answer = Import(options.get());
});
}  // namespace smile::app

}  // namespace smile::app
