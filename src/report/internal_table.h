#pragma once

#include <initializer_list>
#include <string_view>

#include "report/markup.h"

namespace smile::report {

// Tables with captions, which scroll within themselves where the screen is narrow.

Markup Row(std::initializer_list<Markup> cells);
Markup Cell(std::string_view text);
Markup NumberCell(std::string_view text);
/// For texts of any length.
Markup WideCell(std::string_view text);
Markup Head(std::string_view text);
Markup NumberHead(std::string_view text);
/// What a row is about.
Markup RowHead(std::string_view text);
/// @param head  a row of heads; `rows`: all others.
Markup Table(std::string_view caption, const Markup& head, const Markup& rows);

/// `name` above `value`, in a list of such facts.
Markup Fact(std::string_view name, std::string_view value);

/// `rebuilt`, in good or bad colors.
Markup Badge(bool is_good, std::string_view text);

}  // namespace smile::report
