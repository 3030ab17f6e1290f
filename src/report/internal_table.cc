#include "report/internal_table.h"

// Tables with captions and scopes of headers, which screen readers announce.

namespace smile::report {

Markup Row(std::initializer_list<Markup> cells) {
  Markup row;
  for (const Markup& cell : cells) row += cell;
  return Element("tr", {}, row);
}

Markup Cell(std::string_view text) { return Element("td", {}, text); }

Markup NumberCell(std::string_view text) { return Element("td", {{"class", "number"}}, text); }

Markup WideCell(std::string_view text) { return Element("td", {{"class", "wide"}}, text); }

Markup Head(std::string_view text) { return Element("th", {{"scope", "col"}}, text); }

Markup NumberHead(std::string_view text) {
  return Element("th", {{"scope", "col"}, {"class", "number"}}, text);
}

Markup RowHead(std::string_view text) { return Element("th", {{"scope", "row"}}, text); }

Markup Table(std::string_view caption, const Markup& head, const Markup& rows) {
  Markup table = Element("caption", {}, Element("span", {}, caption));
  table += Element("thead", {}, head);
  table += Element("tbody", {}, rows);
  // Wide tables scroll by themselves; the tab index makes that possible with the keyboard.
  return Element("div", {{"class", "scroll"}, {"tabindex", "0"}}, Element("table", {}, table));
}

Markup Fact(std::string_view name, std::string_view value) {
  Markup fact = Element("dt", {}, name);
  fact += Element("dd", {}, value);
  return Element("div", {}, fact);
}

Markup Badge(bool is_good, std::string_view text) {
  return Element("span", {{"class", is_good ? "badge good" : "badge bad"}}, text);
}

}  // namespace smile::report
