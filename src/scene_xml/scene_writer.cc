#include "scene_xml/scene_writer.h"

#include "scene_xml/internal_mechanism_writer.h"
#include "scene_xml/internal_part_writer.h"
#include "scene_xml/internal_scene_element.h"
#include "scene_xml/internal_xml_text.h"
#include "scene_xml/mesh_files.h"
#include "scene_xml/value_ranges.h"

// Writes a scene as one self-contained file: templates are expanded, includes inserted, ids final.
// Reading it returns the same SceneSpec, and objects keep their order, on which indices depend.

namespace smile::scene_xml {
namespace {

/// Writer of the top level: objects, and mechanisms made of consecutive objects.
class ElementWriter {
 public:
  ElementWriter(const scene::SceneSpec& scene, std::span<const std::string> origins, XmlText* text)
      : scene_(scene), origins_(origins), text_(*text) {}

  void WriteAll() {
    for (std::size_t i = 0; i < scene_.objects.size();) i += WriteAt(i);
  }

 private:
  /// Returns the mechanism that begins with the object; nullptr if none does. Mechanisms are in the
  /// order of their objects, so `next` advances once per mechanism.
  template <class Mechanism>
  static const Mechanism* Beginning(std::size_t object, const std::vector<Mechanism>& mechanisms,
                                    std::size_t* next) {
    if (*next == mechanisms.size() || mechanisms[*next].first_object != object) return nullptr;
    return &mechanisms[(*next)++];
  }

  /// @returns the number of objects of the element.
  std::size_t WriteAt(std::size_t i) {
    // Only the first object of a mechanism gets a comment; the others come from the same element.
    if (i < origins_.size()) text_.Comment(origins_[i]);
    if (const auto* slider = Beginning(i, scene_.sliders, &next_slider_)) {
      WriteSlider(*slider, scene_.objects.at(i), scene_.objects.at(i + 1), &text_);
      return 2;
    }
    if (const auto* chain = Beginning(i, scene_.chains, &next_chain_)) {
      WriteChain(*chain, &text_);
      return 2 + chain->link_ids.size();
    }
    WriteObject(scene_.objects[i], scene_.objects[i].whole.X_PE, &text_);
    return 1;
  }

  const scene::SceneSpec& scene_;
  std::span<const std::string> origins_;
  XmlText& text_;
  std::size_t next_slider_ = 0, next_chain_ = 0;
};

/// Writes what differs from a plain white table: programs older than these attributes refuse them.
void WriteTableLook(const scene::TableSpec& table, XmlText* text) {
  if (table.color != scene::TableSpec().color) text->Attribute("color", ToString(table.color));
  if (table.pattern == scene::TablePattern::kPlain) return;
  text->Attribute("pattern", kTablePatterns[static_cast<std::size_t>(table.pattern)]);
  text->Attribute("patternColor", ToString(table.pattern_color));
  text->Length("patternSpan", table.pattern_span);
}

void WriteLighting(const scene::Lighting& lighting, XmlText* text) {
  const scene::Lighting usual;
  if (lighting == usual) return;
  text->Open("lighting");
  if (lighting.brightness != usual.brightness) text->Number("brightness", lighting.brightness);
  if (lighting.color != usual.color) text->Attribute("color", ToString(lighting.color));
  if (lighting.turn != usual.turn) text->Angle("turn", lighting.turn);
  if (lighting.background) text->Attribute("background", ToString(*lighting.background));
  text->Close();
}

void WriteOffset(const scene::CameraOffset& offset, XmlText* text) {
  text->Open("cameraOffset");
  text->Attribute("camera", offset.camera);
  text->Pose(offset.X_CD);
  if (offset.view_angle_scale != 1) text->Number("fovScale", offset.view_angle_scale);
  text->Close();
}

void WriteCamera(const scene::CameraSpec& camera, XmlText* text) {
  text->Open("camera");
  text->Attribute("id", camera.id);
  text->Point("location", camera.p_WC);
  text->Point("target", camera.p_WQ);
  if (camera.up_in_world != scene::CameraSpec().up_in_world) {
    text->Direction("up", camera.up_in_world);
  }
  text->Angle("fov", camera.vertical_field_of_view);
  text->Close();
}

}  // namespace

std::string WriteScene(const scene::SceneSpec& scene, std::span<const std::string> origins,
                       MeshNames mesh_names) {
  XmlText text(scene.meters_per_unit,
               mesh_names == MeshNames::kBeside ? MeshFilesOf(scene) : std::vector<MeshFile>());
  text.Open("tabletop");
  text.Attribute("xmlns", kSceneNamespace);
  text.Length("xspan", scene.table.x_span);
  text.Length("yspan", scene.table.y_span);
  // Written only if it differs from the default, since programs older than this attribute refuse
  // it.
  if (scene.meters_per_unit != scene::kMetersPerUnit) {
    text.Number("metersPerUnit", scene.meters_per_unit);
  }
  WriteTableLook(scene.table, &text);
  ElementWriter(scene, origins, &text).WriteAll();
  // After the objects: cameras have an order of their own.
  for (const scene::CameraSpec& camera : scene.cameras) WriteCamera(camera, &text);
  for (const scene::CameraOffset& offset : scene.camera_offsets) WriteOffset(offset, &text);
  WriteLighting(scene.lighting, &text);
  text.Close();
  return text.Take();
}

}  // namespace smile::scene_xml
