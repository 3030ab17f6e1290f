#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "recording/recording.h"
#include "recording/trace.h"
#include "sim/action_marks.h"
#include "sim/simulation.h"

namespace smile::task {

/// Poses of objects in the world, by id.
using ObjectPoses = std::map<std::string, RigidTransform>;

/// A hand or a gripper had to do with an object, or it fell.
struct Touch {
  sim::Event event;
  std::uint64_t tick = 0;
  RigidTransform X_WB;  ///< of the event's object then
};

/// What somebody did in a scene, hands or a robot: how it was before and after, and what was
/// touched in between.
struct Course {
  scene::SceneSpec scene;
  recording::TraceTick begin, end;
  std::vector<Touch> touches;  ///< in order
};

/// @throws InputError if the recording's trace cannot be read.
Course CourseOf(const recording::Recording& recording);

/// Follows a simulation from now on, as long as both live.
class CourseWitness : public sim::Listener {
 public:
  explicit CourseWitness(sim::Simulation* simulation);
  CourseWitness(const CourseWitness&) = delete;
  CourseWitness& operator=(const CourseWitness&) = delete;
  ~CourseWitness() override;

  void OnEvent(const sim::Simulation& simulation, const sim::Event& event) override;
  void OnMove(const sim::Simulation& simulation, sim::ActionId from, sim::ActionId to) override;

  /// Up to now.
  Course course() const;

 private:
  struct NumberedTouch {
    Touch touch;
    std::size_t num_events = 0;  ///< of the action up to and with this one
  };

  sim::Simulation* simulation_;
  recording::TraceTick begin_;
  sim::ActionMarks<std::vector<NumberedTouch>> touches_;
};

/// The objects that are there, with their poses of that moment.
std::vector<scene::ObjectSpec> ObjectsAt(const scene::SceneSpec& scene,
                                         const recording::TraceTick& moment);

/// Of all objects; those that are not there are where they began.
ObjectPoses PosesAt(const scene::SceneSpec& scene, const recording::TraceTick& moment);
/// Where the objects of a scene begin.
ObjectPoses StartOf(const scene::SceneSpec& scene);

/// The objects that hands took, fastened or loosened.
std::vector<std::string> TouchedByHands(const Course& course);

/// The objects that fell from the table, in this order; not those that lay on the floor before.
std::vector<std::string> FallenObjects(const Course& course);

/// The objects that a hand or a gripper still holds in the end, by id.
std::set<std::string> HeldInTheEnd(const Course& course);

/// How much work a robot's grippers had.
struct Work {
  int grasps = 0;   ///< that got hold of something
  int retries = 0;  ///< of what had been held before and was let go of

  bool operator==(const Work&) const = default;
};
Work WorkOf(const Course& course);

/// The objects that hands or grippers moved, in the order in which they were put where they finally
/// stayed: by the last release, or turn of a fastening, after which they were elsewhere than before
/// it. Not those that are still held.
std::vector<std::string> PlacementsOf(const Course& course);

}  // namespace smile::task
