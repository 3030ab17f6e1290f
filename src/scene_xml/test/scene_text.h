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

/// What is said about a text with faults, a line each.
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
