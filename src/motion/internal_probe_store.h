#pragma once

#include <cstddef>
#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>

#include "motion/articulation_probe.h"
#include "motion/held_box.h"

namespace smile::motion {

/// Probes of one robot, kept for the next question: to make one takes longer than to test a pose.
/// For any number of threads: a thread has the probe that it took to itself until it gives it back.
class ProbeStore {
 public:
  /// What the robot is tested with.
  struct Setting {
    std::optional<std::pair<double, double>> table;  ///< width and depth [units]
    std::optional<HeldBox> held;
    std::size_t arm = 0;  ///< that holds it, if anything is held

    bool operator==(const Setting&) const = default;
  };

  /// Returns a probe for a setting; null if none is kept.
  std::unique_ptr<ArticulationProbe> Take(const Setting& setting);
  /// Keeps a probe, and forgets the one that was not used for longest if there are many.
  void GiveBack(const Setting& setting, std::unique_ptr<ArticulationProbe> probe);

 private:
  std::mutex mutex_;
  std::list<std::pair<Setting, std::unique_ptr<ArticulationProbe>>> kept_;  ///< last used first
};

}  // namespace smile::motion
