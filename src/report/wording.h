#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "report/statistics.h"

namespace smile::report {

// Numbers as tables and pages say them. A dash stands where there is none.

inline constexpr const char* kNone = "–";

/// `3.14` with two digits after the point; never `-0.00`.
std::string Fixed(double number, int digits);
std::string Fixed(const std::optional<double>& number, int digits);
/// With `+` or `−` in front.
std::string Signed(double number, int digits);
std::string Count(const std::optional<std::uint64_t>& count);
/// `90.0 %`.
std::string Percent(double share);
/// `69.9 to 97.2 %`.
std::string PercentRange(const Interval& shares);
/// `3.2 (2.9 to 3.5)`; of differences with signs.
std::string WithInterval(const std::optional<Mean>& mean, int digits);
std::string DifferenceWithInterval(const std::optional<Mean>& mean, int digits);
/// `p = 0.021`, `p < 0.001`.
std::string PValue(double p);
/// `1 run`, `3 runs`.
std::string Plural(std::size_t count, std::string_view noun);

}  // namespace smile::report
