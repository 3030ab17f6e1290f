#pragma once

#include <cstdint>

#include "base/json.h"
#include "record/deed.h"
#include "sim/action_marks.h"
#include "sim/simulation.h"

namespace smile::studio {

/// What the actions of a simulation were.
class Chronicle : public sim::Listener {
 public:
  /// Segments of a recording, see docs/studio-protocol.md: the rest of the action `before`, from
  /// the start of the recording on, and each action since.
  Json SegmentsSince(sim::ActionId before, std::uint64_t start_tick,
                     const sim::Simulation& simulation) const;

  void OnEvent(const sim::Simulation& simulation, const sim::Event& event) override;

 private:
  sim::ActionMarks<record::Deed> deeds_;
};

}  // namespace smile::studio
