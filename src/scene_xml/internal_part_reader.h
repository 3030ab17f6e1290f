#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "scene/shape.h"
#include "scene_xml/internal_attribute_reader.h"
#include "scene_xml/internal_element_choice.h"
#include "scene_xml/internal_shape_readers.h"

namespace smile::scene_xml {

/// Where a shape stands.
struct PartPlace {
  Container container = Container::kComposite;
  int num_states = 0;  ///< in a state of a custom control: how many it has
};

/// What whole objects and parts have in common: all but content, mass and the check for unknown
/// attributes. Whole objects, controls and what can be pointed at get an id of their own.
scene::Part ReadPartAttributes(const SceneElement& element, const ShapeElement& shape,
                               const PartPlace& place, AttributeReader* attributes,
                               Reading* reading);

/// The content of a shape but for its descriptions: parts, bond points, states, downstreams.
///
/// @param others  words a message should say may stand there too.
void ReadContent(const PartPlace& place, std::span<const SceneElement* const> content,
                 std::span<const std::string_view> others, AttributeReader* attributes,
                 scene::Part* part, Reading* reading);

/// A part of a composite or of a state, with all that is in it.
scene::Part ReadPart(const SceneElement& element, const ShapeElement& shape, const PartPlace& place,
                     Reading* reading);

}  // namespace smile::scene_xml
