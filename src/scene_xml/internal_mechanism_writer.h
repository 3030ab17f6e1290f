#pragma once

#include <optional>

#include "scene/scene_spec.h"
#include "scene_xml/internal_xml_text.h"

namespace smile::scene_xml {

// Write the attributes that are specific to each kind of control.
void WriteControlAttributes(const scene::ToggleSwitch& toggle, XmlText* text);
void WriteControlAttributes(const scene::IndicatorLights& lights, XmlText* text);
void WriteControlAttributes(const scene::CustomControl& control, XmlText* text);

/// Writes `trigger`, and the force and angle of a press if they are not the defaults.
/// @param usual  the cause that need not be written.
void WriteTriggerRule(const scene::TriggerRule& rule, std::optional<scene::TriggerCause> usual,
                      XmlText* text);

/// Writes downstreams and states.
void WriteControlContent(const scene::Shape& control, XmlText* text);

void WriteTool(const scene::ToolSpec& tool, XmlText* text);

void WriteBondPoints(const scene::Composite& composite, XmlText* text);

void WriteSlider(const scene::SliderSpec& slider, const scene::ObjectSpec& first,
                 const scene::ObjectSpec& second, XmlText* text);

void WriteChain(const scene::ChainSpec& chain, XmlText* text);

}  // namespace smile::scene_xml
