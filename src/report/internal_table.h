#pragma once

#include <initializer_list>
#include <string_view>

#include "report/markup.h"

namespace smile::report {

// Tables with captions, which scroll on their own if the screen is narrow.

Markup Row(std::initializer_list<Markup> cells);
Markup Cell(std::string_view text);
Markup NumberCell(std::string_view text);
/// Returns a cell for texts of any length.
Markup WideCell(std::string_view text);
Markup Head(std::string_view text);
Markup NumberHead(std::string_view text);
/// Returns the head of a row.
Markup RowHead(std::string_view text);
/// Returns a table.
/// @param head  row of heads; `rows`: all others.
Markup Table(std::string_view caption, const Markup& head, const Markup& rows);

/// Returns `name` above `value`, in a list of such facts.
Markup Fact(std::string_view name, std::string_view value);

/// Returns a text such as `success`, in good or bad colors.
Markup Badge(bool is_good, std::string_view text);

}  // namespace smile::report
