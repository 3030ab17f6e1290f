#include "math/color.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>

namespace smile {
namespace {

struct NamedColor {
  std::string_view name;
  Color color;
};

// The palette of the scene language; brown, orange and pink keep the values that existing scenes
// were made with.
constexpr std::array<NamedColor, 14> kNamedColors{{
    {"black", {0, 0, 0}},
    {"blue", {0, 0, 1}},
    {"brown", {65 / 255.0, 40 / 255.0, 25 / 255.0}},
    {"cyan", {0, 1, 1}},
    {"darkgray", {0.2, 0.2, 0.2}},
    {"gray", {0.5, 0.5, 0.5}},
    {"green", {0, 1, 0}},
    {"lightgray", {0.8, 0.8, 0.8}},
    {"magenta", {1, 0, 1}},
    {"orange", {251 / 255.0, 130 / 255.0, 0}},
    {"pink", {1, 0.68, 0.68}},
    {"red", {1, 0, 0}},
    {"white", {1, 1, 1}},
    {"yellow", {1, 1, 0}},
}};

/// Returns text without surrounding blanks.
std::string_view Trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

}  // namespace

std::optional<Color> ParseColor(std::string_view text) {
  text = Trimmed(text);
  for (const NamedColor& named : kNamedColors) {
    if (named.name == text) return named.color;
  }
  // from_chars() accepts no sign here and must consume all six digits.
  if (text.size() != 7 || text[0] != '#') return std::nullopt;
  unsigned rgb = 0;
  const auto [end, error] = std::from_chars(text.data() + 1, text.data() + 7, rgb, 16);
  if (error != std::errc() || end != text.data() + 7) return std::nullopt;
  return Color{((rgb >> 16) & 255) / 255.0, ((rgb >> 8) & 255) / 255.0, (rgb & 255) / 255.0};
}

std::string ToString(const Color& color) {
  // Exact comparison: colors come from this table or from bytes.
  for (const NamedColor& named : kNamedColors) {
    if (named.color == color) return std::string(named.name);
  }
  char text[8];
  const auto byte = [](double part) {
    return static_cast<unsigned>(std::lround(part * 255)) & 255;
  };
  std::snprintf(text, sizeof text, "#%02x%02x%02x", byte(color.red), byte(color.green),
                byte(color.blue));
  return text;
}

std::vector<std::string_view> ColorNames() {
  std::vector<std::string_view> names;
  for (const NamedColor& named : kNamedColors) names.push_back(named.name);
  return names;
}

}  // namespace smile
