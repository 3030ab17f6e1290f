#pragma once

#include <optional>
#include <vector>

#include "recording/trace.h"
#include "replay/replay.h"

namespace smile::replay {

/// Comparison of a tick as recorded and as replayed.
class TickComparison {
 public:
  /// @param model  of the recording's scene and robot, for names and units. All must
  ///               outlive this.
  TickComparison(const recording::TraceTick& recorded, const recording::TraceTick& replayed,
                 const model::Model& model)
      : recorded_(recorded), replayed_(replayed), model_(model) {}

  /// Returns the first difference: of an object, of the visual state, of a joint, else of something
  /// that is not visible (yet).
  std::optional<Difference> First() const;
  /// Returns all differences besides poses and joints: presence, states, bonds.
  std::vector<Difference> States() const;

  /// Returns the distance between the two poses of an object; nullopt if one of the two lacks it.
  std::optional<recording::PoseGap> GapOf(model::ObjectIndex object) const;
  recording::PoseGap GapOfJoint(model::LinkIndex link) const;

 private:
  std::optional<Difference> Presence(model::ObjectIndex object) const;
  std::optional<Difference> Pose(model::ObjectIndex object) const;
  std::optional<Difference> Control(model::ControlIndex control) const;
  std::optional<Difference> Bond(model::HostIndex host) const;
  std::optional<Difference> Joint(model::LinkIndex link) const;
  std::optional<Difference> RobotShown() const;
  std::optional<Difference> FaceExpression() const;

  const recording::TraceTick& recorded_;
  const recording::TraceTick& replayed_;
  const model::Model& model_;
};

/// Returns false if only the state hash differs.
bool IsVisible(const Difference& difference);

/// Measures how far objects and joints deviate from a recording, tick by tick.
class DeviationMeter {
 public:
  /// Makes a meter.
  /// @param model  as for TickComparison.
  explicit DeviationMeter(const model::Model& model);

  void Compare(const recording::TraceTick& recorded, const recording::TraceTick& replayed);
  /// Returns the deviations of all that ever deviated, the largest first.
  std::vector<Deviation> Deviations() const;

 private:
  void Note(std::size_t index, std::uint64_t tick, const std::optional<recording::PoseGap>& gap);

  const model::Model& model_;
  std::vector<Deviation> all_;  ///< objects, then joints
};

}  // namespace smile::replay
