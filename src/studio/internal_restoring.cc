#include "studio/internal_restoring.h"

#include <utility>

#include "picture/rendered_eye.h"
#include "recording/recording_history.h"
#include "texts/user_message.h"

namespace smile::studio {

using texts::Say;

Restoring::Restoring(std::string recording, std::filesystem::path directory, From from,
                     recorder::RecordingController::Options options)
    : recording_(std::move(recording)),
      directory_(std::move(directory)),
      from_(std::move(from)),
      options_(std::move(options)) {}

std::optional<texts::UserMessage> Restoring::Unmet(Need need) const {
  const bool is_bound = need == Need::kOtherWorld || need == Need::kNewRecording;
  if (!is_bound) return std::nullopt;
  return Say("session.isRestoring");
}

// Runs in a worker thread. The eye of the options belongs to another thread (OpenGL contexts are
// bound to threads): it is installed last, and pictures of the path there are rendered with a
// second eye of the same specification.
void Restoring::Make(const recording::Progress& progress) {
  const recording::Recording recording = recording::OpenRecording(directory_);
  recorder::RecordingController::Options options = options_;
  std::optional<picture::RenderedEye> eye;
  if (options_.eye != nullptr) options.eye = &eye.emplace(options_.eye->spec());
  auto world = std::make_unique<LiveWorld>(recording.start_scene(), recording.robot(), options);
  // Both run the log up to a moment, which may take as long as the recording.
  if (const auto* kept = std::get_if<editing::KeptTracks>(&from_)) {
    world->RecordOver(recording, *kept, progress);
  } else if (const auto* begin = std::get_if<CorrectionBegin>(&from_)) {
    world->Correct(recording, begin->seconds, progress);
  } else {
    const auto& [step, after] = std::get<BranchPoint>(from_);
    const auto history = recording::HistoryOf(recording);
    world->Continue(recording, recording::HistoryPointOf(recording, history, step, after),
                    progress);
  }
  recording_ = world->recording_directory().filename().string();
  if (CapturingEye* capturing = world->eye()) capturing->SetEye(options_.eye);
  world_ = std::move(world);
}

}  // namespace smile::studio
