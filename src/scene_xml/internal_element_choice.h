#pragma once

#include <span>
#include <string_view>

#include "scene_xml/internal_reading.h"
#include "scene_xml/internal_scene_element.h"
#include "scene_xml/internal_shape_readers.h"

namespace smile::scene_xml {

/// What an element stands in, which decides what it may be.
enum class Container {
  kTabletop,   ///< whole objects, chains, sliders
  kSlider,     ///< whole objects
  kComposite,  ///< parts: shapes, controls, bond points
  kState,      ///< of a custom control: shapes, and composites of shapes
};

inline bool HoldsWholes(Container container) {
  return container == Container::kTabletop || container == Container::kSlider;
}

/// False, with a finding, when the element is in another namespace than ours. What is inside such
/// an element is not looked at: one forgotten `xmlns` is one finding.
bool CheckNamespace(const SceneElement& element, Reading* reading);

/// The reader of an element that should be a shape; nullptr, with a finding, when it is none that
/// may stand there.
const ShapeElement* FindShape(const SceneElement& element, Container container, Reading* reading);

/// Adds `found an unknown element, expected …`; no `expected` at all means none may stand there.
void RefuseElement(const SceneElement& element, std::span<const std::string_view> expected,
                   Reading* reading);

/// Refuses all children.
void RefuseContent(const SceneElement& element, Reading* reading);

}  // namespace smile::scene_xml
