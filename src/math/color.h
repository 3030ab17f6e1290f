#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace smile {

/// Red, green, blue in [0, 1], as shown on a screen (sRGB).
struct Color {
  double red = 0.5, green = 0.5, blue = 0.5;

  bool operator==(const Color&) const = default;
};

/// Returns the color of a name (one of 14) or `#RRGGBB`; surrounding blanks are allowed.
std::optional<Color> ParseColor(std::string_view text);

/// Returns the color's name if it has one, else `#rrggbb` (rounded to 8 bits).
std::string ToString(const Color& color);

/// Returns the names that ParseColor() accepts, in alphabetical order.
std::vector<std::string_view> ColorNames();

}  // namespace smile
