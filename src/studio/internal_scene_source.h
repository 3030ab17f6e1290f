#pragma once

#include <filesystem>
#include <string>

#include "page/request_fields.h"
#include "scene/scene_spec.h"
#include "scene_xml/scene_reader.h"

namespace smile::studio {

/// Scene source: reads the scenes that clients load, those of a folder by name, others from XML
/// text.
class SceneSource {
 public:
  SceneSource(std::filesystem::path scene_folder, scene_xml::SceneReaderOptions reader);

  /// @throws page::RequestError if the folder has no such scene, InputError if it is invalid.
  scene::SceneSpec Named(const std::string& name) const;
  /// Reads the fields `xml` and `name`.
  scene_xml::SceneReading ReadText(const page::RequestFields& fields) const;
  /// Returns the scene of `xml`, or else of `scene`.
  /// @throws as Named().
  scene::SceneSpec SceneOf(const page::RequestFields& fields) const;

 private:
  std::filesystem::path scene_folder_;
  scene_xml::SceneReaderOptions reader_;
};

}  // namespace smile::studio
