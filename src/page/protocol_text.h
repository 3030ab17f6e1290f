#pragma once

#include <string>

// The tables of page_protocol.h as text, which tools/generate.py writes to files.

namespace smile::page {

/// The tables of docs/studio-protocol.md.
std::string RequestMarkdown();
std::string UpdateMarkdown();

/// The page's types: web/src/messages.ts.
std::string ProtocolTypeScript();

}  // namespace smile::page
