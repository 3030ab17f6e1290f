#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "recording/recording.h"
#include "recording/trace.h"
#include "sim/per_action.h"
#include "sim/simulation.h"

namespace smile::task {

/// Poses of objects in the world, by id.
using ObjectPoses = std::map<std::string, RigidTransform>;

/// Contact of a hand or gripper with an object, or the fall of an object.
struct ContactEvent {
  sim::Event event;
  std::uint64_t tick = 0;
  RigidTransform X_WB;  ///< of the event's object at that tick
  /// For a grasp: ids of the objects on which the event's object stands or in which it lies.
  std::vector<std::string> supports = {};
};

/// Episode of a demonstration or an imitation: the states of the scene at its begin and end, and
/// the contacts of hands and grippers in between.
struct Episode {
  scene::SceneSpec scene;
  recording::TraceTick begin, end;
  std::vector<ContactEvent> contacts;  ///< in order
};

/// Reads the episode of a recording.
/// @throws InputError if the recording's trace cannot be read.
Episode EpisodeOf(const recording::Recording& recording);

/// Observes the episode of a simulation from construction on; the simulation must outlive it.
class EpisodeObserver : public sim::Listener {
 public:
  explicit EpisodeObserver(sim::Simulation* simulation);
  EpisodeObserver(const EpisodeObserver&) = delete;
  EpisodeObserver& operator=(const EpisodeObserver&) = delete;
  ~EpisodeObserver() override;

  void OnEvent(const sim::Simulation& simulation, const sim::Event& event) override;
  void OnMove(const sim::Simulation& simulation, sim::ActionId from, sim::ActionId to) override;

  /// Returns the episode up to now.
  Episode episode() const;

  /// Continues the episode from a state that the simulation has just restored.
  /// @param contacts  of the episode up to that state.
  void Continue(std::vector<ContactEvent> contacts);

 private:
  struct NumberedContact {
    ContactEvent contact;
    std::size_t num_events = 0;  ///< of the action up to and with this one
  };

  sim::Simulation* simulation_;
  recording::TraceTick begin_;
  sim::PerAction<std::vector<NumberedContact>> contacts_;
};

/// Returns an episode that ends where this one begins.
Episode AtBegin(const Episode& episode);

/// Returns true if two poses differ by more than 10 mm or 5 degrees: an object released nearer to
/// where it was grasped has not been placed.
bool HasMoved(const RigidTransform& from, const RigidTransform& to);

/// Returns the objects that are present, with their poses of that moment.
std::vector<scene::ObjectSpec> ObjectsAt(const scene::SceneSpec& scene,
                                         const recording::TraceTick& moment);

/// Returns the poses of all objects; absent objects have their initial poses.
ObjectPoses PosesAt(const scene::SceneSpec& scene, const recording::TraceTick& moment);
/// Returns the initial poses of the objects of a scene.
ObjectPoses StartOf(const scene::SceneSpec& scene);

/// Returns the objects that hands grasped, fastened or loosened.
std::vector<std::string> TouchedByHands(const Episode& episode);

/// Returns the objects that fell from the table, in this order; not those that lay on the floor
/// before.
std::vector<std::string> FallenObjects(const Episode& episode);

/// Returns the ids of the objects that a hand or a gripper holds at the end.
std::set<std::string> HeldInTheEnd(const Episode& episode);

/// Numbers of grasps and retries of a robot's grippers.
struct Work {
  int grasps = 0;   ///< successful ones
  int retries = 0;  ///< of objects held before and released since

  bool operator==(const Work&) const = default;
};
Work WorkOf(const Episode& episode);

/// Returns the objects that hands or grippers moved, in the order of their final placement: by the
/// last release, or turn of a fastening, after which they were elsewhere than before it. Objects
/// that are still held are not included.
std::vector<std::string> PlacementsOf(const Episode& episode);

}  // namespace smile::task
