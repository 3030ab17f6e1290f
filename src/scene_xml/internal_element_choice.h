#pragma once

#include <span>
#include <string_view>

#include "scene_xml/internal_reading_context.h"
#include "scene_xml/internal_scene_element.h"
#include "scene_xml/internal_shape_readers.h"

namespace smile::scene_xml {

/// Container of an element, which determines the elements that are allowed.
enum class Container {
  kTabletop,   ///< whole objects, chains, sliders
  kSlider,     ///< whole objects
  kComposite,  ///< parts: shapes, controls, bond points
  kState,      ///< of a custom control: shapes, and composites of shapes
};

inline bool HoldsWholes(Container container) {
  return container == Container::kTabletop || container == Container::kSlider;
}

/// Returns false, with a finding, if the element is in another namespace. The content of such an
/// element is not inspected: one forgotten `xmlns` gives one finding.
bool CheckNamespace(const SceneElement& element, ReadingContext* reading);

/// Returns the reader of a shape element; nullptr, with a finding, if the element is not a shape
/// that is allowed there.
const ShapeElement* FindShape(const SceneElement& element, Container container,
                              ReadingContext* reading);

/// Adds `found an unknown element, expected …`; without `expected`, no element is allowed there.
void RefuseElement(const SceneElement& element, std::span<const std::string_view> expected,
                   ReadingContext* reading);

/// Refuses all children.
void RefuseContent(const SceneElement& element, ReadingContext* reading);

}  // namespace smile::scene_xml
