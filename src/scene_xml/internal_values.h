#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace smile::scene_xml {

// The value types of the scene language: text to value, nullopt when the text is not one. Blanks
// around a value are allowed, except in ids. docs/scene-format.md lists them.

/// A finite number: `3`, `-.5`, `+1.`, `1e-3`. Read with `long double` where a length must come
/// back to the last bit (see internal_units.h).
template <class Float>
std::optional<Float> ParseNumber(std::string_view text);
extern template std::optional<double> ParseNumber(std::string_view);
extern template std::optional<long double> ParseNumber(std::string_view);

/// `(a,b,c)`: `N` numbers in parentheses.
template <std::size_t N, class Float>
std::optional<std::array<Float, N>> ParseNumbers(std::string_view text);
extern template std::optional<std::array<double, 3>> ParseNumbers(std::string_view);
extern template std::optional<std::array<double, 9>> ParseNumbers(std::string_view);
extern template std::optional<std::array<long double, 3>> ParseNumbers(std::string_view);

/// A whole number that fits an `int`.
std::optional<int> ParseCount(std::string_view text);

/// `true`, `false`, `1` or `0`.
std::optional<bool> ParseBoolean(std::string_view text);

/// Letters A-Z and a-z, digits and `_`, at most 100 of them; may be empty.
bool IsId(std::string_view text);

/// An id as the program makes it when it has to rename: an id, `#` and digits, as in `obj#3`.
bool IsRenamedId(std::string_view text);

/// The shortest text that ParseNumber<double>() reads back to the same number, never with an
/// exponent: for people.
std::string PlainNumberText(double number);

}  // namespace smile::scene_xml
