#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "recorder/recording_controller.h"
#include "recording/progress.h"
#include "studio/internal_session_state.h"
#include "studio/live_world.h"

namespace smile::studio {

/// Point of a recording's history, by its step.
struct BranchPoint {
  std::size_t step = 0;
  std::optional<double> after;  ///< time since the step's begin [s]; nullopt for its end
};

/// Moment from which a user corrects what a recording shows.
struct CorrectionBegin {
  double seconds = 0;  ///< from the start of the demonstration
};

/// Activity that continues a recording from a point of its history, records over it or corrects it:
/// the world for it is made in another thread. Until then the live world and playback continue, but
/// nothing else is recorded or loaded.
class Restoring : public Activity {
 public:
  using From = std::variant<BranchPoint, editing::KeptTracks, CorrectionBegin>;

  /// @param directory  of the recording with this id.
  Restoring(std::string recording, std::filesystem::path directory, From from,
            recorder::RecordingController::Options options);

  /// Returns the id of the recording; after Make(), of the one that is recorded.
  const std::string& recording() const { return recording_; }
  std::optional<texts::UserMessage> Unmet(Need need) const override;

  /// Makes the world, in any thread, once.
  /// @throws InputError or std::invalid_argument if the recording cannot be read or has no such
  ///         point.
  void Make(const recording::Progress& progress);
  /// Returns the world after Make() has returned or thrown; nullptr if it threw.
  std::unique_ptr<LiveWorld> TakeWorld() { return std::move(world_); }

 private:
  std::string recording_;
  std::filesystem::path directory_;
  From from_;
  recorder::RecordingController::Options options_;
  std::unique_ptr<LiveWorld> world_;
};

}  // namespace smile::studio
