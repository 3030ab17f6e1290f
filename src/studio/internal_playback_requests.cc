#include "studio/internal_playback_requests.h"

#include <memory>
#include <string>
#include <utility>
#include <variant>

namespace smile::studio {
namespace {

// Far beyond any recording; keeps absurd numbers from the conversion to ticks.
constexpr double kMaxSeconds = 1e6;

}  // namespace

Json PlaybackRequests::Show(const page::RequestFields& fields) {
  const std::string id = fields.Text("recording");
  const double seconds = fields.OptionalNumber("seconds", 0, kMaxSeconds).value_or(0);
  // Showing the same recording again only seeks.
  if (PlaybackState* shown = states_->playback(); shown && shown->playback().id() == id) {
    shown->playback().Seek(seconds);
    return {{"length", shown->playback().length()}};
  }
  // Opened before the former playback ends: a recording that cannot be read changes nothing.
  auto another = std::make_unique<PlaybackState>(id, library_->DirectoryOf(id));
  another->playback().Seek(seconds);
  const double length = another->playback().length();
  states_->Show(std::move(another));
  return {{"length", length}};
}

Json PlaybackRequests::Play(const page::RequestFields& fields) {
  const double rate = fields.OptionalNumber("rate", 0, library::Playback::kMaxRate).value_or(1);
  states_->playback()->playback().SetRate(rate);
  return Json::object();
}

Json PlaybackRequests::GoLive(const page::RequestFields&) {
  states_->GoLive();
  return Json::object();
}

Json PlaybackRequests::Branch(const page::RequestFields& fields) {
  return Restore(fields,
                 BranchPoint{.step = static_cast<std::size_t>(fields.Whole("step", 1'000'000'000)),
                             .after = fields.OptionalNumber("after", 0, kMaxSeconds)});
}

Json PlaybackRequests::RecordOver(const page::RequestFields& fields) {
  editing::KeptTracks kept{.hands = fields.Hands("hands"),
                           .seconds = fields.Number("seconds", 0, kMaxSeconds)};
  return Restore(fields, std::move(kept));
}

Json PlaybackRequests::Correct(const page::RequestFields& fields) {
  return Restore(fields, CorrectionBegin{.seconds = fields.Number("seconds", 0, kMaxSeconds)});
}

Json PlaybackRequests::Restore(const page::RequestFields& fields, Restoring::From from) {
  const std::string id = fields.Text("recording");
  // Continuing changes the recording; recording over it or correcting it makes another.
  const bool is_new = !std::holds_alternative<BranchPoint>(from);
  auto directory = is_new ? library_->DirectoryOf(id) : library_->ChangeableDirectoryOf(id);
  // Shared by the session and the background job, either of which may end first.
  const auto restoring = std::make_shared<Restoring>(id, std::move(directory), std::move(from),
                                                     RecordingOptionsOf(*options_));
  const auto work = [restoring](const recording::Progress& progress) -> Json {
    restoring->Make(progress);
    return {{"recording", restoring->recording()}};
  };
  // Runs in the session's thread: only there may the world be replaced.
  const auto conclude = [this, is_new] {
    auto made = states_->TakeRestored();
    if (!made) return;
    states_->Enter(std::move(made));
    // The user begins when ready.
    if (is_new) states_->pace().is_paused = true;
  };
  options_->jobs->Begin({.request = fields.request(), .work = work, .conclude = conclude});
  // From now on, other requests for worlds and recordings are refused until `conclude` has run.
  states_->Restore(restoring);
  return page::AnswersLater();
}

}  // namespace smile::studio
