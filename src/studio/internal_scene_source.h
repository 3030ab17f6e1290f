#pragma once

#include <filesystem>
#include <string>

#include "page/request_fields.h"
#include "scene/scene_spec.h"
#include "scene_xml/scene_reader.h"

namespace smile::studio {

/// The scenes that pages may ask for: those of a gallery by name, and any as XML text.
class SceneSource {
 public:
  SceneSource(std::filesystem::path gallery, scene_xml::SceneReaderOptions reader);

  /// @throws page::RequestError if the gallery has no such scene, InputError if it is wrong.
  scene::SceneSpec Named(const std::string& name) const;
  /// Reads the fields `xml` and `name`.
  scene_xml::SceneReading ReadText(const page::RequestFields& fields) const;
  /// Returns the scene of `xml`, or else of `scene`.
  /// @throws as Named().
  scene::SceneSpec SceneOf(const page::RequestFields& fields) const;

 private:
  std::filesystem::path gallery_;
  scene_xml::SceneReaderOptions reader_;
};

}  // namespace smile::studio
