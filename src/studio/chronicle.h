#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/json.h"
#include "record/deed.h"
#include "sim/simulation.h"

namespace smile::studio {

/// What hands have done in a simulation, as it stands: an undo takes the last away.
class Chronicle : public sim::Listener {
 public:
  struct Action {
    std::uint64_t tick = 0;  ///< at which it was done
    std::optional<record::Deed> deed;
  };

  std::size_t size() const { return actions_.size(); }
  /// Segments of a recording, see docs/studio-protocol.md: what followed the first `num_before`
  /// actions, the first segment from its start on.
  Json SegmentsSince(std::size_t num_before, std::uint64_t start_tick,
                     std::uint64_t now_tick) const;

  void OnCommand(const sim::Simulation& simulation, const sim::Command& command) override;
  void OnEvent(const sim::Simulation& simulation, const sim::Event& event) override;
  void OnUndo(const sim::Simulation& simulation) override;
  void OnRedo(const sim::Simulation& simulation) override;

 private:
  std::vector<Action> actions_, undone_;
};

}  // namespace smile::studio
