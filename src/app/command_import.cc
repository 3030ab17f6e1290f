#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <stdexcept>

#include "app/commands.h"
#include "app/exit_code.h"
#include "app/options.h"
#include "base/files.h"
#include "base/json.h"
#include "classic/import_classic.h"
#include "mesh/import_mesh.h"
#include "recording/demo_info.h"
#include "scene_import/import_scene.h"
#include "scene_xml/mesh_files.h"
#include "scene_xml/scene_reader.h"
#include "scene_xml/scene_writer.h"

namespace smile::app {
namespace {

struct ImportCommandOptions {
  std::string source, out, scene;
  std::string format, table;  ///< of a model of another simulator
  classic::ImportOptions import;
  PathOptions path;
  bool json = false;
};

/// Writes a scene, and its meshes into a folder beside it.
void WriteImported(const scene::SceneSpec& scene, const std::filesystem::path& out) {
  const std::vector<scene_xml::MeshFile> meshes = scene_xml::MeshFilesOf(scene);
  const std::filesystem::path folder = out.parent_path() / scene_xml::kMeshFolder;
  if (!meshes.empty()) MakeDirectories(folder);
  for (const scene_xml::MeshFile& file : meshes) {
    mesh::WriteStl(file.mesh->surface, folder / file.name);
  }
  WriteFile(out, scene_xml::WriteScene(scene));
}

int ImportModel(const ImportCommandOptions& options) {
  if (!options.scene.empty() || !options.import.title.empty() || !options.import.notes.empty()) {
    throw std::invalid_argument(
        "--scene, --title and --notes are for classic recordings, found "
        "--from " +
        options.format);
  }
  const scene_import::ImportedScene imported = scene_import::ImportScene(
      options.source, options.format,
      {.search_roots = options.path.reader().search_roots, .table = options.table});
  WriteImported(imported.scene, options.out);
  Json remarks = Json::array();
  for (const Diagnostic& remark : imported.remarks) {
    std::fprintf(stderr, "%s\n", ToString(remark).c_str());
    remarks.push_back(ToString(remark));
  }
  const scene::SceneSpec& scene = imported.scene;
  if (options.json) {
    const Json json = {{"scene", options.out},
                       {"objects", scene.objects.size()},
                       {"sliders", scene.sliders.size()},
                       {"cameras", scene.cameras.size()},
                       {"remarks", remarks}};
    std::printf("%s\n", ToText(json, 2).c_str());
  } else {
    std::printf("%s: %zu objects, %zu sliders, %zu cameras\n", options.out.c_str(),
                scene.objects.size(), scene.sliders.size(), scene.cameras.size());
  }
  return kDone;
}

int Import(ImportCommandOptions* options) {
  if (!options->format.empty()) return ImportModel(*options);
  if (!options->table.empty()) {
    throw std::invalid_argument("--table is for models of other simulators, found no --from");
  }
  recording::CheckTitle(options->import.title);
  if (!options->scene.empty()) {
    options->import.scene = scene_xml::LoadScene(options->scene, options->path.reader());
  }
  const classic::ImportReport report =
      classic::ImportClassic(options->source, options->out, options->import);
  for (const std::string& remark : report.remarks) {
    std::fprintf(stderr, "%s: %s\n", options->source.c_str(), remark.c_str());
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
  CLI::App* import = program->add_subcommand(
      "import",
      "Import a classic recording, for viewing and rendering, or with --from the model of another "
      "simulator as a scene (docs/other-simulators.md)");
  import
      ->add_option("SOURCE", options->source,
                   "directory with 0.txt, 0/, 1.txt, …; with --from a file")
      ->required();
  import->add_option("--out", options->out, "new directory; with --from the scene file")
      ->required()
      ->check(NotEmpty());
  std::string formats = "format of a model:";
  for (const std::string_view format : scene_import::SceneFormatNames()) {
    formats += " " + std::string(format);
  }
  import->add_option("--from", options->format, formats)->check(NotEmpty());
  import->add_option("--table", options->table,
                     "body or shape of a model that is its table (default: the largest level box "
                     "whose name contains `table`, else the ground)");
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
