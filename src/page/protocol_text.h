#pragma once

#include <string>

// Tables of page_protocol.h as text, which tools/generate.py writes to files.

namespace smile::page {

/// Return the tables of docs/studio-protocol.md.
std::string RequestMarkdown();
std::string UpdateMarkdown();

/// Returns the page's types: web/src/messages.ts.
std::string ProtocolTypeScript();

}  // namespace smile::page
