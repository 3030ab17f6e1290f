#pragma once

#include <array>
#include <string_view>

namespace smile::page {

/// Names of snap targets, see studio/snapping.h.
inline constexpr std::array<std::string_view, 5> kSnapNames = {"rails", "faces", "edges", "grid",
                                                               "angles"};

}  // namespace smile::page
