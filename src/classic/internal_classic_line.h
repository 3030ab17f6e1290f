#pragma once

#include <string_view>

#include "classic/classic_reader.h"

namespace smile::classic {

/// One line of a classic text, by itself. What only other lines tell is left empty: which object is
/// released or destroyed, or has a control.
/// @throws std::invalid_argument saying what was found and expected.
ClassicLine ParseClassicLine(std::string_view text, const ClassicLimits& limits);

/// The value of a number that is finite and written to its end.
/// @throws std::invalid_argument saying what was found and expected.
double ParseClassicNumber(std::string_view text, std::string_view what, double limit);

}  // namespace smile::classic
