#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace smile::xml {

struct Attribute {
  std::string name;  ///< with its prefix, if it has one
  std::string value;

  bool operator==(const Attribute&) const = default;
};

/// Element of an XML file with everything inside it. Comments (but see
/// Parsed::comment), processing instructions and the attributes that only concern XML tools
/// (`xsi:…`, `xml:…`, `xmlns…`) are left out.
struct Element {
  std::string name;            ///< without prefix, unless prefixes are part of names
  std::string namespace_name;  ///< empty for none; of a long one the first 100 bytes
  int line = 1;                ///< of its tag's begin; 1 is the first line
  std::vector<Attribute> attributes;
  std::string text;  ///< directly inside it, in one piece, when text is kept
  std::vector<Element> children;

  bool operator==(const Element&) const = default;

  /// Returns the value of an attribute; nullptr if it is missing.
  const std::string* FindAttribute(std::string_view attribute_name) const;
  /// Returns the first child of that name; nullptr if it is missing.
  const Element* FindChild(std::string_view child_name) const;
};

/// Returns the address of an element in messages: `block id="B3"`; a missing key is left out.
///
/// @param key  name of the attribute by which people identify the element; may be empty.
/// @param value  of that attribute; nullptr when it is missing.
std::string AddressOf(std::string_view element_name, std::string_view key,
                      const std::string* value);

}  // namespace smile::xml
