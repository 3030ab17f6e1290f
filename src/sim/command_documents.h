#pragma once

#include <string>

#include "base/json.h"

// Documentation of all commands, generated from their structs: see command.h.

namespace smile::sim {

/// Returns a JSON Schema (draft 2020-12).
Json CommandSchema();

/// Returns text for a terminal.
std::string CommandText();

/// Returns the table of docs/commands.md.
std::string CommandMarkdown();

/// Returns the page's types: web/src/commands.ts.
std::string CommandTypeScript();

}  // namespace smile::sim
