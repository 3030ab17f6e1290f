#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace smile::robot::internal {

/// A start tag in an XML text.
struct XmlTag {
  std::string element;
  std::vector<std::pair<std::string, std::string>> attributes;  ///< values as written
  int line = 0;                                                 ///< 1 is the first line
  int depth = 0;                                                ///< 0 is the root

  /// The value of an attribute; empty when there is none.
  std::string_view Attribute(std::string_view name) const;
};

/// Lists all start tags in the order of the text.
///
/// The URDF parser recurses without bound on nested elements and forgets lines; this glance
/// beforehand bounds depth and number and remembers the lines. It knows tags, comments and
/// declarations, which is all a URDF has; document types and CDATA are refused.
///
/// @throws InputError where the text is not made of those, or nests too deep.
std::vector<XmlTag> ScanTags(std::string_view text, const std::string& file);

}  // namespace smile::robot::internal
