#pragma once

#include <span>
#include <string>
#include <string_view>

namespace smile {

// Parts of messages about what was found in an input and what was expected.

/// Returns the text in quotation marks, for a message: cut to a readable length, control characters
/// as `?`.
std::string Quoted(std::string_view text);

/// Returns the text with control characters as `?`, so that a terminal only displays it.
std::string Printable(std::string_view text);

/// Returns the shortest decimal text that reads back to the same number; `NaN`, `Inf`, `-Inf` for
/// those.
std::string NumberText(double number);

/// Returns a list such as `block, box or sphere`.
std::string OneOf(std::span<const std::string_view> words);

/// Returns `; did you mean "block"?` if one of `known` is similar to `word`, otherwise an empty
/// text.
std::string DidYouMean(std::string_view word, std::span<const std::string_view> known);

}  // namespace smile
