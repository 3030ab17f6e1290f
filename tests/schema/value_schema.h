#pragma once

#include <string>

namespace smile::scene_xml {

/// The XML schema of the values of attributes, generated from scene_xml/value_ranges.h and the
/// names of colors: the text of `scenes/schema/values.xsd`.
///
/// @param allows_expressions  whether a `$…$` may stand for any value, as people write scenes: the
///                            text of `scenes/schema/values_or_expressions.xsd`.
std::string ValueSchema(bool allows_expressions);

}  // namespace smile::scene_xml
