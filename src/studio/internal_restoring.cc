#include "studio/internal_restoring.h"

#include <utility>

#include "picture/rendered_eye.h"
#include "recording/recording_history.h"

namespace smile::studio {

Restoring::Restoring(std::string recording, std::filesystem::path directory,
                     const BranchPoint& from, recorder::RecordingDesk::Options desk)
    : recording_(std::move(recording)),
      directory_(std::move(directory)),
      from_(from),
      desk_(std::move(desk)) {}

std::optional<std::string> Restoring::Unmet(Need need) const {
  const bool is_bound = need == Need::kOtherWorld || need == Need::kNewRecording;
  if (!is_bound) return std::nullopt;
  return "the world goes back to a moment of a recording: wait until it is there";
}

// The desk's eye belongs to another thread: it is put in only at last, and pictures on the way
// there are taken with one like it.
void Restoring::Make(const recording::Progress& progress) {
  const recording::Recording recording = recording::OpenRecording(directory_);
  const recording::Moment moment =
      recording::MomentOf(recording, recording::HistoryOf(recording), from_.step, from_.after);
  recorder::RecordingDesk::Options options = desk_;
  std::optional<picture::RenderedEye> eye;
  if (desk_.eye != nullptr) options.eye = &eye.emplace(desk_.eye->spec());
  auto world = std::make_unique<LiveWorld>(recording.start_scene(), recording.robot(), options);
  world->Continue(recording, moment, progress);
  if (CapturingEye* capturing = world->eye()) capturing->SetEye(desk_.eye);
  world_ = std::move(world);
}

}  // namespace smile::studio
