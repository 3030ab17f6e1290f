#include "classic_input.h"

#include <algorithm>
#include <vector>

#include "base/diagnostic.h"
#include "classic/placeholder_objects.h"
#include "scene_xml/scene_reader.h"
#include "scene_xml/scene_writer.h"

namespace smile::fuzz {

classic::ClassicRecording ReadSegments(std::string_view text) {
  std::vector<classic::ClassicText> texts;
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t end = std::min(text.find('\f', start), text.size());
    texts.push_back(
        {std::to_string(texts.size()) + ".txt", std::string(text.substr(start, end - start))});
    start = end + 1;
  }
  return classic::ReadClassicTexts(texts);
}

std::string FaultWithClassic(std::string_view text) {
  scene::SceneSpec scene;
  try {
    scene = classic::MakePlaceholders(ReadSegments(text));
  } catch (const InputError& error) {
    for (const Diagnostic& finding : error.diagnostics()) {
      if (!finding.file.ends_with(".txt")) return "refused without a place";
      if (finding.message.empty()) return "refused without a reason";
    }
    return {};
  }
  const auto reading = scene_xml::ReadSceneText(scene_xml::WriteScene(scene), "placeholders.xml");
  if (!reading.scene)
    return "placeholder objects are no scene: " + ToString(reading.diagnostics.front());
  return reading.scene->objects == scene.objects ? "" : "placeholder objects come back as others";
}

}  // namespace smile::fuzz
