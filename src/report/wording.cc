#include "report/wording.h"

#include <cmath>
#include <cstdio>

// Numbers as reports write them, for pages and terminals alike. Missing values are a dash
// everywhere.

namespace smile::report {

std::string Fixed(double number, int digits) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", digits, number);
  const std::string fixed = text;
  // A number that rounds to zero has no sign.
  const bool is_zero = fixed.find_first_of("123456789") == std::string::npos;
  return is_zero && fixed.front() == '-' ? fixed.substr(1) : fixed;
}

std::string Fixed(const std::optional<double>& number, int digits) {
  return number ? Fixed(*number, digits) : kNone;
}

std::string Signed(double number, int digits) {
  // Decided by the rounded number: what is displayed as 0.0 has no direction.
  const std::string size = Fixed(std::abs(number), digits);
  if (size.find_first_of("123456789") == std::string::npos) return "±" + size;
  // The minus sign of typography, which is as wide as a plus.
  return (number < 0 ? "−" : "+") + size;
}

std::string Count(const std::optional<std::uint64_t>& count) {
  return count ? std::to_string(*count) : kNone;
}

std::string Percent(double fraction) { return Fixed(100 * fraction, 1) + " %"; }

std::string PercentRange(const Interval& fractions) {
  // One percent sign for both ends.
  return Fixed(100 * fractions.low, 1) + " to " + Percent(fractions.high);
}

std::string WithInterval(const std::optional<Mean>& mean, int digits) {
  if (!mean) return kNone;
  std::string text = Fixed(mean->value, digits);
  if (mean->interval) {
    text += " (" + Fixed(mean->interval->low, digits) + " to " +
            Fixed(mean->interval->high, digits) + ")";
  }
  return text;
}

std::string DifferenceWithInterval(const std::optional<Mean>& mean, int digits) {
  if (!mean) return kNone;
  std::string text = Signed(mean->value, digits);
  if (mean->interval) {
    text += " (" + Signed(mean->interval->low, digits) + " to " +
            Signed(mean->interval->high, digits) + ")";
  }
  return text;
}

std::string PValue(double p) { return p < 0.001 ? "p < 0.001" : "p = " + Fixed(p, 3); }

std::string Plural(std::size_t count, std::string_view noun) {
  return std::to_string(count) + " " + std::string(noun) + (count == 1 ? "" : "s");
}

}  // namespace smile::report
