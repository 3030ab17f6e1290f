#pragma once

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "scene_xml/scene_reader.h"

namespace smile::scene_xml {

/// A scene file whose line 2 is the root's tag and line 3 the first of `content`.
inline std::string SceneText(std::string_view content, std::string_view root_attributes = "") {
  return "<?xml version=\"1.0\"?>\n<tabletop xmlns=\"http://synapse.cs.umd.edu/tabletop-xml\"" +
         std::string(root_attributes) + ">\n" + std::string(content) + "\n</tabletop>\n";
}

/// A scene with one of everything there is, as a person would write it.
inline std::string SceneOfEverything() {
  return SceneText(R"(
    <sliderJoint location='(0, -.5,1.0E-4)' init='0.5' softness='1'>
      <box location='(0,0,0)'/>
      <cylinder radius='.4' location='(0,0,0)' mass='0'>
        <tool action='cut' at='(0,1,0)' axis='(0,1,0)' edge='2'/>
      </cylinder>
    </sliderJoint>
    <camera id='overhead' location='(0,0,12)' target='(0,0, .5)' up='(0,1,0)' fov='45'/>
    <chain start='(0,0,1)' end='(0,3,1)' linkCount='0' linkPadding='0' cut='no'/>
    <composite location='(0,0,1)'>
      <description name='a' value='b'/>
      <ring radiusInner='0' location='(0,0,0)' pointable='1'/>
      <toggleSwitch id='S' angle='20' pressAngle='20' location='(0,0,0)'><downstream id='L'/></toggleSwitch>
      <guestBondPoint type='M3' initBondHostId='H' initBondTightness='1' by='tool' cut='yes'>
        <accepts tool='phillips' at='(0,0,1)'/>
      </guestBondPoint>
      <indicatorLights id='L' location='(0,0,0)'>
        <state><light id='1' color=' #12aBcD'/></state>
      </indicatorLights>
    </composite>
    <composite location='(2,0,1)' rotation='(0,0,30)'>
      <hostBondPoint id='H' type='M3' downstream='S' downstreamOverride='L' downstreamLock='H'>
        <tightness downstreamLock='1'/>
        <tightness location='(0,0,1)' downstreamState='0'/>
      </hostBondPoint>
    </composite>
    <customControl name='dial' location='(0,0,0)'>
      <state descriptionName='on'>
        <composite location='(0,0,0)'>
          <frustum location='(0,0,0)' nextStateWhenTriggered='-1' trigger='press' pressForce='0.3'/>
        </composite>
      </state>
    </customControl>
    <sphere id='a#1' location='(0,0,0)' friction='1' rollingFriction='0.1'/>)");
}

/// The scene of a text that must be free of faults.
inline scene::SceneSpec MustRead(std::string_view text) {
  SceneReading reading = ReadSceneText(text, "test.xml");
  for (const Diagnostic& diagnostic : reading.diagnostics) ADD_FAILURE() << ToString(diagnostic);
  return reading.scene.value_or(scene::SceneSpec{});
}

inline scene::ObjectSpec MustReadObject(std::string_view object) {
  const scene::SceneSpec scene = MustRead(SceneText(object));
  EXPECT_EQ(scene.objects.size(), 1u);
  return scene.objects.empty() ? scene::ObjectSpec{} : scene.objects[0];
}

/// Findings in a text with faults, a line each.
inline std::vector<std::string> FaultsOf(std::string_view text,
                                         const SceneReaderOptions& options = {}) {
  const SceneReading reading = ReadSceneText(text, "test.xml", options);
  EXPECT_FALSE(reading.scene.has_value());
  std::vector<std::string> lines;
  for (const Diagnostic& diagnostic : reading.diagnostics) {
    EXPECT_GE(diagnostic.line, 1);
    lines.push_back(ToString(diagnostic));
  }
  return lines;
}

/// The one fault of a text that has exactly one.
inline std::string FaultOf(std::string_view text, const SceneReaderOptions& options = {}) {
  const std::vector<std::string> faults = FaultsOf(text, options);
  EXPECT_EQ(faults.size(), 1u) << testing::PrintToString(faults);
  return faults.empty() ? "" : faults[0];
}

}  // namespace smile::scene_xml
