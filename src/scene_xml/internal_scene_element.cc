#include "scene_xml/internal_scene_element.h"

#include <utility>

#include "base/diagnostic.h"
#include "base/wording.h"
#include "xml/parse.h"

namespace smile::scene_xml {
namespace {

/// Returns the attribute by which people identify an element.
std::string_view NameOfKey(std::string_view element_name) {
  if (element_name == "def" || element_name == "var") return "name";
  if (element_name == "instance") return "def";
  return "id";
}

/// Converts a parsed tree. Recursion is safe, as its depth is bounded.
SceneElement ToSceneElement(xml::Element&& parsed, int file) {
  SceneElement element;
  element.name = std::move(parsed.name);
  // Names of elements are local: namespaces are reduced to a yes or no here, and to a text for
  // messages.
  element.place = {file, parsed.line};
  element.is_in_scene_namespace = parsed.namespace_name == kSceneNamespace;
  if (!element.is_in_scene_namespace && !parsed.namespace_name.empty()) {
    element.found_namespace = Quoted(parsed.namespace_name);
  }
  element.attributes.reserve(parsed.attributes.size());
  for (xml::Attribute& attribute : parsed.attributes) {
    element.attributes.push_back({std::move(attribute.name), std::move(attribute.value)});
  }
  element.children.reserve(parsed.children.size());
  for (xml::Element& child : parsed.children) {
    element.children.push_back(ToSceneElement(std::move(child), file));
  }
  return element;
}

}  // namespace

const std::string* SceneElement::FindAttribute(std::string_view attribute_name) const {
  for (const SceneAttribute& attribute : attributes) {
    if (attribute.name == attribute_name) return &attribute.value;
  }
  return nullptr;
}

std::string AddressOf(const SceneElement& element) {
  const std::string_view key = NameOfKey(element.name);
  return xml::AddressOf(element.name, key, element.FindAttribute(key));
}

std::optional<SceneElement> ParseSceneXml(std::string_view text, int file,
                                          const SceneLimits& limits, int* num_elements,
                                          Findings* findings) {
  const xml::ParseOptions options{.limits = {.max_bytes = limits.max_file_bytes,
                                             .max_depth = limits.max_depth,
                                             .max_elements = limits.max_elements,
                                             .max_attributes = limits.max_attributes,
                                             // One more than are listed shows that there are more.
                                             .max_diagnostics = limits.max_diagnostics + 1},
                                  .root = "tabletop",
                                  .text = xml::TextPolicy::kRefuse,
                                  .num_elements_before = *num_elements,
                                  .key_of = NameOfKey};
  // Without a file name, since findings get theirs from the place.
  xml::Parsed parsed = xml::Parse(text, /*file_name=*/"", options);
  *num_elements += parsed.num_elements;
  for (Diagnostic& fault : parsed.diagnostics) {
    findings->Add({file, fault.line}, std::move(fault.element), std::move(fault.message));
  }
  if (!parsed.root) return std::nullopt;
  return ToSceneElement(*std::move(parsed.root), file);
}

}  // namespace smile::scene_xml
