#pragma once

#include <array>

#include "math/color.h"

namespace smile::interchange {

/// Illuminance of the usual light [lux]: with it, renderers show colors about as SMILE does.
inline constexpr double kIlluminance = 3;

/// Returns red, green and blue in proportion to light, as materials of renderers have them.
/// Source: the transfer function of IEC 61966-2-1 (sRGB).
std::array<double, 3> LinearOf(const Color& color);

}  // namespace smile::interchange
