#pragma once

#include <string>
#include <string_view>

#include "demonstrator/hand.h"

namespace smile::classic {

/// A number as the classic text logs write it: the shortest text that reads back to the same
/// single-precision value, always with a decimal point, with `E` below 1e-3 and from 1e7 on
/// (`2.0`, `-0.0`, `3.4144908E-4`, `1.0E7`).
std::string ClassicNumber(double number);

/// A description value with its commas escaped as `\,`.
std::string ClassicValue(std::string_view text);

/// `LeftHand`, `RightHand`, `BothHands`, `AnyHand`.
std::string_view ClassicHandName(demonstrator::HandName hand);

}  // namespace smile::classic
