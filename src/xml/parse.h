#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.h"
#include "xml/element.h"

namespace smile::xml {

/// Limits on the cost of a file, which is untrusted input. A file beyond a limit is refused with a
/// diagnostic.
struct Limits {
  std::size_t max_bytes = 32u << 20;
  int max_depth = 256;         ///< elements inside one another; at most 256
  int max_elements = 100'000;  ///< of this file and ParseOptions::num_elements_before
  int max_attributes = 256;    ///< of one element, declarations of namespaces among them
  int max_namespaces = 8;      ///< declared by one element
  int max_diagnostics = 1000;  ///< about text; the fault that ends parsing comes in addition
  std::size_t max_comment_bytes = 4096;  ///< of Parsed::comment; a longer one is cut off
};

/// Treatment of text between tags that is not blank.
enum class TextPolicy {
  kRefuse,  ///< each is a diagnostic; the tree is still returned
  kSkip,
  kKeep  ///< in Element::text, blanks included
};

enum class Strictness {
  kStrict,  ///< well-formed XML with namespaces
  /// Additionally accepts deviations that tools commonly write into URDF and COLLADA files and
  /// their readers accept: prefixes without a namespace (they are then part of all names, and
  /// namespaces are not reported), two hyphens in a comment, the encodings ISO-8859 and
  /// Windows-125x.
  kTolerant
};

struct ParseOptions {
  Limits limits;
  std::string_view root = "root";  ///< the element that messages about empty files expect
  TextPolicy text = TextPolicy::kKeep;
  Strictness strictness = Strictness::kStrict;
  /// Number of elements of other files, which count towards Limits::max_elements.
  int num_elements_before = 0;
  /// Returns the attribute by which people identify an element of that name, for addresses in
  /// diagnostics; nullptr: addresses without it.
  std::string_view (*key_of)(std::string_view element_name) = nullptr;
};

/// Result of Parse().
struct Parsed {
  std::optional<Element> root;  ///< empty if the file is refused; then there is a diagnostic
  std::vector<Diagnostic> diagnostics;  ///< in the order they were found
  /// First comment before the root, without its marks; also present if the file is refused for what
  /// follows it.
  std::string comment;
  int num_elements = 0;
};

/// Reads an XML file in UTF-8 as a tree of bounded size.
///
/// The parser opens no other file and no connection and accepts no DOCTYPE, so a file can neither
/// define entities nor refer to anything outside itself. Processing instructions are skipped,
/// except those that contain a tag, which other parsers may read. Time and memory are bounded by
/// the limits; lines are exact for files of any length.
///
/// @param file_name  of the diagnostics. Each has a line of at least 1.
Parsed Parse(std::string_view text, const std::string& file_name, const ParseOptions& options = {});

}  // namespace smile::xml
