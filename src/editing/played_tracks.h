#pragma once

#include <cstdint>
#include <set>
#include <vector>

#include "base/json.h"
#include "editing/track_conflicts.h"
#include "recording/demonstration.h"
#include "sim/per_action.h"
#include "sim/simulation.h"

namespace smile::editing {

/// Hands of a demonstration that a user keeps while recording over it.
struct KeptTracks {
  std::set<sim::HandName> hands;
  double seconds = 0;  ///< from the start of the demonstration; before it, all hands are kept
};

/// Tracks of a demonstration that act again while a user records over them, as musicians play along
/// with a tape: the commands of some hands, and all that no hand gave. They act physically, so one
/// may be refused now.
class PlayedTracks {
 public:
  PlayedTracks(const recording::Demonstration& demonstration, const KeptTracks& kept);

  /// Returns the tick at which the user begins.
  std::uint64_t begin() const { return begin_; }

  /// Applies the commands that are due; to be called before each tick.
  void ApplyDue(sim::Simulation* simulation);
  /// Finds the next commands after an undo or redo.
  void Follow(const sim::Simulation& simulation);

  /// Returns true for an action of these tracks, false for one of the user.
  bool HasPlayed(sim::ActionId action) const { return played_.contains(action); }
  /// Returns what the tracks did not find as it was recorded, by time.
  std::vector<recording::Conflict> conflicts() const { return conflicts_.conflicts(); }
  /// `over` of a state message, see docs/studio-protocol.md.
  Json Describe() const;

 private:
  struct TrackCommand {
    recording::LoggedCommand logged;
    bool is_kept = false;  ///< also after the user has begun
  };

  /// Returns true if the next command is to be applied.
  bool MustApplyNext() const;
  void ApplyNext(sim::Simulation* simulation);

  std::set<sim::HandName> hands_;
  std::uint64_t begin_;
  std::vector<TrackCommand> commands_;
  std::size_t next_ = 0;
  std::size_t num_seen_ = 0;             ///< greatest `next_` so far
  sim::PerAction<std::size_t> next_of_;  ///< `next_` at the end of actions
  std::set<sim::ActionId> played_;
  TrackConflicts conflicts_;
};

}  // namespace smile::editing
