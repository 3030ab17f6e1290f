#include "datasets/dataset_requests.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <string_view>
#include <thread>
#include <utility>

#include "base/file_state.h"
#include "base/files.h"
#include "base/wording.h"
#include "datasets/dataset_formats.h"
#include "datasets/film_job.h"
#include "datasets/new_path.h"
#include "datasets/picture_fields.h"
#include "datasets/program_progress.h"
#include "datasets/variations.h"
#include "experiment/json_file.h"
#include "layout/layout_level.h"
#include "library/brain_choices.h"
#include "library/scene_catalog.h"
#include "page/request_fields.h"
#include "texts/user_message.h"

// Handlers run in the session's thread and only look at a few files; programs do the work. Names in
// requests come from anyone: they become paths only through NewPathIn(),
// GeneratedSets, Library::DirectoryOf(), SceneCatalog and the list of brains.

namespace smile::datasets {

using texts::Say;
namespace {

namespace fs = std::filesystem;

/// Up to here integers are exact in JSON numbers, and attempts have further seeds.
constexpr std::uint64_t kMaxSeed = std::uint64_t{1} << 52;
constexpr std::size_t kMaxCameras = 8;

/// Runs of a generation at a time: at most as many as there are cores.
std::uint64_t MaxJobs() { return std::max(1u, std::thread::hardware_concurrency()); }

template <class List>
Json ListOf(const List& values) {
  Json list = Json::array();
  for (const auto& value : values) list.push_back(value);
  return list;
}

/// Returns the brain of this name, which reads demonstrations.
library::BrainChoice ImitatorNamed(const std::vector<fs::path>& folders, const std::string& name) {
  const auto choices = library::BrainsIn(folders);
  const library::BrainChoice* choice = library::BrainNamed(choices, name);
  if (choice == nullptr)
    throw page::RequestError(Say("brain.isUnknown", {{"brain", Quoted(name)}}));
  if (choice->imitates) return *choice;
  throw page::RequestError(Say("brain.doesNotImitate", {{"brain", Quoted(name)}}));
}

/// Returns the fields of `generate` without those of the message.
Json KeptOf(const Json& wanted) {
  Json kept = Json::object();
  for (const char* key :
       {"recording", "name", "scene", "brain", "count", "level", "seed", "jobs", "variations"}) {
    if (wanted.contains(key)) kept[key] = wanted[key];
  }
  return kept;
}

/// Returns how far an export is that prints `episode 3 of 10…` when it begins the third one.
Json ExportProgress(const std::string& line) {
  Json progress = ProgressIn(line, "episode ");
  if (progress.contains("done")) progress["done"] = progress["done"].get<int>() - 1;
  return progress;
}

/// Returns the cameras as arguments.
std::vector<std::string> CameraArguments(const page::RequestFields& fields) {
  const std::string size = ":" + SizeArgument(fields);
  std::vector<std::string> arguments;
  (void)fields.List("cameras", kMaxCameras);
  for (const std::string& camera : fields.Words("cameras", kCameras)) {
    arguments.insert(arguments.end(), {"--camera", camera + size});
  }
  if (arguments.empty()) arguments = {"--camera", "none"};
  return arguments;
}

}  // namespace

DatasetRequests::DatasetRequests(DatasetOptions options, const library::Library* library)
    : options_(std::move(options)), library_(library), sets_(library->root()) {}

void DatasetRequests::AddTo(page::RequestTable* table, const page::InBackground& in_background) {
  AddReading(table, in_background);
  const auto add = [table, this](const char* name,
                                 Json (DatasetRequests::*member)(const page::Request&)) {
    table->requests[name] = {
        [this, member](const page::Request& request) { return (this->*member)(request); }};
  };
  add("generate", &DatasetRequests::Generate);
  add("continue_set", &DatasetRequests::Continue);
  add("export", &DatasetRequests::Export);
  add("film", &DatasetRequests::Film);
  for (const char* name : {"generate", "continue_set"}) {
    table->requests[name].refuse =
        [this](const page::Request&) -> std::optional<texts::UserMessage> {
      if (options_.has_robot) return std::nullopt;
      return Say("sets.noRobot");
    };
  }
  table->requests["stop_job"] = {[this](const page::Request& request) {
    jobs_.Stop(static_cast<int>(page::RequestFields(request).Whole("job", 1'000'000'000)));
    return Json::object();
  }};
  AddTidying(table);
  table->deferred.emplace_back([this] { return TakeChanges(); });
}

void DatasetRequests::AddTidying(page::RequestTable* table) {
  // Handlers share a thread, so no job begins to use a set while it moves.
  const auto unused = [this](const page::Request& request) {
    const std::string set = page::RequestFields(request).Text("set");
    if (!jobs_.IsUsing(set)) return set;
    throw page::RequestError(Say("sets.isUsed", {{"set", Quoted(set)}}));
  };
  table->requests["rename_set"] = {[this, unused](const page::Request& request) {
    sets_.Rename(unused(request), page::RequestFields(request).Text("name"));
    return Json::object();
  }};
  table->requests["bin_set"] = {[this, unused](const page::Request& request) -> Json {
    return {{"set", sets_.Bin(unused(request))}};
  }};
  table->requests["unbin_set"] = {[this](const page::Request& request) -> Json {
    return {{"set", sets_.Unbin(page::RequestFields(request).Text("set"))}};
  }};
}

void DatasetRequests::AddReading(page::RequestTable* table,
                                 const page::InBackground& in_background) {
  table->requests["jobs"] = {[this](const page::Request&) { return Describe(); },
                             /*is_for_anyone=*/true};
  const auto list = [this, in_background](const page::Request& request) {
    in_background(request, [this]() -> Json { return {{"sets", sets_.List()}}; });
    return page::AnswersLater();
  };
  table->requests["sets"] = {list, /*is_for_anyone=*/true};
  const auto open = [this, in_background](const page::Request& request) {
    const std::string set = page::RequestFields(request).Text("set");
    in_background(request, [this, set]() -> Json {
      return {{"set", sets_.Describe(set)}, {"attempts", sets_.AttemptsOf(set)}};
    });
    return page::AnswersLater();
  };
  table->requests["open_set"] = {open, /*is_for_anyone=*/true};
}

Json DatasetRequests::Describe() const {
  return {{"jobs", jobs_.List()},
          {"folder", library_->root().string()},
          {"levels", ListOf(layout::kLayoutLevelWords)},
          {"variations", DescribeVariations()},
          {"formats", ListOf(kDatasetFormats)},
          {"cameras", ListOf(kCameras)},
          {"rates", ListOf(kRates)},
          {"max_count", kMaxCount},
          {"max_jobs", MaxJobs()}};
}

std::vector<std::string> DatasetRequests::GenerateArguments(const page::Request& request) const {
  const page::RequestFields fields(request);
  const auto text = [](std::uint64_t number) { return std::to_string(number); };
  const std::pair<const char*, std::string> options[] = {
      {"--scene", SceneNamed(fields.Text("scene")).string()},
      {"--brain", ImitatorNamed(options_.brains, fields.Text("brain")).path.string()},
      {"--count", text(WholeFrom(fields, "count", 1, kMaxCount))},
      {"--level", fields.Word("level", layout::kLayoutLevelWords)},
      {"--seed", text(fields.Whole("seed", kMaxSeed))},
      {"--jobs", text(WholeFrom(fields, "jobs", 1, MaxJobs()))},
      {"--out", sets_.FolderFor(fields.Text("name")).string()}};
  std::vector<std::string> arguments{options_.program.string(), "generate",
                                     library_->DirectoryOf(fields.Text("recording")).string()};
  for (const auto& [name, value] : options) arguments.insert(arguments.end(), {name, value});
  if (fields.Has("variations")) {
    std::ranges::move(VariationArguments(fields.Object("variations")),
                      std::back_inserter(arguments));
  }
  arguments.insert(arguments.end(), options_.robot_arguments.begin(),
                   options_.robot_arguments.end());
  return arguments;
}

Json DatasetRequests::Generate(const page::Request& request) {
  const std::string name = page::RequestFields(request).Text("name");
  if (StateOf(sets_.FolderFor(name)) != FileState()) {
    throw page::RequestError(Say("sets.existsAndCanContinue", {{"set", Quoted(name)}}));
  }
  return Start(request.fields);
}

Json DatasetRequests::Continue(const page::Request& request) {
  const std::string name = page::RequestFields(request).Text("set");
  (void)sets_.FolderOf(name);
  const fs::path file = sets_.RequestFileOf(name);
  if (!StateOf(file).is_file) {
    throw page::RequestError(Say("sets.isFromElsewhere", {{"set", Quoted(name)}}));
  }
  Json wanted = experiment::ReadJsonFile(file);
  // The file may be anyone's, but not about another set.
  wanted["name"] = name;
  return Start(wanted);
}

Json DatasetRequests::Start(const Json& wanted) {
  const page::Request request{.what = "generate", .fields = wanted};
  const page::RequestFields fields(request);
  const std::string name = fields.Text("name");
  const auto count = static_cast<std::size_t>(fields.Whole("count", kMaxCount));
  JobProgram program{.arguments = GenerateArguments(request),
                     .log = sets_.FolderFor(name).string() + ".log"};
  if (jobs_.IsBusy("generate", name)) {
    throw page::RequestError(Say("sets.isBeingMade", {{"name", Quoted(name)}}));
  }
  MakeDirectories(program.log.parent_path());
  // So that the set can be continued, also by another studio.
  WriteFile(sets_.RequestFileOf(name), ToText(KeptOf(wanted)) + "\n");
  const int job = jobs_.Add({.what = "generate",
                             .name = name,
                             .set = name,
                             .programs = {std::move(program)},
                             .progress = [this, name, count](const std::string&) {
                               return sets_.ProgressOf(name, count);
                             }});
  return {{"job", job}};
}

std::vector<std::string> DatasetRequests::ExportArguments(const page::Request& request,
                                                          const fs::path& to) const {
  const page::RequestFields fields(request);
  const auto recording = fields.OptionalText("recording");
  const fs::path run =
      recording ? library_->DirectoryOf(*recording) : sets_.FolderOf(fields.Text("set"));
  std::vector<std::string> arguments{options_.program.string(),
                                     "export",
                                     run.string(),
                                     "--to",
                                     fields.Word("format", kDatasetFormats),
                                     "--fps",
                                     RateArgument(fields),
                                     "--out",
                                     to.string()};
  for (std::string& argument : CameraArguments(fields)) arguments.push_back(std::move(argument));
  if (fields.Flag("include_failed")) arguments.emplace_back("--include-failed");
  if (fields.Flag("drop_constant")) arguments.emplace_back("--drop-constant");
  return arguments;
}

Json DatasetRequests::Export(const page::Request& request) {
  const std::string name = page::RequestFields(request).Text("name");
  const fs::path to =
      NewPathIn(library_->root(), {.folder = kExportFolder, .kind = "dataset"}, name);
  const std::vector<std::string> doctor{options_.program.string(), "doctor", to.string()};
  const int job = jobs_.Add(
      {.what = "export",
       .name = name,
       .set = page::RequestFields(request).OptionalText("set").value_or(""),
       .programs = {{.arguments = ExportArguments(request, to), .log = to.string() + ".log"},
                    {.arguments = doctor, .log = to.string() + ".doctor.log", .is_check = true}},
       .progress = &ExportProgress});
  return {{"job", job}};
}

Json DatasetRequests::Film(const page::Request& request) {
  return {{"job", jobs_.Add(FilmJob(request, *library_, options_.program))}};
}

fs::path DatasetRequests::SceneNamed(const std::string& name) const {
  // The scene with which the studio began may be a file of the user, which is not among the others.
  if (options_.scene.stem() == name) return options_.scene;
  if (const auto file = library::SceneCatalog(options_.scene_folder).FileOf(name)) return *file;
  throw page::RequestError(Say("session.noScene", {{"scene", Quoted(name)}}));
}

std::vector<page::DeferredMessage> DatasetRequests::TakeChanges() {
  const std::size_t now = jobs_.num_changes();
  if (std::exchange(num_changes_, now) == now) return {};
  return {{.message = {{"t", "jobs"}, {"jobs", jobs_.List()}}}};
}

}  // namespace smile::datasets
