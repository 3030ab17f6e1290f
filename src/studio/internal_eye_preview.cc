#include "studio/internal_eye_preview.h"

#include <stdexcept>
#include <utility>

namespace smile::studio {

std::optional<std::string> EyePreview::Update(LiveWorld* world, const SessionState& shown) {
  constexpr std::uint64_t kTicksPerPicture = 15;  // 4 a second, as in classic recordings
  ++num_calls_;
  if (eye_ == nullptr || is_broken_) return std::nullopt;
  // A recorded picture has priority: people see exactly what is recorded, without rendering twice.
  if (auto recorded = world->eye()->Take()) {
    picture_ = Picture{.image = *std::move(recorded), .is_recorded = true};
    seen_ = sim::ViewSampleOf(world->simulation(), eye_->spec());
    return std::nullopt;
  }
  if (num_calls_ % kTicksPerPicture != 0) return std::nullopt;
  sim::ViewSample sample = shown.ViewSampleThrough(eye_->spec());
  // The picture would be the same.
  if (seen_ == sample) return std::nullopt;
  try {
    picture_ = Picture{.image = eye_->Draw(shown.model().visual_model(), sample)};
  } catch (const std::runtime_error& error) {
    // Reported once; trying again at every tick would repeat the error.
    is_broken_ = true;
    return error.what();
  }
  seen_ = std::move(sample);
  return std::nullopt;
}

}  // namespace smile::studio
