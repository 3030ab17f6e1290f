#pragma once

#include <cstdint>
#include <optional>

#include "demonstrator/hand.h"
#include "recording/demonstration.h"

namespace smile::editing {

/// Another demonstration, whose hands act at the same time.
struct Overlay {
  recording::Demonstration demonstration;
  std::uint64_t begin = 0;  ///< [ticks] from the start of the first demonstration to its own
  /// The hand that does all of it, left or right; nullopt: those that did.
  std::optional<demonstrator::HandName> hand;
};

/// Adds the hands of another demonstration to one, as musicians record one voice while they hear
/// another. Its other commands are left out: robot and table are those of the first. Of commands at
/// the same tick, those of the first come first. The result is cut at all actions; it has no
/// pauses.
/// @param num_lines  of the first demonstration's log: the lines of the other one count from there.
/// @throws std::invalid_argument if one hand must do what both hands did, or the other
///         demonstration has no command of a hand.
recording::Demonstration Overlaid(const recording::Demonstration& first, const Overlay& overlay,
                                  std::size_t num_lines);

}  // namespace smile::editing
