#pragma once

#include <optional>
#include <string>
#include <vector>

#include "report/markup.h"
#include "report/statistics.h"

namespace smile::report {

// Plots as SVG, 360 units wide: as many pixels as a telephone has, so that texts are readable
// there, and larger on larger screens. Colors and fonts are those of internal_style.h.

inline constexpr double kPlotWidth = 360;

/// Returns a number for an SVG attribute.
std::string At(double number);

/// Returns `s0` to `s5`: the color class of the k-th series.
std::string SeriesClass(std::size_t k);

/// Returns a complete drawing.
/// @param words  description for screen readers.
Markup Drawing(double width, double height, const std::string& words, const Markup& content);

Markup SvgText(double x, double y, std::string_view css_class, std::string_view text);
Markup SvgLine(double x1, double y1, double x2, double y2, std::string_view css_class);
Markup SvgRect(double x, double y, double width, double height, std::string_view css_class);

/// Horizontal axis whose ticks are round numbers.
class Axis {
 public:
  /// Makes an axis from `left` to `right`, for values from `low` to at least `high`.
  Axis(double low, double high, double left, double right);

  double x(double value) const {
    return left_ + (value - low_) / (high_ - low_) * (right_ - left_);
  }
  /// Draws ticks with their numbers below `y`, grid lines from `top` to there, and a name below
  /// all.
  Markup Draw(double top, double y, std::string_view name) const;

 private:
  double low_, high_, left_, right_;
  double step_;
};

struct RateRow {
  std::string name;
  std::size_t successes = 0, runs = 1;
  Interval interval;
};
/// Returns rates as bars, each with its interval.
Markup RateBars(const std::vector<RateRow>& rows, const std::string& words);

struct DotRow {
  std::string name;
  std::vector<double> numbers;
  std::optional<Mean> mean;  ///< marked, with its interval
};
/// Returns all numbers as dots; equal ones are stacked.
Markup DotPlot(const std::vector<DotRow>& rows, const std::string& axis, const std::string& words);

struct MapCell {
  bool is_good = false;
  std::string words;  ///< tooltip
};
struct MapRow {
  std::string name;
  std::vector<MapCell> cells;
};
/// Returns successes and failures as cells, one row below the other: each column is one layout.
Markup SuccessMap(const std::vector<MapRow>& rows, const std::string& words);

}  // namespace smile::report
