#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "picture/hand_track.h"
#include "recording/demo_info.h"
#include "recording/recording.h"
#include "scene/visual_model.h"

namespace smile::picture {

using recording::DemonstratorAppearance;

/// Visible demonstrator of a recording: additions to the visual model of its scene and robot.
/// Nothing else changes, so that pictures of a tick with and without it differ only where hands and
/// arms are.
class SeenDemonstrator {
 public:
  /// @param appearance  not kInvisible.
  /// Throws as HandTrack does.
  SeenDemonstrator(const recording::Recording& recording, DemonstratorAppearance appearance);

  /// Returns the recording's visual model with the hands at the end: one frame for each of their
  /// pieces.
  const scene::VisualModel& model() const { return visual_model_; }
  /// Adds the hands to a state of the model.
  void AddTo(scene::VisualState* state, std::uint64_t tick) const;

  DemonstratorAppearance appearance() const { return appearance_; }
  const HandTrack& track() const { return track_; }
  /// Id of each hand in pictures of ids.
  std::uint32_t object_id(HandSide side) const {
    return object_ids_[static_cast<std::size_t>(side)];
  }

 private:
  /// Number of pieces of each hand; ghosts have no arms.
  std::size_t num_pieces() const {
    return appearance_ == DemonstratorAppearance::kGhost ? kHandPieces : kArmPieces;
  }
  void AddHand(HandSide side);

  DemonstratorAppearance appearance_;
  double table_edge_;
  HandTrack track_;
  scene::VisualModel visual_model_;
  std::array<std::uint32_t, kHandSides.size()> object_ids_{};
};

/// Returns the visible demonstrator; nullptr for an invisible one. Throws as SeenDemonstrator does.
std::unique_ptr<const SeenDemonstrator> DemonstratorOf(const recording::Recording& recording,
                                                       DemonstratorAppearance appearance);

}  // namespace smile::picture
