#pragma once

#include <array>
#include <string>
#include <string_view>

#include "sim/event.h"

namespace smile::classic {

/// A number as the classic text logs write it: the shortest text that reads back to the same
/// single-precision value, always with a decimal point, with `E` below 1e-3 and from 1e7 on
/// (`2.0`, `-0.0`, `3.4144908E-4`, `1.0E7`).
std::string ClassicNumber(double number);

/// A description value with its commas escaped as `\,`.
std::string ClassicValue(std::string_view text);

/// `LeftHand`, `RightHand`, `BothHands`, `AnyHand`.
std::string_view ClassicHandName(demonstrator::HandName hand);

/// What hands do, as the lines call it.
struct ClassicWord {
  std::string_view word;
  sim::EventKind kind;
};
inline constexpr std::array<ClassicWord, 8> kClassicWords{{{"grasp", sim::EventKind::kGrasped},
                                                           {"release", sim::EventKind::kReleased},
                                                           {"destroy", sim::EventKind::kDestroyed},
                                                           {"trigger", sim::EventKind::kTriggered},
                                                           {"pointTo", sim::EventKind::kPointed},
                                                           {"fasten", sim::EventKind::kFastened},
                                                           {"loosen", sim::EventKind::kLoosened},
                                                           {"attend", sim::EventKind::kAttended}}};
/// The word for what an event reports; empty if there is none.
std::string_view ClassicWordFor(sim::EventKind kind);

}  // namespace smile::classic
