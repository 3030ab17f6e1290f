#include "report/analysis_page.h"

#include <algorithm>
#include <cmath>

#include "report/internal_plots.h"
#include "report/internal_table.h"
#include "report/markup.h"
#include "report/wording.h"
#include "sim/tick.h"

// The page of an analysis. The graph shows subtasks as boxes in columns; whatever a subtask needs
// stands to the left of it. The tables below contain the same, with reasons.

namespace smile::report {
namespace {

// Sizes of the graph, in the units of its viewBox.
constexpr double kBoxWidth = 238, kBoxHeight = 34, kColumnWidth = 274, kRowHeight = 48, kEdge = 6;
/// Letters that fit into a box.
constexpr std::size_t kLetters = 36;

std::string NumberOf(std::size_t subtask) { return std::to_string(subtask + 1); }

/// Returns a text of at most kLetters letters.
std::string Shortened(const std::string& text) {
  if (text.size() <= kLetters) return text;
  std::size_t end = kLetters - 1;
  // A letter of several bytes stays whole.
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
  return text.substr(0, end) + "…";
}

/// Place of the upper left corner of a box.
struct BoxPlace {
  double x = 0, y = 0;
};

/// Returns the columns of all subtasks: right before the first one that needs it, so that few lines
/// pass a box; of subtasks that no other needs, the level.
std::vector<std::size_t> ColumnsOf(const analysis::Analysis& analysis) {
  const std::vector<std::size_t> levels = analysis.Levels();
  std::vector<std::size_t> columns = levels;
  for (std::size_t i = columns.size(); i-- > 0;) {
    std::optional<std::size_t> first;
    for (const analysis::Precedence& one : analysis.precedences) {
      if (one.before != i) continue;
      first = std::min(first.value_or(columns[one.after]), columns[one.after]);
    }
    if (first) columns[i] = *first - 1;
  }
  return columns;
}

/// Returns the places of all subtasks, within a column in the demonstrated order.
std::vector<BoxPlace> PlacesOf(const std::vector<std::size_t>& columns) {
  std::vector<BoxPlace> places;
  std::vector<std::size_t> heights(columns.size() + 1, 0);
  for (const std::size_t column : columns) {
    places.push_back({kEdge + kColumnWidth * static_cast<double>(column),
                      kEdge + kRowHeight * static_cast<double>(heights[column]++)});
  }
  return places;
}

/// Returns a curve from the right side of one box to the left side of another.
Markup EdgeOf(const BoxPlace& from, const BoxPlace& to) {
  const double x0 = from.x + kBoxWidth, y0 = from.y + kBoxHeight / 2;
  const double x1 = to.x, y1 = to.y + kBoxHeight / 2;
  const double middle = (kColumnWidth - kBoxWidth) / 2;
  const std::string path = "M" + At(x0) + " " + At(y0) + " C" + At(x0 + middle) + " " + At(y0) +
                           " " + At(x1 - middle) + " " + At(y1) + " " + At(x1) + " " + At(y1);
  return Element("path", {{"class", "edge"}, {"d", path}});
}

Markup BoxOf(const BoxPlace& place, std::size_t subtask, const analysis::SubtaskFinding& finding) {
  Markup box = Element("title", {}, NumberOf(subtask) + ". " + finding.subtask.words);
  box += Element("rect", {{"class", finding.harm ? "subtask" : "subtask redundant"},
                          {"x", At(place.x)},
                          {"y", At(place.y)},
                          {"width", At(kBoxWidth)},
                          {"height", At(kBoxHeight)},
                          {"rx", "8"}});
  box += Element("text", {{"x", At(place.x + 10)}, {"y", At(place.y + 21)}, {"class", "value"}},
                 NumberOf(subtask) + ". " + Shortened(finding.subtask.words));
  return Element("g", {}, box);
}

Markup SvgOf(const analysis::Analysis& analysis) {
  const std::vector<BoxPlace> places = PlacesOf(ColumnsOf(analysis));
  double width = 0, height = 0;
  for (const BoxPlace& place : places) {
    width = std::max(width, place.x + kBoxWidth + kEdge);
    height = std::max(height, place.y + kBoxHeight + kEdge);
  }
  Markup drawing;
  for (const analysis::Precedence& one : analysis.precedences) {
    drawing += EdgeOf(places[one.before], places[one.after]);
  }
  for (std::size_t i = 0; i < places.size(); ++i) {
    drawing += BoxOf(places[i], i, analysis.subtasks[i]);
  }
  // In its own size, so that letters stay readable; the frame around it scrolls.
  const std::string style = "width:" + At(width) + "px;max-width:none";
  return Element("svg",
                 {{"viewBox", "0 0 " + At(width) + " " + At(height)},
                  {"style", style},
                  {"data-letters", std::to_string(kLetters)},
                  {"role", "img"},
                  {"aria-label", "Graph of the order of subtasks; the text contains the same"}},
                 drawing);
}

Markup GraphSection(const analysis::Analysis& analysis) {
  Markup content = Element("div", {{"class", "scroll"}}, SvgOf(analysis));
  content +=
      Element("p", {{"class", "note"}},
              "A line leads from a subtask to one that must come after it. Subtasks without a "
              "chain of lines between them can be done in any order. Dashed: redundant.");
  return Section("Order of the subtasks", content);
}

std::string ThenText(const std::optional<texts::UserMessage>& harm) {
  return harm ? *harm : "the same is achieved";
}

Markup SubtaskTable(const analysis::Analysis& analysis) {
  const Markup head = Row({NumberHead("Subtask"), Head("What"), NumberHead("Begins, s"),
                           Head("Necessary"), Head("Without it")});
  Markup rows;
  for (std::size_t i = 0; i < analysis.subtasks.size(); ++i) {
    const analysis::SubtaskFinding& finding = analysis.subtasks[i];
    rows += Row({NumberCell(NumberOf(i)), WideCell(finding.subtask.words),
                 NumberCell(Fixed(sim::SecondsOf(finding.subtask.begin), 1)),
                 Cell(finding.harm ? "yes" : "no"), WideCell(ThenText(finding.harm))});
  }
  return Section("Subtasks",
                 Table("The demonstration was simulated without each of them.", head, rows));
}

Markup OrderTable(const analysis::Analysis& analysis) {
  if (analysis.precedences.empty()) {
    return Section("Reasons for the order", Element("p", {}, "All orders achieve the same."));
  }
  const Markup head = Row({NumberHead("Subtask"), NumberHead("after"), Head("Otherwise")});
  Markup rows;
  for (const analysis::Precedence& one : analysis.precedences) {
    rows += Row(
        {NumberCell(NumberOf(one.after)), NumberCell(NumberOf(one.before)), WideCell(one.harm)});
  }
  return Section("Reasons for the order",
                 Table("What follows from other rows is left out.", head, rows));
}

/// Returns `color of RedBlock: yellow instead of red`.
std::string TriedText(const analysis::PropertyFinding& one) {
  if (one.property == analysis::PropertyFinding::Property::kPlace) {
    return "place of everything that is not fixed: " + one.tried;
  }
  return "color of " + one.object + (one.tried.empty() ? ", not tried" : ": " + one.tried);
}

Markup PropertyTable(const analysis::Analysis& analysis) {
  const Markup head = Row({Head("What was changed"), Head("Then")});
  Markup rows;
  for (const analysis::PropertyFinding& one : analysis.properties) {
    rows += Row({WideCell(TriedText(one)), WideCell(ThenText(one.harm))});
  }
  std::string note =
      "The same actions were simulated with each change alone. Colors were not compared then: the "
      "program assumes that a color matters only if the demonstrator said so. Other colors and "
      "places than these were not tried.";
  if (!analysis.why_not_moved.empty()) {
    note += " Other places were not tried, since " + analysis.why_not_moved + ".";
  }
  return Section("Properties", Table(note, head, rows));
}

/// Returns the result in one sentence.
std::string Headline(const analysis::Analysis& analysis) {
  const auto necessary = static_cast<std::size_t>(std::ranges::count_if(
      analysis.subtasks,
      [](const analysis::SubtaskFinding& finding) { return finding.harm.has_value(); }));
  return std::to_string(necessary) + " of " + Plural(analysis.subtasks.size(), "subtask") +
         (necessary == 1 ? " is necessary" : " are necessary");
}

}  // namespace

std::string GraphOf(const analysis::Analysis& analysis) { return SvgOf(analysis).html(); }

std::string PageOf(const analysis::Analysis& analysis, std::string_view name) {
  Markup header = Element("p", {{"class", "eyebrow"}}, "What mattered in " + std::string(name));
  header += Element("h1", {}, Headline(analysis));
  header +=
      Element("p", {{"class", "lead"}},
              "The demonstration was simulated again without each subtask, and with subtasks in "
              "the opposite order, " +
                  std::to_string(analysis.num_simulations) +
                  " times in all. What counts is what it achieved, wherever on the table.");
  if (analysis.sufficient.size() < analysis.subtasks.size()) {
    header += Element("p", {},
                      "The same is achieved with fewer subtasks: " +
                          analysis::NumbersOf(analysis.sufficient) + ".");
  }
  Markup body = Element("header", {}, header);
  body += GraphSection(analysis);
  body += SubtaskTable(analysis);
  body += OrderTable(analysis);
  body += PropertyTable(analysis);
  return Page("What mattered in " + std::string(name), body);
}

}  // namespace smile::report
