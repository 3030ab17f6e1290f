#include "scene_xml/internal_camera_reader.h"

#include <algorithm>
#include <string>

#include "base/wording.h"
#include "math/angles.h"
#include "scene_xml/internal_attribute_reader.h"
#include "scene_xml/internal_element_choice.h"
#include "scene_xml/internal_letters.h"
#include "scene_xml/value_ranges.h"

namespace smile::scene_xml {
namespace {

/// Sine of the angle below which two directions count as parallel.
constexpr double kParallel = 1e-6;

/// Checks that the id is valid, no built-in camera has it, and no other camera of the scene has it.
void CheckName(const std::string& id, const std::vector<scene::CameraSpec>& cameras,
               AttributeReader* attributes) {
  // A faulty id was replaced by an empty one, which must not be examined.
  if (attributes->has_findings()) return;
  if (IsDigit(id[0]) || id.size() > scene::kMaxCameraLetters) {
    attributes->Refuse("id", "a letter first, and at most " +
                                 std::to_string(scene::kMaxCameraLetters) + " characters");
  } else if (std::ranges::find(scene::kTakenCameraNames, id) != scene::kTakenCameraNames.end()) {
    attributes->Refuse("id",
                       "none of " + OneOf(scene::kTakenCameraNames) + ", which are predefined");
  } else if (std::ranges::find(cameras, id, &scene::CameraSpec::id) != cameras.end()) {
    attributes->Refuse("id", "one that no other camera has");
  }
}

/// Checks that the view direction exists and is not parallel to `up`, as its rotation about itself
/// would be undefined.
void CheckViewDirection(const scene::CameraSpec& camera, AttributeReader* attributes) {
  if (attributes->has_findings()) return;
  const Vector3 view_direction = camera.p_WQ - camera.p_WC;
  if (!(view_direction.norm() > 0)) {
    attributes->Refuse("target", "another place than location");
  } else if (attributes->Text("up") &&
             view_direction.normalized().cross(camera.up_in_world.normalized()).norm() <
                 kParallel) {
    attributes->Refuse("up", "another direction than that from location to target");
  }
}

}  // namespace

void ReadCamera(const SceneElement& element, ReadingContext* reading,
                std::vector<scene::CameraSpec>* cameras) {
  AttributeReader attributes(element, reading);
  scene::CameraSpec camera{.id = attributes.RequiredName("id")};
  CheckName(camera.id, *cameras, &attributes);
  camera.p_WC = attributes.Point("location");
  camera.p_WQ = attributes.Point("target");
  camera.up_in_world = attributes.Direction("up", camera.up_in_world);
  // Without the attribute the default of CameraSpec holds, to the last bit.
  if (attributes.Text("fov")) {
    camera.vertical_field_of_view =
        DegreesToRadians(attributes.Number("fov", 60, kFieldOfViewDegrees));
  }
  CheckViewDirection(camera, &attributes);
  attributes.RefuseUnknown();
  RefuseContent(element, reading);
  if (attributes.has_findings()) return;
  // Reported at the first camera too many; later ones repeat it.
  if (cameras->size() == scene::kMaxCameras) {
    return attributes.AddFinding("found one camera more than " +
                                 std::to_string(scene::kMaxCameras));
  }
  cameras->push_back(std::move(camera));
}

void ReadCameraOffset(const SceneElement& element, ReadingContext* reading,
                      std::vector<scene::CameraOffset>* offsets) {
  AttributeReader attributes(element, reading);
  // Whether there is such a camera depends on the robot, which a scene does not know.
  scene::CameraOffset offset{.camera = attributes.RequiredName("camera"),
                             .X_CD = attributes.PoseOrOrigin(),
                             .view_angle_scale = attributes.Number("fovScale", 1, kViewScale)};
  if (!attributes.has_findings() &&
      std::ranges::find(*offsets, offset.camera, &scene::CameraOffset::camera) != offsets->end()) {
    attributes.Refuse("camera", "one that no other offset displaces");
  }
  attributes.RefuseUnknown();
  RefuseContent(element, reading);
  if (attributes.has_findings()) return;
  if (offsets->size() == scene::kMaxCameras) {
    return attributes.AddFinding("found one offset more than " +
                                 std::to_string(scene::kMaxCameras));
  }
  offsets->push_back(std::move(offset));
}

}  // namespace smile::scene_xml
