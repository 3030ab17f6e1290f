#pragma once

#include <string>
#include <string_view>

namespace smile::study {

/// Returns the line of an element in the text of a JSON file.
/// @param text   valid JSON.
/// @param place  path of the element, as `tasks/0/scene`; empty: the whole file.
/// @returns 1 for the first line; the line of the innermost element that exists.
int LineOf(std::string_view text, std::string_view place);

}  // namespace smile::study
