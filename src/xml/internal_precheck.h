#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/diagnostic.h"
#include "xml/parse.h"

namespace smile::xml {

/// Inspects the raw text before the parser does: whether it is XML in an encoding of single bytes
/// at all, and whether a tag is overloaded with attributes (the parser compares each with each; a
/// million would take hours).
/// @returns the reason why the text must not be parsed; nullopt when it may be.
std::optional<Diagnostic> PrecheckFaultOf(std::string_view text, const std::string& file_name,
                                          const ParseOptions& options);

}  // namespace smile::xml
