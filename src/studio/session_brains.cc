// Robot programs at work in a session.

#include <utility>

#include "base/files.h"
#include "base/wording.h"
#include "experiment/brain_setup.h"
#include "recording/recording_names.h"
#include "studio/internal_session.h"

namespace smile::studio {

std::vector<library::BrainChoice> Session::Impl::Brains() const {
  std::vector<std::filesystem::path> folders = options_.brains;
  for (const char* shipped : {"matlab/examples", "python/examples", "matlab", "python"}) {
    folders.push_back(DataFile(shipped));
  }
  return library::BrainsIn(folders);
}

Json Session::Impl::DescribeBrains(const page::RequestFields&) {
  Json described = Json::array();
  for (const library::BrainChoice& choice : Brains()) {
    described.push_back(
        {{"name", choice.name}, {"kind", choice.kind}, {"imitates", choice.imitates}});
  }
  return {{"brains", std::move(described)}};
}

library::BrainChoice Session::Impl::FindBrain(const std::string& name) const {
  const std::vector<library::BrainChoice> brains = Brains();
  if (const library::BrainChoice* choice = library::BrainNamed(brains, name)) return *choice;
  std::vector<std::string_view> known;
  for (const library::BrainChoice& choice : brains) known.push_back(choice.name);
  throw page::RequestError("\"brain\" is " + Quoted(name) + ", expected " + OneOf(known) +
                           DidYouMean(name, known));
}

void Session::Impl::RunBrain(const library::BrainChoice& choice,
                             const std::filesystem::path& demonstration) {
  brain::BrainDriverOptions options = experiment::DriverOptionsFor(choice.path, demonstration);
  options.eye = options_.eye;
  brain_.Start(choice, options, &world_->simulation());
}

Json Session::Impl::StartBrain(const page::RequestFields& fields) {
  const library::BrainChoice choice = FindBrain(fields.Text("brain"));
  const auto demonstration = fields.OptionalText("demonstration");
  const std::filesystem::path directory =
      demonstration ? library_.DirectoryOf(*demonstration) : std::filesystem::path();
  if (fields.OptionalText("scene")) (void)Load(fields);
  RunBrain(choice, directory);
  return Json::object();
}

Json Session::Impl::StopBrain(const page::RequestFields&) {
  brain_.Stop(&world_->simulation());
  EndStateIfOver();
  return Json::object();
}

Json Session::Impl::Imitate(const page::RequestFields& fields) {
  const library::BrainChoice choice = FindBrain(fields.Text("brain"));
  if (!choice.imitates) {
    throw page::RequestError(Quoted(choice.name) +
                             " does not read demonstrations: its script lacks the line "
                             "\"smile: imitates\"");
  }
  const std::string scene = fields.Text("scene");
  const std::filesystem::path directory = library_.DirectoryOf(fields.Text("recording"));
  const recording::Recording demonstration = recording::OpenRecording(directory);
  task::Exercise exercise = task::MakeExercise(scene, demonstration, ReadNamedScene(scene));
  LoadScene(exercise.scene);
  RunBrain(choice, directory);
  const std::filesystem::path recording = RecordImitation(demonstration);
  world_state_ = std::make_unique<ImitatingState>(std::move(exercise), world_.get(), &brain_);
  return {{"recording", recording.filename().string()}};
}

std::filesystem::path Session::Impl::RecordImitation(const recording::Recording& demonstration) {
  constexpr std::string_view kEnd = ", imitated";
  std::string title = demonstration.info.title;
  if (title.empty() || title.size() + kEnd.size() > recording::kMaxTitleBytes) {
    title = demonstration.directory.filename().string();
  }
  title += kEnd;
  if (const auto refusal = world_->Apply(
          sim::StartRecording{.name = recording::RecordingNameFor(title), .title = title})) {
    brain_.Stop(&world_->simulation());
    throw page::RequestError("the imitation cannot be recorded: " + *refusal);
  }
  return world_->recording_directory();
}

}  // namespace smile::studio
