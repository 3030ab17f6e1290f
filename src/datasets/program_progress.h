#pragma once

#include <string>
#include <string_view>

#include "base/json.h"

namespace smile::datasets {

/// Returns `{"done","total"}` of a line such as `filming: 3 of 12`, which begins with `begin` and
/// says that 3 of 12 are done; an empty object for any other line.
Json ProgressIn(std::string_view line, std::string_view begin);

}  // namespace smile::datasets
