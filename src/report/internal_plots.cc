#include "report/internal_plots.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "report/wording.h"

// Diagrams as SVG, without a library: the page must be one file that runs no scripts. Colors and
// fonts come from the page's style sheet by class names, so that light and dark themes work.

namespace smile::report {
namespace {

/// Margin at the left and right of drawings, in the units of kPlotWidth.
constexpr double kMargin = 6;
/// Number of colors of series; more series use the colors again.
constexpr std::size_t kSeries = 6;

/// Returns 1, 2 or 5 times a power of ten, for about `wanted` steps in `range`.
double RoundStep(double range, double wanted) {
  const double rough = range / wanted;
  const double power = std::pow(10, std::floor(std::log10(rough)));
  for (double factor : {1.0, 2.0, 5.0}) {
    // The tolerance is for rounding: a range of exactly five steps must not get four.
    if (factor * power >= rough * (1 - 1e-9)) return factor * power;
  }
  return 10 * power;
}

/// Returns the digits after the point that the numbers of an axis need.
int DigitsOf(double step) {
  return std::clamp(static_cast<int>(-std::floor(std::log10(step) + 1e-9)), 0, 6);
}

/// Returns positions for dots so that none covers another: (x, number of dots below it).
std::vector<std::pair<double, int>> Stacked(const std::vector<double>& numbers, const Axis& axis,
                                            double width) {
  // Columns as wide as a dot; dots of a column are stacked in the order of the numbers.
  std::map<long, int> heights;
  std::vector<std::pair<double, int>> dots;
  for (double number : numbers) {
    const long column = std::lround(axis.x(number) / width);
    dots.emplace_back(static_cast<double>(column) * width, heights[column]++);
  }
  return dots;
}

/// Returns a histogram of dots above `base`; high columns are compressed into `height`.
Markup Dots(const DotRow& row, const Axis& axis, double base, double height, std::size_t series) {
  constexpr double kRadius = 2.6;
  const auto dots = Stacked(row.numbers, axis, 2 * kRadius);
  int highest = 1;
  for (const auto& [x, below] : dots) highest = std::max(highest, below + 1);
  // Dots overlap in columns that would be higher than the row.
  const double pitch = std::min(2 * kRadius, (height - 2 * kRadius) / highest);
  Markup drawing;
  const std::string css_class = "dot " + SeriesClass(series);
  for (const auto& [x, below] : dots) {
    drawing += Element("circle",
                       {{"class", css_class},
                        {"cx", At(x)},
                        {"cy", At(base - kRadius - pitch * below)},
                        {"r", At(kRadius)}},
                       Markup());
  }
  return drawing;
}

/// Returns |–|, with a halo that makes it visible on any background.
Markup IntervalMark(double low, double high, double y) {
  Markup drawing;
  // The halo is drawn first, below the mark.
  for (const char* css_class : {"halo", "whisker"}) {
    drawing += SvgLine(low, y, high, y, css_class);
    for (double end : {low, high}) drawing += SvgLine(end, y - 3.5, end, y + 3.5, css_class);
  }
  return drawing;
}

/// Returns |–o–|, below the dots.
Markup MeanMark(const Mean& mean, const Axis& axis, double y, std::size_t series) {
  Markup drawing;
  if (mean.interval) {
    drawing += IntervalMark(axis.x(mean.interval->low), axis.x(mean.interval->high), y);
  }
  drawing += Element("circle",
                     {{"class", "fill " + SeriesClass(series)},
                      {"cx", At(axis.x(mean.value))},
                      {"cy", At(y)},
                      {"r", "3.4"}},
                     Markup());
  return drawing;
}

/// Returns at most this many bytes of a name, and an ellipsis if it was cut.
std::string Shortened(const std::string& name, std::size_t letters) {
  if (name.size() <= letters) return name;
  std::size_t end = letters;
  // Moves the cut back over UTF-8 continuation bytes.
  while (end > 0 && (static_cast<unsigned char>(name[end]) & 0xC0) == 0x80) --end;
  return name.substr(0, end) + "…";
}

constexpr std::size_t kNameLetters = 34;

}  // namespace

std::string At(double number) { return Fixed(number, 2); }

std::string SeriesClass(std::size_t k) { return "s" + std::to_string(k % kSeries); }

Markup Drawing(double width, double height, const std::string& words, const Markup& content) {
  return Element(
      "svg",
      {{"viewBox", "0 0 " + At(width) + " " + At(height)}, {"role", "img"}, {"aria-label", words}},
      content);
}

Markup SvgText(double x, double y, std::string_view css_class, std::string_view text) {
  return Element("text", {{"class", css_class}, {"x", At(x)}, {"y", At(y)}}, text);
}

Markup SvgLine(double x1, double y1, double x2, double y2, std::string_view css_class) {
  return Element(
      "line",
      {{"class", css_class}, {"x1", At(x1)}, {"y1", At(y1)}, {"x2", At(x2)}, {"y2", At(y2)}},
      Markup());
}

Markup SvgRect(double x, double y, double width, double height, std::string_view css_class) {
  return Element("rect",
                 {{"class", css_class},
                  {"x", At(x)},
                  {"y", At(y)},
                  {"width", At(width)},
                  {"height", At(height)},
                  {"rx", "2"}},
                 Markup());
}

// An axis of one value would have no scale; it gets a range of 1.
Axis::Axis(double low, double high, double left, double right)
    : low_(low), high_(high > low ? high : low + 1), left_(left), right_(right) {
  // The end is rounded up to a whole number of steps.
  step_ = RoundStep(high_ - low_, 5);
  high_ = low_ + std::ceil((high_ - low_) / step_ - 1e-9) * step_;
}

Markup Axis::Draw(double top, double y, std::string_view name) const {
  Markup drawing;
  const long count = std::lround((high_ - low_) / step_);
  for (long k = 0; k <= count; ++k) {
    const double value = low_ + static_cast<double>(k) * step_;
    drawing += SvgLine(x(value), top, x(value), y, "rule");
    // The first and the last number are aligned so that they do not extend beyond the drawing.
    const char* anchor = k == 0 ? "" : k == count ? "end" : "middle";
    drawing += SvgText(x(value), y + 13, anchor, Fixed(value, DigitsOf(step_)));
  }
  drawing += SvgLine(left_, y, right_, y, "axis");
  drawing += SvgText((left_ + right_) / 2, y + 27, "middle", name);
  return drawing;
}

Markup RateBars(const std::vector<RateRow>& rows, const std::string& words) {
  constexpr double kRow = 42, kBar = 15;
  const double bottom = kRow * static_cast<double>(rows.size()) + 4;
  const Axis axis(0, 100, kMargin, kPlotWidth - kMargin);
  Markup drawing = axis.Draw(0, bottom, "success [%]");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const RateRow& row = rows[i];
    const double top = kRow * static_cast<double>(i), y = top + 20;
    const double rate = 100 * static_cast<double>(row.successes) / static_cast<double>(row.runs);
    drawing += SvgText(kMargin, top + 14, "name", Shortened(row.name, kNameLetters));
    drawing += SvgText(kPlotWidth - kMargin, top + 14, "value end",
                       std::to_string(row.successes) + " of " + std::to_string(row.runs));
    drawing += SvgRect(axis.x(0), y, axis.x(100) - axis.x(0), kBar, "track");
    drawing += SvgRect(axis.x(0), y, axis.x(rate) - axis.x(0), kBar, "fill " + SeriesClass(i));
    drawing +=
        IntervalMark(axis.x(100 * row.interval.low), axis.x(100 * row.interval.high), y + kBar / 2);
  }
  return Drawing(kPlotWidth, bottom + 32, words, drawing);
}

Markup DotPlot(const std::vector<DotRow>& rows, const std::string& axis_name,
               const std::string& words) {
  constexpr double kRow = 74, kDots = 40;
  double most = 0;
  for (const DotRow& row : rows) {
    for (double number : row.numbers) most = std::max(most, number);
    // Intervals can extend beyond all dots.
    if (row.mean && row.mean->interval) most = std::max(most, row.mean->interval->high);
  }
  const double bottom = kRow * static_cast<double>(rows.size()) + 2;
  const Axis axis(0, most, kMargin + 3, kPlotWidth - kMargin - 3);
  Markup drawing = axis.Draw(0, bottom, axis_name);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double top = kRow * static_cast<double>(i);
    drawing += SvgText(kMargin, top + 13, "name", Shortened(rows[i].name, kNameLetters));
    drawing += Dots(rows[i], axis, top + 18 + kDots, kDots, i);
    if (rows[i].mean) drawing += MeanMark(*rows[i].mean, axis, top + 18 + kDots + 7, i);
  }
  return Drawing(kPlotWidth, bottom + 32, words, drawing);
}

Markup SuccessMap(const std::vector<MapRow>& rows, const std::string& words) {
  constexpr double kCell = 13.9, kPitch = kCell + 1.1;
  const auto columns = static_cast<std::size_t>((kPlotWidth - 2 * kMargin + 1.1) / kPitch);
  double y = 0;
  Markup drawing;
  for (const MapRow& row : rows) {
    drawing += SvgText(kMargin, y + 13, "name", Shortened(row.name, kNameLetters));
    y += 20;
    for (std::size_t k = 0; k < row.cells.size(); ++k) {
      // Long rows continue in the next line.
      if (k > 0 && k % columns == 0) y += kPitch;
      const double x = kMargin + kPitch * static_cast<double>(k % columns);
      const MapCell& cell = row.cells[k];
      Markup field = Element("title", {}, cell.words);
      field += SvgRect(x, y, kCell, kCell, cell.is_good ? "yes" : "no");
      // A cross in addition to the color, for people who do not distinguish red and green.
      if (!cell.is_good) {
        field += SvgLine(x + 4, y + 4, x + kCell - 4, y + kCell - 4, "cross");
        field += SvgLine(x + 4, y + kCell - 4, x + kCell - 4, y + 4, "cross");
      }
      drawing += Element("g", {}, field);
    }
    y += kPitch + 10;
  }
  return Drawing(kPlotWidth, y, words, drawing);
}

}  // namespace smile::report
