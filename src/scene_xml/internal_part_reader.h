#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "scene/shape.h"
#include "scene_xml/internal_attribute_reader.h"
#include "scene_xml/internal_element_choice.h"
#include "scene_xml/internal_shape_readers.h"

namespace smile::scene_xml {

/// Place of a shape in its container.
struct PartPlace {
  Container container = Container::kComposite;
  int num_states = 0;  ///< in a state of a custom control: number of its states
};

/// Reads the attributes that whole objects and parts have in common: all but content, mass and the
/// check for unknown attributes. Whole objects, controls and pointable parts get a unique id.
scene::Part ReadPartAttributes(const SceneElement& element, const ShapeElement& shape,
                               const PartPlace& place, AttributeReader* attributes,
                               ReadingContext* reading);

/// Reads the content of a shape except descriptions: parts, bond points, states, downstreams.
///
/// @param others  further element names that messages list as expected.
void ReadContent(const PartPlace& place, std::span<const SceneElement* const> content,
                 std::span<const std::string_view> others, AttributeReader* attributes,
                 scene::Part* part, ReadingContext* reading);

/// Reads a part of a composite or of a state, with its content.
scene::Part ReadPart(const SceneElement& element, const ShapeElement& shape, const PartPlace& place,
                     ReadingContext* reading);

}  // namespace smile::scene_xml
