#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/diagnostic.h"
#include "xml/parse.h"

namespace smile::xml {

/// Inspects the raw text before parsing: checks that it is XML without NUL bytes (which wide
/// encodings have), and that no tag is overloaded with attributes (the parser compares each with
/// each; a million would take hours).
/// @returns the reason why the text must not be parsed; nullopt if it may be.
std::optional<Diagnostic> PrecheckFaultOf(std::string_view text, const std::string& file_name,
                                          const ParseOptions& options);

}  // namespace smile::xml
