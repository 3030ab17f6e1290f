#include "record/recorder.h"

#include <stdexcept>
#include <system_error>

#include "base/diagnostic.h"
#include "base/files.h"
#include "mesh/import_mesh.h"
#include "record/recording.h"
#include "scene_xml/mesh_files.h"
#include "scene_xml/scene_writer.h"
#include "sim/command_json.h"

namespace smile::record {
namespace {

void CopyFile(const std::filesystem::path& from, const std::filesystem::path& to) {
  WriteFile(to, ReadFile(from, 64u << 20));
}

/// What the scene is made of belongs to the recording, which may outlive the original.
void WriteMeshes(const scene::SceneSpec& scene, const std::filesystem::path& folder) {
  const std::vector<scene_xml::MeshFile> files = scene_xml::MeshFilesOf(scene);
  if (!files.empty()) MakeDirectories(folder);
  for (const scene_xml::MeshFile& file : files) {
    mesh::WriteStl(file.mesh->surface, folder / file.name);
  }
}

/// Makes the directory with everything that stands there before the first tick; returns it.
const std::filesystem::path& Prepare(const std::filesystem::path& directory,
                                     const RecorderOptions& options, const sim::Eye* eye,
                                     const sim::Simulation& simulation) {
  if (simulation.tick() != 0) {
    throw std::invalid_argument("recording: the simulation has already begun");
  }
  if (!(options.frames_per_second > 0 && options.frames_per_second <= sim::kTicksPerSecond)) {
    throw std::invalid_argument("recording: frames per second are " +
                                std::to_string(options.frames_per_second) +
                                ", expected more than 0 and at most 60");
  }
  std::error_code error;
  if (std::filesystem::exists(directory, error) && !std::filesystem::is_empty(directory, error)) {
    throw InputError({directory.string(), 0, "",
                      "exists already; a recording is never overwritten, name a new directory"});
  }
  MakeDirectories(directory);
  WriteMeshes(simulation.scene(), directory / scene_xml::kMeshFolder);
  WriteFile(directory / "scene.xml", scene_xml::WriteScene(simulation.scene()));

  DemoInfo info{.scene = simulation.scene().name,
                .title = options.title,
                .notes = options.notes,
                .meters_per_unit = simulation.scene().meters_per_unit,
                .frames_per_second = options.frames_per_second};
  if (const auto& placement = simulation.robot_placement()) {
    info.robot = RobotInfo{
        .name = placement->model.name, .gap = placement->gap, .height = placement->height};
    CopyFile(placement->urdf, directory / kRobotFile);
    const auto side_file = std::filesystem::path(placement->urdf).replace_extension(".robot.json");
    if (std::filesystem::exists(side_file, error)) {
      CopyFile(side_file,
               directory / std::filesystem::path(kRobotFile).replace_extension(".robot.json"));
    }
  }
  if (eye != nullptr) info.eye = EyeView(simulation, eye->spec());
  WriteFile(directory / "demo.json", ToJsonText(info));
  return directory;
}

}  // namespace

Recorder::Recorder(const std::filesystem::path& directory, const RecorderOptions& options,
                   sim::Eye* eye, const sim::Simulation& simulation)
    : commands_(Prepare(directory, options, eye, simulation) / "commands.jsonl"),
      trace_(directory / "trace.bin", simulation),
      classic_(directory, options.frames_per_second, eye, simulation) {
  trace_.Add(Observe(simulation));
}

void Recorder::OnCommand(const sim::Simulation& simulation, const sim::Command& command) {
  Json line = {{"tick", simulation.tick()}};
  line.update(sim::ToJson(command, simulation.scene().meters_per_unit));
  commands_.Append(ToText(line) + "\n");
}

void Recorder::OnEvent(const sim::Simulation& simulation, const sim::Event& event) {
  classic_.Note(event, simulation);
}

void Recorder::OnTick(const sim::Simulation& simulation) {
  trace_.Add(Observe(simulation));
  classic_.Watch(simulation);
}

}  // namespace smile::record
