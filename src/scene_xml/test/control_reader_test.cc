#include <gtest/gtest.h>

#include "math/angles.h"
#include "scene/controls_of.h"
#include "scene_xml/test/scene_text.h"

namespace smile::scene_xml {
namespace {

const std::string kAtOrigin = " location='(0,0,0)'";

template <class Control>
Control MustReadControl(const std::string& element) {
  return std::get<Control>(MustReadObject(element).whole.shape);
}

std::string FaultOfControl(const std::string& element) { return FaultOf(SceneText(element)); }

TEST(ControlReader, ReadsASwitchWithItsDefaults) {
  const scene::ObjectSpec object = MustReadObject("<toggleSwitch" + kAtOrigin + "/>");
  EXPECT_EQ(object.id(), "obj");
  EXPECT_EQ(object.whole.color, *ParseColor("darkgray"));
  EXPECT_EQ(object.mass, 1);
  EXPECT_EQ(object.descriptions, (std::vector<scene::Description>{{"shape", "toggleSwitch"}}));
  EXPECT_EQ(std::get<scene::ToggleSwitch>(object.whole.shape), scene::ToggleSwitch{});
}

TEST(ControlReader, ReadsASwitchWithAllAttributes) {
  const scene::SceneSpec scene = MustRead(SceneText(
      "<composite" + kAtOrigin + "><toggleSwitch id='S' xspan='1.7' yspan='1' zspan='0.5'" +
      kAtOrigin + " angle='20' leftPressed='false' numStates='3' initState='2' color='red'>" +
      "<downstream id='S'/></toggleSwitch></composite>"));
  const scene::Part& part = *scene::ControlsOf(scene.objects[0].whole).at(0);
  EXPECT_EQ(part.color, (Color{1, 0, 0}));
  EXPECT_EQ(std::get<scene::ToggleSwitch>(part.shape),
            (scene::ToggleSwitch{.size = {0.17, 0.1, 0.05},
                                 .angle = DegreesToRadians(20),
                                 .is_left_pressed = false,
                                 .num_states = 3,
                                 .initial_state = 2,
                                 .downstream = {"S"}}));
}

TEST(ControlReader, ReadsWhatTriggersASwitchOrAPart) {
  const auto toggle = MustReadControl<scene::ToggleSwitch>("<toggleSwitch" + kAtOrigin +
                                                           " pressForce='2' pressAngle='30'/>");
  EXPECT_EQ(toggle.trigger, (scene::TriggerRule{.cause = scene::TriggerCause::kPress,
                                                .press_force = 2,
                                                .press_angle = DegreesToRadians(30)}));
  const auto control = MustReadControl<scene::CustomControl>(
      "<customControl" + kAtOrigin + "><state><composite" + kAtOrigin +
      " nextStateWhenTriggered='0' trigger='press'><block" + kAtOrigin +
      "/></composite></state></customControl>");
  const scene::Part& group = control.states[0].parts[0];
  EXPECT_EQ(group.trigger, (scene::TriggerRule{.cause = scene::TriggerCause::kPress}));
  EXPECT_EQ(std::get<scene::Composite>(group.shape).parts[0].trigger, std::nullopt);
}

TEST(ControlReader, RefusesTriggersWithoutAMeaning) {
  EXPECT_EQ(
      FaultOfControl("<toggleSwitch" + kAtOrigin + " trigger='prress'/>"),
      "test.xml:3: <toggleSwitch>: found trigger=\"prress\", expected hand, press or cut; did you "
      "mean \"press\"?");
  EXPECT_EQ(FaultOfControl("<toggleSwitch" + kAtOrigin + " trigger='hand' pressForce='3'/>"),
            "test.xml:3: <toggleSwitch>: found pressForce=\"3\", expected pressForce only with "
            "trigger=\"press\"");
  EXPECT_EQ(FaultOfControl("<block" + kAtOrigin + " trigger='press'/>"),
            "test.xml:3: <block>: found trigger=\"press\", expected trigger only on a toggleSwitch "
            "or inside a state of a customControl");
}

TEST(ControlReader, ReadsLightsAndTheirStates) {
  const auto lights = MustReadControl<scene::IndicatorLights>(
      "<indicatorLights" + kAtOrigin + " numLights='3' lightRadius='0.7' initState='1' mass='2'>" +
      "<description name='a' value='b'/><state descriptionName='go'><light id='2' color='green'/>"
      "<light id='0'/></state><state/></indicatorLights>");
  EXPECT_EQ(lights.light_radius, 0.07);
  EXPECT_EQ(lights.initial_state, 1);
  EXPECT_EQ(lights.states,
            (std::vector<scene::IndicatorLights::State>{
                {"go", {{2, *ParseColor("green")}, {0, *ParseColor("red")}}}, {"", {}}}));
}

TEST(ControlReader, ReadsACustomControlAndWhereItsPartsLead) {
  const scene::ObjectSpec object =
      MustReadObject("<customControl name='dial'" + kAtOrigin + ">" + "<state><block" + kAtOrigin +
                     " nextStateWhenTriggered='1'/><composite" + kAtOrigin +
                     " nextStateWhenTriggered='-1'>" + "<sphere" + kAtOrigin +
                     "/></composite></state><state descriptionName='on'/></customControl>");
  EXPECT_EQ(object.descriptions[0].value, "dial");
  const auto& states = std::get<scene::CustomControl>(object.whole.shape).states;
  ASSERT_EQ(states.size(), 2u);
  EXPECT_EQ(states[0].parts[0].next_state, 1);
  EXPECT_EQ(states[0].parts[0].id, "") << "only controls and what is pointable get an id";
  EXPECT_EQ(states[0].parts[1].next_state, -1);
  const auto& group = std::get<scene::Composite>(states[0].parts[1].shape);
  EXPECT_EQ(group.parts[0].next_state, std::nullopt) << "it asks the composite";
  EXPECT_EQ(states[1].name, "on");
  EXPECT_EQ(MustReadControl<scene::CustomControl>("<customControl" + kAtOrigin +
                                                  "><state/></customControl>")
                .name,
            "customControl");
}

TEST(ControlReader, TakesStatesLightsAndDownstreamsFromTemplates) {
  const scene::SceneSpec scene = MustRead(
      SceneText("<def name='lamp'><var name='n' value='0'/><light id='$n$'/></def>"
                "<def name='states'><state><instance def='lamp'/></state>"
                "<state><instance def='lamp'><var name='n' value='1'/></instance></state></def>"
                "<def name='drives'><downstream id='$to$'/></def>"
                "<indicatorLights id='L'" +
                kAtOrigin +
                "><instance def='drives'>"
                "<var name='to' value='L'/></instance><instance def='states'/></indicatorLights>"));
  const auto& lights = std::get<scene::IndicatorLights>(scene.objects[0].whole.shape);
  ASSERT_EQ(lights.states.size(), 2u);
  EXPECT_EQ(lights.states[1].lights.at(0).number, 1);
  EXPECT_EQ(lights.downstream, std::vector<std::string>{"L"});
}

TEST(ControlReader, AllowsDescriptionsAfterOtherContent) {
  const scene::ObjectSpec object =
      MustReadObject("<indicatorLights" + kAtOrigin +
                     "><state/><description name='a' value='b'/></indicatorLights>");
  EXPECT_EQ(object.descriptions.size(), 2u);
}

TEST(ControlFaults, NameTheStateThatIsNone) {
  EXPECT_EQ(FaultOfControl("<toggleSwitch" + kAtOrigin + " initState='2'/>"),
            "test.xml:3: <toggleSwitch>: found initState=\"2\", expected a state of this control, "
            "from 0 to 1");
  EXPECT_EQ(
      FaultOfControl("<indicatorLights" + kAtOrigin + " initState='1'><state/></indicatorLights>"),
      "test.xml:3: <indicatorLights>: found initState=\"1\", expected a state of this "
      "control, from 0 to 0");
  EXPECT_EQ(FaultOfControl("<customControl" + kAtOrigin + "/>"),
            "test.xml:3: <customControl>: found no state, expected at least one");
  EXPECT_EQ(FaultOfControl("<customControl" + kAtOrigin + "><state>\n<block" + kAtOrigin +
                           " nextStateWhenTriggered='1'/></state></customControl>"),
            "test.xml:4: <block>: found nextStateWhenTriggered=\"1\", expected a whole number from "
            "-1 to 0");
  EXPECT_EQ(FaultOfControl("<toggleSwitch" + kAtOrigin + " numStates='0'/>"),
            "test.xml:3: <toggleSwitch>: found numStates=\"0\", expected a whole number from 1 to "
            "256");
}

TEST(ControlFaults, NameTheLightThatIsNone) {
  const auto fault_of_lights = [](const std::string& lights) {
    return FaultOfControl("<indicatorLights" + kAtOrigin + "><state>\n" + lights +
                          "</state></indicatorLights>");
  };
  EXPECT_EQ(fault_of_lights("<light id='2'/>"),
            "test.xml:4: <light id=\"2\">: found id=\"2\", expected a whole number from 0 to 1");
  EXPECT_EQ(fault_of_lights("<light/>"), "test.xml:4: <light>: found no id, expected id=\"…\"");
  EXPECT_EQ(fault_of_lights("<light id='1'/><light id='1'/>"),
            "test.xml:4: <light id=\"1\">: found id=\"1\", expected each light once in a state");
  EXPECT_EQ(fault_of_lights("<lihgt id='1'/>"),
            "test.xml:4: <lihgt id=\"1\">: found an unknown element, expected light; did you mean "
            "\"light\"?");
}

TEST(ControlFaults, ReportWhichElementsAreAllowedWhere) {
  const std::string toggle = "<toggleSwitch" + kAtOrigin + "/>";
  EXPECT_EQ(FaultOfControl("<customControl" + kAtOrigin + "><state>" + toggle +
                           "</state></customControl>"),
            "test.xml:3: <toggleSwitch>: found an element that does not belong here, expected "
            "block, box, composite, "
            "custom, cylinder, frustum, ring or sphere");
  EXPECT_EQ(FaultOfControl("<customControl" + kAtOrigin + "><state><composite" + kAtOrigin +
                           "><hostBondPoint type='a'/></composite></state></customControl>"),
            "test.xml:3: <hostBondPoint>: found an element that does not belong here, expected "
            "block, box, "
            "composite, custom, cylinder, frustum, ring or sphere");
  EXPECT_EQ(
      FaultOfControl("<toggleSwitch" + kAtOrigin + "><state/></toggleSwitch>"),
      "test.xml:3: <state>: found an element that does not belong here, expected description, "
      "tool or downstream");
  EXPECT_EQ(FaultOfControl("<block" + kAtOrigin + " nextStateWhenTriggered='0'/>"),
            "test.xml:3: <block>: found nextStateWhenTriggered=\"0\", expected "
            "nextStateWhenTriggered only inside a state of a customControl");
  EXPECT_NE(
      FaultOfControl("<indicatorLights" + kAtOrigin + " color='red'><state/></indicatorLights>")
          .find("found attribute \"color\""),
      std::string::npos);
}

TEST(ControlFaults, BoundWhatAControlHas) {
  const auto repeated = [](const std::string& text, int count) {
    std::string all;
    for (int i = 0; i < count; ++i) all += text;
    return all;
  };
  EXPECT_EQ(FaultOfControl("<indicatorLights" + kAtOrigin + ">" + repeated("<state/>", 257) +
                           "</indicatorLights>"),
            "test.xml:3: <indicatorLights>: found 257 states, expected at most 256");
  EXPECT_EQ(FaultOfControl("<toggleSwitch id='S'" + kAtOrigin + ">" +
                           repeated("<downstream id='S'/>", 257) + "</toggleSwitch>"),
            "test.xml:3: <toggleSwitch id=\"S\">: found 257 downstream elements, expected at most "
            "256");
  EXPECT_EQ(FaultOfControl("<composite" + kAtOrigin + ">" +
                           repeated("<ring sides='64'" + kAtOrigin + "/>", 65) + "</composite>"),
            "test.xml:3: <composite>: found 4160 convex pieces, a ring having one for each side up "
            "to 64, expected at most 4096 in an object");
}

TEST(References, FindControlsAnywhereAndRenamed) {
  const std::string scene = "<toggleSwitch id='S'" + kAtOrigin +
                            "><downstream id='L'/><downstream id='block'/>"
                            "<downstream id='S#1'/></toggleSwitch>"
                            "<block id='L'" +
                            kAtOrigin + "/><block id='block'" + kAtOrigin + "/>" +
                            "<toggleSwitch id='block'" + kAtOrigin + "/><toggleSwitch id='S'" +
                            kAtOrigin + "/>" + "<indicatorLights id='L'" + kAtOrigin +
                            "><state/></indicatorLights>";
  EXPECT_EQ(scene::DownstreamOf(MustRead(SceneText(scene)).objects[0].whole),
            (std::vector<std::string>{"L#2", "block#0", "S#1"}));
}

TEST(References, AreFaultsIfTheyMatchNoneOrSeveral) {
  const std::string toggle = "<toggleSwitch id='S'" + kAtOrigin + ">\n<downstream id='";
  EXPECT_EQ(FaultOfControl(toggle + "LAMP'/></toggleSwitch><indicatorLights id='Lamp'" + kAtOrigin +
                           "><state/></indicatorLights>"),
            "test.xml:4: <downstream id=\"LAMP\">: found id=\"LAMP\", expected the id of a control "
            "in this scene; did you mean \"Lamp\"?");
  const std::string lamp = "<toggleSwitch id='L'" + kAtOrigin + "/>";
  EXPECT_EQ(FaultOfControl("<block id='L'" + kAtOrigin + "/>" + toggle + "L'/></toggleSwitch>" +
                           lamp + lamp),
            "test.xml:4: <downstream id=\"L\">: found id=\"L\", expected L#0 or L#1: the file "
            "has 2 controls with this id");
  EXPECT_EQ(FaultOfControl(toggle + "'/></toggleSwitch>"),
            "test.xml:4: <downstream id=\"\">: found id=\"\", expected the id of a control");
  EXPECT_EQ(
      FaultsOf(SceneText("<include file='none.xml'/>" + toggle + "L'/></toggleSwitch>")).size(), 1u)
      << "it may be in the file that is missing";
}

}  // namespace
}  // namespace smile::scene_xml
