#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene_xml/internal_findings.h"
#include "scene_xml/scene_reader.h"

namespace smile::scene_xml {

/// The namespace every element of a scene file is in.
inline constexpr std::string_view kSceneNamespace = "http://synapse.cs.umd.edu/tabletop-xml";

struct XmlAttribute {
  std::string name;  ///< with its prefix, if it has one
  std::string value;
  bool is_faulty = false;  ///< its expression has a fault, which has been reported
};

/// An element of a well-formed file. Comments, blanks and the attributes that only speak to XML
/// tools (`xsi:…`, `xml:…`, `xmlns…`) are left out.
struct XmlElement {
  std::string name;  ///< without prefix
  Place place;       ///< where its tag begins
  bool is_in_scene_namespace = false;
  std::string found_namespace;  ///< for a message, when it is in another one; empty = in none
  std::vector<XmlAttribute> attributes;
  std::vector<XmlElement> children;

  /// Whether it is this element of the scene language.
  bool Is(std::string_view element_name) const {
    return is_in_scene_namespace && name == element_name;
  }
  const std::string* FindAttribute(std::string_view attribute_name) const;
};

/// How a message addresses an element: `block id="B3"`, `var name="size"`, `instance def="lid"`.
std::string AddressOf(const XmlElement& element);

/// The file as a tree; nullopt, with the reason in `findings`, when it is not well-formed XML or
/// passes a limit. Text between elements is a finding, but the tree is still returned.
///
/// The parser reads no other file, opens no connection and accepts no DOCTYPE, so a file can
/// neither define entities nor ask for anything outside itself.
///
/// @param file          of the places in it.
/// @param num_elements  how many the scene has so far; counted on.
std::optional<XmlElement> ParseXml(std::string_view text, int file, const SceneLimits& limits,
                                   int* num_elements, Findings* findings);

}  // namespace smile::scene_xml
