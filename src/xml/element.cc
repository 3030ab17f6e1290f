#include "xml/element.h"

#include <algorithm>

#include "base/wording.h"

namespace smile::xml {

const std::string* Element::FindAttribute(std::string_view attribute_name) const {
  const auto found = std::ranges::find(attributes, attribute_name, &Attribute::name);
  return found == attributes.end() ? nullptr : &found->value;
}

const Element* Element::FindChild(std::string_view child_name) const {
  const auto found = std::ranges::find(children, child_name, &Element::name);
  return found == children.end() ? nullptr : &*found;
}

std::string AddressOf(std::string_view element_name, std::string_view key,
                      const std::string* value) {
  // Names of elements come from the file, and may be of any length.
  constexpr std::size_t kMaxNameBytes = 60;
  std::string address(element_name.substr(0, kMaxNameBytes));
  if (value) address += " " + std::string(key) + "=" + Quoted(*value);
  return address;
}

}  // namespace smile::xml
