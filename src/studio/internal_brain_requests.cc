#include "studio/internal_brain_requests.h"

#include <string_view>
#include <utility>

#include "base/wording.h"
#include "experiment/brain_setup.h"
#include "recording/recording_names.h"
#include "texts/user_message.h"

// Brains run in processes of their own (LiveBrain). The handlers here find the program, prepare the
// world, and start it; they never wait for it.

namespace smile::studio {

using texts::Say;

std::vector<library::BrainChoice> BrainRequests::Choices() const {
  return library::BrainsIn(library::BrainFolders(options_->brains));
}

Json BrainRequests::Describe(const page::RequestFields&) {
  Json described = Json::array();
  for (const library::BrainChoice& choice : Choices()) {
    described.push_back(
        {{"name", choice.name}, {"kind", choice.kind}, {"imitates", choice.imitates}});
  }
  return {{"brains", std::move(described)}};
}

library::BrainChoice BrainRequests::Find(const std::string& name) const {
  const std::vector<library::BrainChoice> brains = Choices();
  if (const library::BrainChoice* choice = library::BrainNamed(brains, name)) return *choice;
  std::vector<std::string_view> known;
  for (const library::BrainChoice& choice : brains) known.push_back(choice.name);
  throw page::RequestError("\"brain\" is " + Quoted(name) + ", expected " + OneOf(known) +
                           DidYouMean(name, known));
}

void BrainRequests::Run(const library::BrainChoice& choice,
                        const std::filesystem::path& demonstration) {
  states_->brain().Start(choice,
                         experiment::DriverOptionsFor(choice.path, demonstration, options_->eye),
                         &states_->world().simulation());
}

Json BrainRequests::Start(const page::RequestFields& fields) {
  const library::BrainChoice choice = Find(fields.Text("brain"));
  const auto demonstration = fields.OptionalText("demonstration");
  const std::filesystem::path directory =
      demonstration ? library_->DirectoryOf(*demonstration) : std::filesystem::path();
  // After everything that can be refused cheaply, since loading replaces the world. The brain
  // starts last: another world would end it.
  if (fields.OptionalText("scene")) (void)scenes_->Load(fields);
  Run(choice, directory);
  return Json::object();
}

std::optional<texts::UserMessage> BrainRequests::RefuseStart(
    const page::RequestFields& fields) const {
  return states_->Unmet(fields.OptionalText("scene") ? Need::kOtherWorld : Need::kCommands);
}

Json BrainRequests::Stop(const page::RequestFields&) {
  states_->brain().Stop(&states_->world().simulation());
  // An imitation ends with its brain, and sends its score now instead of at the next tick.
  states_->EndIfOver();
  return Json::object();
}

Json BrainRequests::Imitate(const page::RequestFields& fields) {
  const library::BrainChoice choice = Find(fields.Text("brain"));
  if (!choice.imitates) {
    throw page::RequestError(Say("brain.doesNotImitate", {{"brain", Quoted(choice.name)}}));
  }
  const std::string scene = fields.Text("scene");
  const std::filesystem::path directory = library_->DirectoryOf(fields.Text("recording"));
  // The task is made before the scene is loaded, so that an impossible task leaves the world
  // unchanged.
  const recording::Recording demonstration = recording::OpenRecording(directory);
  task::ImitationTask imitation_task =
      task::MakeImitationTask(scene, demonstration, SceneNamed(scene));
  scenes_->LoadScene(imitation_task.scene);
  Run(choice, directory);
  // Before the first tick, so that the recording has the whole imitation.
  const std::filesystem::path recording = RecordImitation(demonstration);
  states_->Imitate(std::move(imitation_task));
  return {{"recording", recording.filename().string()}};
}

scene::SceneSpec BrainRequests::SceneNamed(const std::string& name) const {
  // The scene that is open may be a file of the user, which is not among those that ship.
  const scene::SceneSpec& open = states_->world().simulation().start_model()->scene();
  return open.name == name ? open : source_->Named(name);
}

std::filesystem::path BrainRequests::RecordImitation(const recording::Recording& demonstration) {
  constexpr std::string_view kEnd = ", imitated";
  std::string title = demonstration.info.title;
  // The suffix must fit into the limit of titles.
  if (title.empty() || title.size() + kEnd.size() > recording::kMaxTitleBytes) {
    title = demonstration.directory.filename().string();
  }
  title += kEnd;
  LiveWorld& world = states_->world();
  if (const auto refusal = world.Apply(
          sim::StartRecording{.name = recording::RecordingNameFor(title), .title = title})) {
    // An imitation without a recording could not be evaluated later.
    states_->brain().Stop(&world.simulation());
    throw page::RequestError(Say("brain.cannotBeRecorded", {{"why", *refusal}}));
  }
  return world.recording_directory();
}

}  // namespace smile::studio
