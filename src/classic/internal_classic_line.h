#pragma once

#include <string_view>

#include "classic/classic_reader.h"

namespace smile::classic {

/// Parses one line of a classic text. Facts that only other lines contain are left empty: which
/// object is released or destroyed, or has a control.
/// @throws std::invalid_argument saying what was found and expected.
ClassicLine ParseClassicLine(std::string_view text, const ClassicLimits& limits);

/// Parses a number; it must be finite, and the whole text must belong to it.
/// @throws std::invalid_argument saying what was found and expected.
double ParseClassicNumber(std::string_view text, std::string_view what, double limit);

}  // namespace smile::classic
