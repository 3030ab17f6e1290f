#pragma once

#include <string>

#include "base/json.h"

// All commands described, as their structs tell it: see command.h.

namespace smile::sim {

/// A JSON Schema (draft 2020-12).
Json CommandSchema();

/// For people at a terminal.
std::string CommandText();

/// The table of docs/commands.md.
std::string CommandMarkdown();

/// The page's types: web/src/commands.ts.
std::string CommandTypeScript();

}  // namespace smile::sim
