#pragma once

#include <string>

namespace smile::scene_xml {

// The one place where lengths of scene files become metres, and metres lengths of scene files.
//
// A recording keeps its scene as a file and replays from it, so metres must survive the way out
// and back in to the last bit. With `double` on both sides they cannot: times 0.1, the doubles of
// [1, 1.25) units fall on [0.1, 0.125) m, where doubles lie denser, and miss some. Units are
// therefore read as `long double`, whose 11 further bits reach every double of metres, and written
// with as many digits as that takes: 15 for nearly all, never more than 21.

/// @param units            a length in the file.
/// @param meters_per_unit  of the file [m]; positive.
double MetersFromUnits(long double units, double meters_per_unit);

/// The shortest of some exact texts: ParseNumber<long double>() and MetersFromUnits() make exactly
/// `meters` of it.
std::string UnitsText(double meters, double meters_per_unit);

}  // namespace smile::scene_xml
