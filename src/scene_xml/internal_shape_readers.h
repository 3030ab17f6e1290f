#pragma once

#include <span>
#include <string_view>

#include "scene/scene_spec.h"
#include "scene_xml/internal_attribute_reader.h"

namespace smile::scene_xml {

/// One line of the table of shapes: a new shape of the language is a reader and a line.
struct ShapeElement {
  std::string_view name;
  /// Reads the attributes that this kind of shape has of its own.
  scene::Shape (*read)(AttributeReader* attributes);
  /// Empty for shapes without a color of their own.
  std::string_view default_color = "gray";
  bool is_control = false;
};

/// Returns the shapes in alphabetic order.
std::span<const ShapeElement> ShapeElements();

/// Reads `friction`, `restitution` and `rollingFriction`, which only whole objects have.
scene::Surface ReadSurface(AttributeReader* attributes);

}  // namespace smile::scene_xml
