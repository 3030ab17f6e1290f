// How a session comes by its scenes.

#include <algorithm>
#include <utility>

#include "base/files.h"
#include "base/wording.h"
#include "library/gallery.h"
#include "studio/internal_session.h"
#include "studio/present_scene.h"
#include "studio/presets.h"

namespace smile::studio {
namespace {

/// A scene that came from a page is no larger: it is read while people wait.
constexpr int kMaxObjects = 2'000, kMaxElements = 20'000;
constexpr std::size_t kMaxText = std::size_t{1} << 20;

bool OverlapsRobot(const sim::Simulation& simulation, std::size_t first_object) {
  constexpr double kDepth = 0.0005;  // [m]
  const auto& objects = simulation.tabletop().objects();
  return std::any_of(objects.begin() + static_cast<std::ptrdiff_t>(first_object), objects.end(),
                     [&](const world::Object& object) {
                       return simulation.physics()
                           .OverlapsAt(object.body, object.spec->pose_in_world(), kDepth)
                           .with_articulation;
                     });
}

}  // namespace

scene::SceneSpec Session::Impl::ReadNamedScene(const std::string& name) const {
  const auto file = library::Gallery(options_.gallery).FileOf(name);
  if (!file) throw page::RequestError("there is no scene " + Quoted(name));
  return scene_xml::LoadScene(*file, options_.reader);
}

scene_xml::SceneReading Session::Impl::ReadText(const page::RequestFields& fields) const {
  const std::string text = fields.Text("xml", kMaxText);
  std::string name = fields.OptionalText("name").value_or("scene.xml");
  // A name, wherever it came from.
  name = std::filesystem::path(name).filename().string();
  scene_xml::SceneReaderOptions options = options_.reader;
  options.search_roots.push_back(options_.gallery);
  options.limits.max_objects = std::min(options.limits.max_objects, kMaxObjects);
  options.limits.max_elements = std::min(options.limits.max_elements, kMaxElements);
  return scene_xml::ReadSceneText(text, name, options);
}

scene::SceneSpec Session::Impl::ReadSceneOf(const page::RequestFields& fields) const {
  if (!fields.Has("xml")) return ReadNamedScene(fields.Text("scene"));
  scene_xml::SceneReading reading = ReadText(fields);
  if (!reading.scene) throw InputError(std::move(reading.diagnostics));
  return *std::move(reading.scene);
}

recorder::RecordingDesk::Options Session::Impl::DeskOptions() const {
  return {.root = options_.recordings, .recording = options_.recording, .eye = options_.eye};
}

std::unique_ptr<LiveWorld> Session::Impl::MakeWorld(scene::SceneSpec scene,
                                                    std::optional<sim::RobotPlacement> robot) {
  return std::make_unique<LiveWorld>(std::move(scene), std::move(robot), DeskOptions());
}

void Session::Impl::Enter(std::unique_ptr<LiveWorld> world) {
  brain_.Leave();
  playback_.reset();
  world_state_.reset();
  rehearsal_.Forget();
  resting_place_.Forget();
  world_ = std::move(world);
  world_state_ = std::make_unique<LiveState>(world_.get(), &brain_);
  // What its recording saw when it was made anew is no news.
  if (EyeTap* eye = world_->eye()) (void)eye->Take();
  TellAllOfScene();
}

void Session::Impl::Recompose(scene::SceneSpec scene) {
  auto world = MakeWorld(std::move(scene), world_->simulation().model().robot_placement());
  for (const sim::Command& command : WhatGoesOn(world_->simulation())) {
    (void)world->Apply(command);
  }
  Enter(std::move(world));
}

std::unique_ptr<LiveWorld> Session::Impl::WorldWith(const std::string& preset, std::uint64_t seed) {
  constexpr std::uint64_t kMaxTries = 20, kBetweenSeeds = 0x9E3779B97F4A7C15;
  const scene::SceneSpec present = PresentScene(world_->simulation());
  for (std::uint64_t i = 0; i < kMaxTries; ++i) {
    auto world = MakeWorld(WithPreset(present, preset, seed + i * kBetweenSeeds),
                           world_->simulation().model().robot_placement());
    for (const sim::Command& command : WhatGoesOn(world_->simulation())) {
      (void)world->Apply(command);
    }
    if (!OverlapsRobot(world->simulation(), present.objects.size())) return world;
  }
  throw page::RequestError("there is no free place on the table: the robot's arms are in the way");
}

}  // namespace smile::studio
