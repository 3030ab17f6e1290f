#include "studio/library_requests.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "editing/edit_json.h"
#include "picture/rendered_eye.h"
#include "recording/recording_names.h"
#include "recording/sight.h"

namespace smile::studio {
namespace {

std::optional<std::string> TextIfGiven(const page::Request& request, const char* key) {
  const auto field = request.fields.find(key);
  if (field == request.fields.end() || field->is_null()) return std::nullopt;
  if (!field->is_string()) {
    throw page::RequestError("\"" + std::string(key) + "\" is " + field->type_name() +
                             ", expected a text");
  }
  return field->get<std::string>();
}

std::string TextOf(const page::Request& request, const char* key) {
  auto text = TextIfGiven(request, key);
  if (!text) throw page::RequestError("\"" + std::string(key) + "\" is missing");
  return *std::move(text);
}

std::vector<editing::Edit> EditsOf(const page::Request& request) {
  const auto field = request.fields.find("edits");
  if (field == request.fields.end()) throw page::RequestError("\"edits\" is missing");
  return editing::ParseEdits(*field);
}

Json TryEdits(const std::filesystem::path& directory, const std::vector<editing::Edit>& edits,
              const recording::Progress& progress) {
  const recording::Recording recording = recording::OpenRecording(directory);
  const auto edited = EditedByAll(DemonstrationOf(recording), edits);
  return {{"report", ToJson(editing::ReSimulate(recording, edited, std::nullopt, progress))}};
}

/// @param title  of the new recording.
Json MakeEdits(const std::filesystem::path& directory, const std::vector<editing::Edit>& edits,
               const std::filesystem::path& root, const std::string& title,
               const recording::Progress& progress) {
  const recording::Recording recording = recording::OpenRecording(directory);
  const auto edited = EditedByAll(DemonstrationOf(recording), edits);
  const auto made = recording::NewDirectory(root, recording::RecordingNameFor(title));
  std::optional<picture::RenderedEye> eye;
  if (const auto spec = EyeOf(recording.info)) eye.emplace(*spec);
  const auto report = editing::MakeEdited(
      recording, edited, {.directory = made, .eye = eye ? &*eye : nullptr}, progress);
  recording::Retitle(made, title, std::nullopt);
  return {{"recording", made.filename().string()}, {"report", ToJson(report)}};
}

void AddLookUps(const library::Library* library, Workshop* workshop, page::RequestTable* table) {
  const auto list = [library, workshop](const page::Request& request) {
    const auto work = [library](const recording::Progress&) -> Json {
      return {{"recordings", library->List()}};
    };
    workshop->Begin({.request = request, .work = work});
    return page::AnswersLater();
  };
  table->entries["library"] = {list, /*is_for_anyone=*/true};
  const auto open = [library, workshop](const page::Request& request) {
    const auto work = [library,
                       id = TextOf(request, "recording")](const recording::Progress&) -> Json {
      return {{"timeline", library->TimelineOf(id)}};
    };
    workshop->Begin({.request = request, .work = work, .replaces_older = true});
    return page::AnswersLater();
  };
  table->entries["open"] = {open, /*is_for_anyone=*/true};
}

void AddTidying(const library::Library* library, page::RequestTable* table) {
  table->entries["rename"] = {[library](const page::Request& request) {
    library->Rename(TextOf(request, "recording"), TextIfGiven(request, "title"),
                    TextIfGiven(request, "notes"));
    return Json::object();
  }};
  table->entries["bin"] = {[library](const page::Request& request) -> Json {
    return {{"recording", library->Bin(TextOf(request, "recording"))}};
  }};
  table->entries["unbin"] = {[library](const page::Request& request) -> Json {
    return {{"recording", library->Unbin(TextOf(request, "recording"))}};
  }};
}

void AddEditing(const library::Library* library, Workshop* workshop, page::RequestTable* table) {
  table->entries["try_edit"] = {[library, workshop](const page::Request& request) {
    const auto directory = library->DirectoryOf(TextOf(request, "recording"));
    const auto work = [directory, edits = EditsOf(request)](const recording::Progress& progress) {
      return TryEdits(directory, edits, progress);
    };
    workshop->Begin({.request = request, .work = work, .replaces_older = true});
    return page::AnswersLater();
  }};
  table->entries["edit"] = {[library, workshop](const page::Request& request) {
    const auto directory = library->DirectoryOf(TextOf(request, "recording"));
    const std::string title = TextOf(request, "name");
    recording::CheckTitle(title);
    const auto work = [directory, edits = EditsOf(request), root = library->root(),
                       title](const recording::Progress& progress) {
      return MakeEdits(directory, edits, root, title, progress);
    };
    workshop->Begin({.request = request, .work = work});
    return page::AnswersLater();
  }};
}

/// Tells everyone when recordings came or went, whoever did that: a program or a person.
class LibraryWatch {
 public:
  explicit LibraryWatch(const library::Library* library)
      : library_(library), stamp_(library->Stamp()) {}

  /// To be called 60 times a second; looks once a second.
  std::vector<page::Letter> TakeLetters() {
    constexpr int kCallsBetween = 60;
    if (++num_calls_ % kCallsBetween != 0) return {};
    std::string now = library_->Stamp();
    if (std::exchange(stamp_, now) == now) return {};
    return {{.message = {{"t", "library"}}}};
  }

 private:
  const library::Library* library_;
  std::string stamp_;
  int num_calls_ = 0;
};

}  // namespace

void AddLibraryRequests(const library::Library* library, Workshop* workshop,
                        page::RequestTable* table) {
  AddLookUps(library, workshop, table);
  AddTidying(library, table);
  AddEditing(library, workshop, table);
  table->letters.emplace_back([workshop] { return workshop->TakeLetters(); });
  table->letters.emplace_back(
      [watch = LibraryWatch(library)]() mutable { return watch.TakeLetters(); });
}

}  // namespace smile::studio
