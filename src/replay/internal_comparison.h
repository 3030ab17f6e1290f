#pragma once

#include <optional>
#include <vector>

#include "recording/trace.h"
#include "replay/replay.h"

namespace smile::replay {

/// One moment, as it was recorded and as it is replayed.
class Comparison {
 public:
  /// @param model  of the recording's scene and robot, for names and units. All must
  ///               outlive this.
  Comparison(const recording::TraceTick& recorded, const recording::TraceTick& replayed,
             const model::Model& model)
      : recorded_(recorded), replayed_(replayed), model_(model) {}

  /// What differs first: an object, what is shown, a joint, else something that cannot be seen
  /// (yet).
  std::optional<Difference> First() const;
  /// Everything besides poses and joints that differs: what is there, states, bonds.
  std::vector<Difference> States() const;

  /// How far apart an object is; nullopt if one of the two has none.
  std::optional<recording::PoseGap> GapOf(model::ObjectIndex object) const;
  recording::PoseGap GapOfJoint(model::LinkIndex link) const;

 private:
  std::optional<Difference> Presence(model::ObjectIndex object) const;
  std::optional<Difference> Pose(model::ObjectIndex object) const;
  std::optional<Difference> Control(model::ControlIndex control) const;
  std::optional<Difference> Bond(model::HostIndex host) const;
  std::optional<Difference> Joint(model::LinkIndex link) const;
  std::optional<Difference> RobotShown() const;
  std::optional<Difference> Mood() const;

  const recording::TraceTick& recorded_;
  const recording::TraceTick& replayed_;
  const model::Model& model_;
};

/// True unless only the state hash tells.
bool IsVisible(const Difference& difference);

/// Keeps how far what moves departs from a recording, moment by moment.
class DepartureMeter {
 public:
  /// @param model  as Comparison's.
  explicit DepartureMeter(const model::Model& model);

  void Watch(const recording::TraceTick& recorded, const recording::TraceTick& replayed);
  /// Of what ever departed, largest first.
  std::vector<Departure> Departures() const;

 private:
  void Note(std::size_t index, std::uint64_t tick, const std::optional<recording::PoseGap>& gap);

  const model::Model& model_;
  std::vector<Departure> all_;  ///< objects, then joints
};

}  // namespace smile::replay
