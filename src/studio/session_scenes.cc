// How a session comes by its scenes.

#include <algorithm>
#include <utility>

#include "base/files.h"
#include "base/wording.h"
#include "library/gallery.h"
#include "sim/add.h"
#include "studio/internal_session.h"

namespace smile::studio {
namespace {

/// A scene that came from a page is no larger: it is read while people wait.
constexpr int kMaxObjects = 2'000, kMaxElements = 20'000;
constexpr std::size_t kMaxText = std::size_t{1} << 20;

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

void Session::Impl::Enter(std::unique_ptr<LiveWorld> world) {
  world_state_.reset();
  world_ = std::move(world);
  // What its recording saw when it was made anew is no news.
  if (EyeTap* eye = world_->eye()) (void)eye->Take();
  BeginScene();
}

void Session::Impl::BeginScene() {
  brain_.Leave();
  playback_.reset();
  resting_place_.Forget();
  world_state_ = std::make_unique<LiveState>(world_.get(), &brain_);
  TellAllOfScene();
}

void Session::Impl::LoadScene(scene::SceneSpec scene) {
  Apply(sim::Load{std::make_shared<const scene::SceneSpec>(std::move(scene))});
}

Json Session::Impl::Spawn(const page::RequestFields& fields) {
  const sim::Add add{.preset = fields.Text("preset"), .seed = fields.Whole("seed", sim::kMaxSeed)};
  sim::Refusal refusal;
  const auto spawn = sim::SpawnOf(add, world_->simulation(), &refusal);
  if (!spawn) throw page::RequestError(refusal);
  Apply(*spawn);
  return {{"objects", world_->simulation().history().current().events.front().objects}};
}

Json Session::Impl::Clear(const page::RequestFields& fields) {
  if (fields.Flag("rage")) {
    world_state_ = std::make_unique<RageState>(world_.get());
  } else {
    Apply(sim::Clear{});
  }
  return Json::object();
}

}  // namespace smile::studio
