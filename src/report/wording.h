#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "report/statistics.h"

namespace smile::report {

// Numbers as text for tables and pages. A dash stands for a missing number.

inline constexpr const char* kNone = "–";

/// Returns `3.14` for two digits after the point; never `-0.00`.
std::string Fixed(double number, int digits);
std::string Fixed(const std::optional<double>& number, int digits);
/// Returns a number with `+` or `−` in front.
std::string Signed(double number, int digits);
std::string Count(const std::optional<std::uint64_t>& count);
/// Returns `90.0 %`.
std::string Percent(double fraction);
/// Returns `69.9 to 97.2 %`.
std::string PercentRange(const Interval& fractions);
/// Returns `3.2 (2.9 to 3.5)`; differences have signs.
std::string WithInterval(const std::optional<Mean>& mean, int digits);
std::string DifferenceWithInterval(const std::optional<Mean>& mean, int digits);
/// Returns `p = 0.021`, or `p < 0.001`.
std::string PValue(double p);
/// Returns `1 run`, `3 runs`.
std::string Plural(std::size_t count, std::string_view noun);

}  // namespace smile::report
