#pragma once

#include <array>
#include <string_view>

namespace smile::studio {

/// Names of hands in requests; demonstrator::ParseHandName() knows them all.
inline constexpr std::array<std::string_view, 4> kHandWords = {"left", "right", "both", "any"};

}  // namespace smile::studio
