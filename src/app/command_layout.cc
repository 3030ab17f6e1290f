#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "app/commands.h"
#include "app/exit_code.h"
#include "app/layout_options.h"
#include "app/options.h"
#include "base/diagnostic.h"
#include "experiment/robot_region.h"
#include "recording/scene_files.h"
#include "scene_xml/mesh_files.h"
#include "scene_xml/scene_reader.h"

namespace smile::app {
namespace {

struct LayoutCommandOptions {
  std::string scene, out;
  LayoutOptions layout;
  PathOptions path;
  RobotOptions robot;
};

/// Demands that nothing exists at this path, so that nothing is overwritten.
/// @throws InputError if something does.
void RequireNew(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) return;
  throw InputError({path.string(), 0, "", "exists already, expected a new file in another folder"});
}

int WriteLayout(const LayoutCommandOptions& options) {
  const scene::SceneSpec scene = layout::LaidOut(
      scene_xml::LoadScene(options.scene, options.path.reader()), options.layout.choice(),
      [&](double height) {
        return experiment::RegionOf(PlaceRobot(options.robot, options.path).value(), height);
      });
  const std::filesystem::path out = options.out;
  RequireNew(out);
  if (!scene_xml::MeshFilesOf(scene).empty()) {
    RequireNew(out.parent_path() / scene_xml::kMeshFolder);
  }
  recording::WriteSceneFiles(scene, out);
  std::printf("%s: seed %llu, %s\n", out.c_str(),
              static_cast<unsigned long long>(*options.layout.seed), options.layout.level.c_str());
  return kDone;
}

}  // namespace

void AddLayout(CLI::App* program, ExitAnswer answer) {
  auto options = std::make_shared<LayoutCommandOptions>();
  CLI::App* layout = program->add_subcommand(
      "layout", "Write a scene with its movable objects at random starting positions");
  layout->add_option("SCENE", options->scene, "scene file")->required();
  AddLayoutOptions(layout, &options->layout)->required();
  layout->add_option("--out", options->out, "new scene file")->required()->check(NotEmpty());
  AddPathOption(layout, &options->path);
  AddRobotOptions(layout, /*may_be_absent=*/false, &options->robot);
  layout->callback([options, answer] { *answer = WriteLayout(*options); });
}

}  // namespace smile::app
