#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>

#include "scene_xml/internal_expression.h"

// Java's text of a float. C++ has no such function: std::to_chars writes the shortest digits, but
// Java 8 sometimes writes one more, and places point and exponent by other rules. Values of
// templates in old scenes depend on it.

namespace smile::scene_xml {
namespace {

/// Decimal number 0.d1d2d3… * 10^exponent.
struct Decimal {
  std::string digits;
  int exponent;
};

/// Returns a large integer rounded to its significant digits. There can be one more digit than
/// needed to distinguish the float from its neighbors: the original's runtime (Java 8) does the
/// same.
Decimal DigitsOfInteger(float number) {
  constexpr double kDigitsPerBit = 0.30102999566398120;  // log10(2)
  constexpr int kFloatBits = 24;
  const int num_dropped = static_cast<int>((std::ilogb(number) - kFloatBits - 1) * kDigitsPerBit);
  std::int64_t power = 1;
  for (int i = 0; i < num_dropped; ++i) power *= 10;
  // Rounded half up.
  const std::int64_t kept = (static_cast<std::int64_t>(number) + power / 2) / power;
  std::string digits = std::to_string(kept);
  const int exponent = static_cast<int>(digits.size()) + num_dropped;
  digits.erase(digits.find_last_not_of('0') + 1);
  return {digits, exponent};
}

/// Returns the fewest digits that distinguish a float from its neighbors (shortest round-trip
/// form).
Decimal ShortestDigits(float number) {
  char buffer[32];
  const auto result =
      std::to_chars(buffer, buffer + sizeof buffer, number, std::chars_format::scientific);
  const std::string_view text(buffer, result.ptr - buffer);
  const std::size_t mark = text.find('e');
  std::string digits(text.substr(0, mark));
  if (digits.size() > 1) digits.erase(1, 1);  // the point
  const char* exponent_text = buffer + mark + 1 + (text[mark + 1] == '+' ? 1 : 0);
  int exponent = 0;
  std::from_chars(exponent_text, result.ptr, exponent);
  return {digits, exponent + 1};
}

/// Inserts the point, with at least one digit on each side of it.
std::string WithPoint(std::string digits, int exponent) {
  // Leading zeros, up to the point: 0.d1d2 * 10^0 is 0.d1d2.
  if (exponent <= 0) digits.insert(0, 1 - exponent, '0');
  const auto before = static_cast<std::size_t>(std::max(exponent, 1));
  if (digits.size() <= before) digits.append(before + 1 - digits.size(), '0');
  return digits.insert(before, ".");
}

}  // namespace

std::string SinglePrecisionText(float number) {
  // 2^31, beyond which results do not fit Java's int, and about 2^62, up to which its runtime
  // computes digits with 64-bit integers.
  constexpr float kIntegerLimit = 2147483648.0f, kLongLimit = 4.6e18f;
  if (std::isnan(number)) return "NaN";
  const std::string sign = number < 0 ? "-" : "";
  const float size = std::abs(number);
  if (std::isinf(number)) return sign + "Infinity";
  // The original writes results that are almost integers as integers.
  if (size < kIntegerLimit) {
    const double nearest = std::round(static_cast<double>(number));
    if (std::abs(number - nearest) < 1e-6) return std::to_string(static_cast<long long>(nearest));
  }
  const bool is_long = size >= kIntegerLimit && size < kLongLimit;
  const Decimal decimal = is_long ? DigitsOfInteger(size) : ShortestDigits(size);
  // Java's rule for Float.toString(): plain notation from 1e-3 to below 1e7, scientific notation
  // otherwise.
  if (size >= 1e-3f && size < 1e7f) return sign + WithPoint(decimal.digits, decimal.exponent);
  return sign + WithPoint(decimal.digits, 1) + "E" + std::to_string(decimal.exponent - 1);
}

}  // namespace smile::scene_xml
