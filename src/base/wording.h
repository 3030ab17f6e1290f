#pragma once

#include <span>
#include <string>
#include <string_view>

namespace smile {

// Pieces of the messages that tell people what was found in their input and what was expected.

/// The text in quotation marks, for a message: cut to a readable length, control characters as `?`.
std::string Quoted(std::string_view text);

/// The text with control characters as `?`, so that a terminal only shows it.
std::string Printable(std::string_view text);

/// The shortest decimal text that reads back to the same number; `NaN`, `Inf`, `-Inf` for those.
std::string NumberText(double number);

/// `block, box or sphere`.
std::string OneOf(std::span<const std::string_view> words);

/// `; did you mean "block"?` when one of `known` looks like what was meant by `word`, else empty.
std::string DidYouMean(std::string_view word, std::span<const std::string_view> known);

}  // namespace smile
