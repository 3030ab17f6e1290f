#include "scene_xml/internal_mechanism_writer.h"

#include <variant>

#include "scene_xml/internal_part_writer.h"

// Writes mechanisms so that the readers of this room make exactly the same scene of them: lengths
// and angles read back to the last bit, and ids are the final ones, which the reader then keeps.

namespace smile::scene_xml {
namespace {

template <class State>
/// Begins a state of a control, which has a name or not.
void OpenState(const State& state, XmlText* text) {
  text->Open("state");
  if (!state.name.empty()) text->Attribute("descriptionName", state.name);
}

/// The states of a switch have no content; their number is an attribute.
void WriteStates(const scene::ToggleSwitch&, XmlText*) {}

void WriteStates(const scene::IndicatorLights& lights, XmlText* text) {
  for (const scene::IndicatorLights::State& state : lights.states) {
    OpenState(state, text);
    for (const scene::Light& light : state.lights) {
      text->Open("light");
      text->Count("id", light.number);
      text->Attribute("color", ToString(light.color));
      text->Close();
    }
    text->Close();
  }
}

void WriteStates(const scene::CustomControl& control, XmlText* text) {
  for (const scene::CustomControl::State& state : control.states) {
    OpenState(state, text);
    for (const scene::Part& part : state.parts) WritePart(part, text);
    text->Close();
  }
}

/// Writes a reference to another element unless it is empty.
void WriteReference(std::string_view name, const std::string& id, XmlText* text) {
  if (!id.empty()) text->Attribute(name, id);
}

/// Writes a stage of tightness of a host point.
void WriteStage(const scene::TightnessStage& stage, XmlText* text) {
  text->Open("tightness");
  text->Pose(stage.X_HS);
  // Absent is not the same as 0.
  if (stage.downstream_state) text->Count("downstreamState", *stage.downstream_state);
  if (stage.locks_downstream) text->Boolean("downstreamLock", true);
  text->Close();
}

void WriteToolPlace(const scene::ToolPlace& place, XmlText* text) {
  text->Open("accepts");
  text->Attribute("tool", place.type);
  text->Point("at", place.p_GS);
  text->Direction("axis", place.axis);
  text->Close();
}

}  // namespace

void WriteTool(const scene::ToolSpec& tool, XmlText* text) {
  const scene::ToolSpec usual;
  text->Open("tool");
  text->Attribute("action", scene::kToolActions[static_cast<std::size_t>(tool.action)]);
  if (!tool.type.empty()) text->Attribute("type", tool.type);
  text->Point("at", tool.p_BT);
  text->Direction("axis", tool.axis);
  if (tool.edge > 0) text->Length("edge", tool.edge);
  if (tool.turn != usual.turn) text->Angle("turn", tool.turn);
  text->Length("reach", tool.reach);
  if (tool.angle != usual.angle) text->Angle("angle", tool.angle);
  text->Close();
}

void WriteTriggerRule(const scene::TriggerRule& rule, std::optional<scene::TriggerCause> usual,
                      XmlText* text) {
  // Only what differs from the defaults, since older programs refuse these attributes.
  const scene::TriggerRule defaults;
  if (rule.cause != usual) {
    text->Attribute("trigger", scene::kTriggerCauses[static_cast<std::size_t>(rule.cause)]);
  }
  if (rule.press_force != defaults.press_force) text->Number("pressForce", rule.press_force);
  if (rule.press_angle != defaults.press_angle) text->Angle("pressAngle", rule.press_angle);
}

void WriteControlAttributes(const scene::ToggleSwitch& toggle, XmlText* text) {
  text->Spans(toggle.size);
  text->Angle("angle", toggle.angle);
  text->Boolean("leftPressed", toggle.is_left_pressed);
  text->Count("numStates", toggle.num_states);
  text->Count("initState", toggle.initial_state);
  WriteTriggerRule(toggle.trigger, scene::ToggleSwitch().trigger.cause, text);
}

void WriteControlAttributes(const scene::IndicatorLights& lights, XmlText* text) {
  text->Length("lightRadius", lights.light_radius);
  text->Length("lightZspan", lights.light_height);
  text->Count("numLights", lights.num_lights);
  text->Length("xspan", lights.x_span);
  text->Count("initState", lights.initial_state);
}

void WriteControlAttributes(const scene::CustomControl& control, XmlText* text) {
  text->Attribute("name", control.name);
  text->Count("initState", control.initial_state);
}

/// Writes the controls that are driven and the states; nothing for shapes that are not controls.
void WriteControlContent(const scene::Shape& control, XmlText* text) {
  std::visit(
      [&](const auto& any) {
        // Exactly the controls have this member.
        if constexpr (requires { any.downstream; }) {
          for (const std::string& id : any.downstream) {
            text->Open("downstream");
            text->Attribute("id", id);
            text->Close();
          }
          WriteStates(any, text);
        }
      },
      control);
}

void WriteBondPoints(const scene::Composite& composite, XmlText* text) {
  for (const scene::GuestPoint& guest : composite.guests) {
    text->Open("guestBondPoint");
    text->Attribute("id", guest.id);
    text->Attribute("type", guest.type);
    text->Pose(guest.X_PG);
    WriteReference("initBondHostId", guest.initial_host, text);
    // The reader refuses a tightness of 0 with a host, and ignores one without.
    if (guest.initial_tightness > 0) text->Count("initBondTightness", guest.initial_tightness);
    if (guest.can_be_cut) text->Attribute("cut", "yes");
    if (guest.refuses_hands) text->Attribute("by", "tool");
    for (const scene::ToolPlace& place : guest.accepts) WriteToolPlace(place, text);
    text->Close();
  }
  for (const scene::HostPoint& host : composite.hosts) {
    text->Open("hostBondPoint");
    text->Attribute("id", host.id);
    text->Attribute("type", host.type);
    text->Pose(host.X_PH);
    WriteReference("downstream", host.downstream, text);
    WriteReference("downstreamOverride", host.downstream_override, text);
    WriteReference("downstreamLock", host.downstream_lock, text);
    for (const scene::TightnessStage& stage : host.stages) WriteStage(stage, text);
    text->Close();
  }
}

void WriteSlider(const scene::SliderSpec& slider, const scene::ObjectSpec& first,
                 const scene::ObjectSpec& second, XmlText* text) {
  text->Open("sliderJoint");
  if (!slider.id.empty()) text->Attribute("id", slider.id);
  // Members are written relative to the joint frame J, as the reader expects them.
  text->Pose(slider.X_WJ);
  text->Length("min", slider.min_offset);
  text->Length("max", slider.max_offset);
  text->Length("init", slider.initial_offset);
  text->Boolean("collision", slider.do_members_collide);
  text->Number("damping", slider.damping);
  text->Number("restitution", slider.restitution);
  text->Number("softness", slider.softness);
  WriteObject(first, slider.X_JA, text);
  WriteObject(second, slider.X_JB, text);
  text->Close();
}

void WriteChain(const scene::ChainSpec& chain, XmlText* text) {
  text->Open("chain");
  text->Attribute("id", chain.id);
  text->Attribute("color", ToString(chain.color));
  text->Point("start", chain.p_WStart);
  text->Point("end", chain.p_WEnd);
  text->Length("linkXspan", chain.link_size.x());
  text->Length("linkYspan", chain.link_size.y());
  text->Length("linkZspan", chain.link_size.z());
  // The number that was chosen is written, and not recomputed from the distance when read.
  text->Count("linkCount", static_cast<int>(chain.link_ids.size()));
  text->Length("linkPadding", chain.link_padding);
  text->Number("linkMass", chain.link_mass);
  if (!chain.can_be_cut) text->Attribute("cut", "no");
  text->Close();
}

}  // namespace smile::scene_xml
