#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene_xml/internal_findings.h"
#include "scene_xml/scene_limits.h"

namespace smile::scene_xml {

/// Namespace of all elements of a scene file.
inline constexpr std::string_view kSceneNamespace = "http://synapse.cs.umd.edu/tabletop-xml";

struct SceneAttribute {
  std::string name;  ///< with its prefix, if it has one
  std::string value;
  bool is_faulty = false;  ///< its expression has a fault, which has been reported
};

/// Element of a scene: as xml::Parse() returned it from one of the files, with its place among all
/// of them, while files are included and templates expanded.
struct SceneElement {
  std::string name;      ///< without prefix
  SourceLocation place;  ///< of its tag's begin
  bool is_in_scene_namespace = false;
  std::string found_namespace;  ///< for a message, when it is in another one; empty = in none
  std::vector<SceneAttribute> attributes;
  std::vector<SceneElement> children;

  /// True if it is this element of the scene language.
  bool Is(std::string_view element_name) const {
    return is_in_scene_namespace && name == element_name;
  }
  const std::string* FindAttribute(std::string_view attribute_name) const;
};

/// Returns the address of an element in messages: `block id="B3"`, `var name="size"`, `instance
/// def="lid"`.
std::string AddressOf(const SceneElement& element);

/// Parses one file of a scene; returns nullopt, with the reason in `findings`, if it is not
/// well-formed XML or exceeds a limit. Text between elements is a finding, but the tree is still
/// returned.
///
/// @param file          of the places in it.
/// @param num_elements  number of elements of the scene so far; increased.
std::optional<SceneElement> ParseSceneXml(std::string_view text, int file,
                                          const SceneLimits& limits, int* num_elements,
                                          Findings* findings);

}  // namespace smile::scene_xml
