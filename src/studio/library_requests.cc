#include "studio/library_requests.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "analysis/analysis.h"
#include "analysis/analysis_json.h"
#include "editing/edit_json.h"
#include "editing/edit_previews.h"
#include "page/request_fields.h"
#include "picture/rendered_eye.h"
#include "recording/recording.h"
#include "recording/recording_names.h"
#include "report/analysis_page.h"

// Requests about recordings on disk. They do not touch the live world: handlers run in the
// session's thread, and whatever reads or simulates much runs as a background job.

namespace smile::studio {
namespace {

/// Age at which the preview of an edit is removed.
constexpr auto kMaxPreviewAge = std::chrono::minutes(10);

/// Returns a text field; nullopt if it is missing or null.
std::optional<std::string> TextIfGiven(const page::Request& request, const char* key) {
  const auto field = request.fields.find(key);
  if (field == request.fields.end() || field->is_null()) return std::nullopt;
  if (!field->is_string()) {
    throw page::RequestError("\"" + std::string(key) + "\" is " + field->type_name() +
                             ", expected a string");
  }
  return field->get<std::string>();
}

/// Returns a text field.
/// @throws page::RequestError if it is missing.
std::string TextOf(const page::Request& request, const char* key) {
  auto text = TextIfGiven(request, key);
  if (!text) throw page::RequestError("\"" + std::string(key) + "\" is missing");
  return *std::move(text);
}

/// Returns a list of texts; empty if it is missing.
std::vector<std::string> TextsIfGiven(const page::Request& request, const char* key) {
  const auto field = request.fields.find(key);
  if (field == request.fields.end()) return {};
  const auto is_text = [](const Json& one) { return one.is_string(); };
  if (!field->is_array() || !std::ranges::all_of(*field, is_text)) {
    throw page::RequestError("\"" + std::string(key) + "\" is " + field->type_name() +
                             ", expected a list of strings");
  }
  return field->get<std::vector<std::string>>();
}

/// Returns the recording and the edits of a request.
/// @throws page::RequestError or std::invalid_argument for faulty ones.
editing::EditRequest EditsOf(const library::Library& library, const page::Request& request) {
  auto directory = library.DirectoryOf(TextOf(request, "recording"));
  const auto field = request.fields.find("edits");
  if (field == request.fields.end()) throw page::RequestError("\"edits\" is missing");
  return {.recording = std::move(directory), .edits = editing::ParseEdits(*field)};
}

/// @param title  of the new recording.
Json MakeEdits(editing::EditPreviews* previews, const editing::EditRequest& edits,
               const std::filesystem::path& root, const std::string& title,
               const recording::Progress& progress) {
  const auto made = recording::NewDirectory(root, recording::RecordingNameFor(title));
  const auto report = previews->Save(edits, made, progress);
  recording::Retitle(made, title, std::nullopt);
  return {{"recording", made.filename().string()}, {"report", ToPageJson(report)}};
}

/// Adds requests that only read. They run in the background, since they read files.
void AddLookUps(const library::Library* library, BackgroundJobs* jobs, page::RequestTable* table) {
  const auto list = [library, jobs](const page::Request& request) {
    const auto work = [library](const recording::Progress&) -> Json {
      return {{"recordings", library->List()}};
    };
    jobs->Begin({.request = request, .work = work});
    return page::AnswersLater();
  };
  table->requests["library"] = {list, /*is_for_anyone=*/true};
  const auto open = [library, jobs](const page::Request& request) {
    // The id is copied: a job outlives its request.
    const auto work = [library,
                       id = TextOf(request, "recording")](const recording::Progress&) -> Json {
      return {{"timeline", library->TimelineOf(id)}};
    };
    jobs->Begin({.request = request, .work = work, .replaces_older = true});
    return page::AnswersLater();
  };
  table->requests["open"] = {open, /*is_for_anyone=*/true};
}

/// Adds requests that change titles and move recordings to and from the bin.
void AddTidying(const library::Library* library, page::RequestTable* table) {
  table->requests["rename"] = {[library](const page::Request& request) {
    library->Rename(TextOf(request, "recording"), TextIfGiven(request, "title"),
                    TextIfGiven(request, "notes"));
    return Json::object();
  }};
  table->requests["bin"] = {[library](const page::Request& request) -> Json {
    return {{"recording", library->Bin(TextOf(request, "recording"))}};
  }};
  table->requests["unbin"] = {[library](const page::Request& request) -> Json {
    return {{"recording", library->Unbin(TextOf(request, "recording"))}};
  }};
}

/// Adds the request that analyzes a demonstration, in the background.
void AddAnalysis(const library::Library* library, BackgroundJobs* jobs, page::RequestTable* table) {
  table->requests["analyze"] = {[library, jobs](const page::Request& request) {
    const auto work =
        [directory = library->DirectoryOf(TextOf(request, "recording")),
         ignored = TextsIfGiven(request, "ignored")](const recording::Progress& progress) -> Json {
      const auto report = [&](std::size_t done, std::size_t at_most) {
        return progress(static_cast<double>(done), static_cast<double>(at_most));
      };
      // One core remains for the live world.
      const unsigned threads = std::max(2u, std::thread::hardware_concurrency()) - 1;
      const auto analysis =
          analysis::Analyze(recording::OpenRecording(directory),
                            {.num_threads = threads, .ignored = ignored, .progress = report});
      return {{"analysis", ToJson(analysis, texts::ToJson)}, {"graph", report::GraphOf(analysis)}};
    };
    jobs->Begin(
        {.request = request, .work = work, .replaces_older = true, .can_be_canceled = true});
    return page::AnswersLater();
  }};
}

/// Adds the requests about edits. Edits are simulated in the background.
void AddEditing(const library::Library* library, BackgroundJobs* jobs, page::RequestTable* table) {
  // Shared by the table and running jobs, either of which may be destroyed first.
  const auto previews = std::make_shared<editing::EditPreviews>(
      [](const model::EyeSpec& spec) { return std::make_unique<picture::RenderedEye>(spec); });
  table->requests["try_edit"] = {[=](const page::Request& request) {
    const auto work = [previews, edits = EditsOf(*library, request)](
                          const recording::Progress& progress) -> Json {
      return {{"report", ToPageJson(previews->Preview(edits, progress))}};
    };
    jobs->Begin(
        {.request = request, .work = work, .replaces_older = true, .can_be_canceled = true});
    return page::AnswersLater();
  }};
  table->requests["edit"] = {[=](const page::Request& request) {
    const std::string title = TextOf(request, "name");
    // Checked now, so that a wrong title is not reported after a long simulation.
    recording::CheckTitle(title);
    const auto work = [previews, edits = EditsOf(*library, request), root = library->root(),
                       title](const recording::Progress& progress) {
      return MakeEdits(previews.get(), edits, root, title, progress);
    };
    jobs->Begin({.request = request, .work = work, .can_be_canceled = true});
    return page::AnswersLater();
  }};
  const auto cancel = [jobs](const page::Request& request) {
    constexpr auto kMaxSeq = std::numeric_limits<std::uint32_t>::max();
    const std::uint64_t seq = page::RequestFields(request).Whole("request", kMaxSeq);
    jobs->Cancel(request.client, static_cast<std::uint32_t>(seq));
    return Json::object();
  };
  table->requests["cancel"] = {cancel, /*is_for_anyone=*/true};
  table->deferred.emplace_back([previews] {
    previews->RemoveOlderThan(kMaxPreviewAge);
    return std::vector<page::DeferredMessage>();
  });
}

/// Notifies all clients when recordings appear, disappear or change titles, caused by this program
/// or from outside.
class LibraryWatch {
 public:
  explicit LibraryWatch(const library::Library* library)
      : library_(library), stamp_(library->Stamp()) {}

  /// To be called 60 times a second; checks once a second.
  std::vector<page::DeferredMessage> TakeDeferred() {
    constexpr int kCallsBetween = 60;
    // Looking at the folder costs system calls in the session's thread.
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

void AddLibraryRequests(const library::Library* library, BackgroundJobs* jobs,
                        page::RequestTable* table) {
  AddLookUps(library, jobs, table);
  AddTidying(library, table);
  AddAnalysis(library, jobs, table);
  AddEditing(library, jobs, table);
  table->deferred.emplace_back([jobs] { return jobs->TakeDeferred(); });
  table->deferred.emplace_back(
      [watch = LibraryWatch(library)]() mutable { return watch.TakeDeferred(); });
}

}  // namespace smile::studio
