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

/// One of the 14 names of the scene language, or `#RRGGBB`; surrounding blanks are allowed.
std::optional<Color> ParseColor(std::string_view text);

/// The name where there is one, else `#rrggbb` (rounded to 8 bits).
std::string ToString(const Color& color);

/// The names ParseColor() knows, in alphabetic order.
std::vector<std::string_view> ColorNames();

}  // namespace smile
