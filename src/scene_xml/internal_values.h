#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace smile::scene_xml {

// Value types of the scene language: text to value, nullopt if the text is invalid. Blanks around a
// value are allowed, except in ids. docs/scene-format.md lists them.

/// Parses a finite number: `3`, `-.5`, `+1.`, `1e-3`. Used with `long double` where a length must
/// round-trip to the last bit (see internal_units.h).
template <class Float>
std::optional<Float> ParseNumber(std::string_view text);
extern template std::optional<double> ParseNumber(std::string_view);
extern template std::optional<long double> ParseNumber(std::string_view);

/// Parses `(a,b,c)`: `N` numbers in parentheses.
template <std::size_t N, class Float>
std::optional<std::array<Float, N>> ParseNumbers(std::string_view text);
extern template std::optional<std::array<double, 3>> ParseNumbers(std::string_view);
extern template std::optional<std::array<double, 9>> ParseNumbers(std::string_view);
extern template std::optional<std::array<long double, 3>> ParseNumbers(std::string_view);

/// Parses a whole number that fits an `int`.
std::optional<int> ParseCount(std::string_view text);

/// Parses `true`, `false`, `1` or `0`.
std::optional<bool> ParseBoolean(std::string_view text);

/// True for ids: letters A-Z and a-z, digits and `_`, at most 100 of them; may be empty.
bool IsId(std::string_view text);

/// True for ids that the program makes to avoid duplicates: an id, `#` and digits, as in `obj#3`.
bool IsRenamedId(std::string_view text);

/// Returns the shortest text that ParseNumber<double>() reads back to the same number, without
/// exponent: for people.
std::string PlainNumberText(double number);

}  // namespace smile::scene_xml
