#include "scene_import/internal_scene_of_world.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "base/overloaded.h"
#include "base/wording.h"
#include "scene/solid.h"
#include "scene_import/internal_import_table.h"
#include "scene_import/internal_merged_objects.h"
#include "scene_import/internal_shapes.h"
#include "scene_xml/mesh_files.h"

namespace smile::scene_import {
namespace {

// As of the readers of scenes.
constexpr std::size_t kMaxIdLetters = 90;  // and room for a number
constexpr std::size_t kMaxPieces = 4096;
constexpr std::size_t kMaxShapes = 8192;  ///< of an object, with those that are only seen
// Angles of view that a scene's camera may have [rad].
constexpr double kMinView = std::numbers::pi / 180, kMaxView = 170 * std::numbers::pi / 180;
constexpr double kSamePlace = 1e-6;
constexpr double kUsualFriction = 0.6;

/// Ids of a scene: letters, digits and `_`, each given once.
class SceneIds {
 public:
  /// @param most  letters.
  std::string Take(const std::string& name, std::size_t most, const Place& place,
                   ImportFindings* findings) {
    std::string id;
    for (const char letter : name.substr(0, most)) {
      id += std::isalnum(static_cast<unsigned char>(letter)) ? letter : '_';
    }
    if (id.empty()) id = "obj";
    std::string unique = id;
    // Continues to count where the last object of that name did.
    for (int& number = numbers_[id]; !taken_.insert(unique).second;) {
      unique = id + "_" + std::to_string(++number + 1);
    }
    if (unique != name && !name.empty()) {
      findings->Remark(place, "changed: it is called " + unique + " here");
    }
    return unique;
  }
  void Reserve(std::string_view name) { taken_.emplace(name); }

 private:
  std::set<std::string> taken_;
  std::map<std::string, int> numbers_;  // of the last object of each name
};

/// Returns a color with the 8 bits per channel that scene files have.
Color InFileColors(const Color& color) { return ParseColor(ToString(color)).value(); }

bool IsSamePose(const RigidTransform& a, const RigidTransform& b) {
  return (a.translation() - b.translation()).norm() < kSamePlace &&
         (a.rotation() - b.rotation()).norm() < kSamePlace;
}

/// Returns the color of what collides: of what is drawn at its place, else its own if it is seen
/// itself, else of anything that is drawn of the object.
std::optional<Color> ColorOf(const ForeignShape& shape, const MergedObject& object) {
  for (const ForeignShape& drawn : object.shapes) {
    const bool is_same =
        !drawn.collides && drawn.geometry == shape.geometry && IsSamePose(drawn.X_BE, shape.X_BE);
    if (is_same && drawn.is_seen && drawn.color) return drawn.color;
  }
  if (shape.is_seen && shape.color) return shape.color;
  for (const ForeignShape& drawn : object.shapes) {
    if (drawn.is_seen && drawn.color) return drawn.color;
  }
  return shape.color;
}

scene::Shape SceneShapeOf(const ForeignGeometry& geometry) {
  return std::visit(Overloaded{[](const GroundPlane&) { return scene::Shape(); },
                               [](const auto& shape) { return scene::Shape(shape); }},
                    geometry);
}

std::string_view ElementOf(const scene::Shape& shape) {
  constexpr std::array<std::string_view, 3> kSimple{"block", "cylinder", "sphere"};
  if (std::holds_alternative<scene::Custom>(shape)) return "custom";
  return shape.index() < kSimple.size() ? kSimple[shape.index()] : "composite";
}

/// Makes objects, sliders, cameras and light.
class SceneMaker {
 public:
  SceneMaker(const ForeignWorld& foreign, ImportFindings* findings)
      : foreign_(foreign), merged_(MergeBodies(foreign, findings)), findings_(*findings) {}

  scene::SceneSpec Make(const std::string& table) {
    scene_.name = foreign_.name;
    const ImportTable chosen = TakeTable(table, &merged_, &findings_);
    scene_.table = chosen.spec;
    scene_.table.color = InFileColors(chosen.spec.color);
    X_TW_ = chosen.X_WT.inverse();
    for (MergedObject& object : merged_.objects) object.X_WO = OnTable(object.X_WO);
    RemoveBelowTable(&merged_, &findings_);
    for (const std::size_t index : ObjectOrder()) AddObject(index);
    for (const ForeignCamera& camera : foreign_.cameras) AddCamera(camera);
    for (const ForeignLight& light : foreign_.lights) SetLight(light);
    return std::move(scene_);
  }

 private:
  /// Returns the objects in their order, each followed by the one that slides on it.
  std::vector<std::size_t> ObjectOrder() const {
    std::set<std::size_t> sliding;
    for (const MergedSlide& slide : merged_.slides) sliding.insert(slide.second);
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < merged_.objects.size(); ++i) {
      if (sliding.contains(i)) continue;
      order.push_back(i);
      for (const MergedSlide& slide : merged_.slides) {
        if (slide.first == i) order.push_back(slide.second);
      }
    }
    return order;
  }

  /// Returns a pose relative to the table. What stands on a table that was moved stands on it
  /// exactly, whatever the difference of heights rounds to.
  RigidTransform OnTable(const RigidTransform& X_WO) const {
    if (X_TW_ == RigidTransform()) return X_WO;
    const RigidTransform X_TO = X_TW_ * X_WO;
    const Vector3 p = X_TO.translation();
    return {X_TO.rotation(), Vector3((p * 1e9).array().round() / 1e9)};
  }

  void AddObject(std::size_t index) {
    const MergedObject& merged = merged_.objects[index];
    if (merged.shapes.size() > kMaxShapes) {
      return findings_.Refuse(
          merged.place, "found more than " + std::to_string(kMaxShapes) + " shapes in an object");
    }
    RemarkDrawn(merged);
    std::vector<scene::Part> parts = PartsOf(merged);
    if (parts.empty()) {
      if (!merged.shapes.empty() || !merged.is_static) {
        findings_.Remark(merged.place, "left out: nothing of it collides");
      }
      return;
    }
    if (!merged.is_static && !(merged.mass > 0)) {
      return findings_.Refuse(merged.place, "found no mass, expected more than 0 kg");
    }
    if (!IsMass(merged.mass, merged.place, &findings_)) return;
    scene::ObjectSpec object = ObjectOf(merged, std::move(parts));
    if (!IsPosition(object.pose_in_world().translation(), merged.place, &findings_)) return;
    if (scene::NumSolidsOf(object.whole) > kMaxPieces) {
      return findings_.Refuse(merged.place, "found more than " + std::to_string(kMaxPieces) +
                                                " convex pieces in an object");
    }
    RemarkInertia(merged, object);
    AddSlider(index, &object);
    made_[index] = scene_.objects.size();
    scene_.objects.push_back(std::move(object));
  }

  /// Remarks what is drawn but has no collision shape like it.
  void RemarkDrawn(const MergedObject& merged) {
    for (const ForeignShape& drawn : merged.shapes) {
      if (drawn.collides || std::holds_alternative<GroundPlane>(drawn.geometry)) continue;
      const bool has_twin = std::ranges::any_of(merged.shapes, [&](const ForeignShape& shape) {
        return shape.collides && shape.geometry == drawn.geometry &&
               IsSamePose(shape.X_BE, drawn.X_BE);
      });
      if (!has_twin) {
        findings_.Remark(drawn.place, "left out: it is only seen; SMILE shows what collides");
      }
    }
  }

  std::vector<scene::Part> PartsOf(const MergedObject& merged) {
    std::vector<scene::Part> parts;
    for (const ForeignShape& shape : merged.shapes) {
      if (!shape.collides) continue;
      if (std::holds_alternative<GroundPlane>(shape.geometry)) {
        findings_.Remark(shape.place, "left out: a plane that is not the table");
        continue;
      }
      IsPosition(shape.X_BE.translation(), shape.place, &findings_);
      parts.push_back({.X_PE = shape.X_BE,
                       .color = InFileColors(ColorOf(shape, merged).value_or(Color())),
                       .shape = SceneShapeOf(shape.geometry)});
    }
    return parts;
  }

  scene::ObjectSpec ObjectOf(const MergedObject& merged, std::vector<scene::Part> parts) {
    scene::ObjectSpec object{.mass = merged.is_static ? 0 : merged.mass};
    RigidTransform X_OE;  // of the object's frame in that of its body
    if (parts.size() == 1) {
      if (!IsSamePose(parts[0].X_PE, RigidTransform())) X_OE = parts[0].X_PE;
      object.whole = std::move(parts[0]);
    } else {
      object.whole.shape = scene::Composite{.parts = std::move(parts)};
    }
    object.whole.id = ids_.Take(merged.name, kMaxIdLetters, merged.place, &findings_);
    object.whole.X_PE = merged.X_WO * X_OE;
    if (!merged.is_static) {
      const Vector3 center = X_OE.inverse() * Vector3(merged.moment / merged.mass);
      if (center.norm() > 1e-9) object.center_of_mass = center;
      IsPosition(center, merged.place, &findings_);
    }
    const scene::Shape& shape = object.whole.shape;
    object.descriptions.push_back({"shape", scene_xml::ShapeWordOf(shape, ElementOf(shape))});
    object.surface = SurfaceOf(merged);
    return object;
  }

  /// Returns the surface of the first shape that collides; others are remarked if they differ.
  scene::Surface SurfaceOf(const MergedObject& merged) {
    scene::Surface surface;
    const ForeignShape* first = nullptr;
    for (const ForeignShape& shape : merged.shapes) {
      if (!shape.collides) continue;
      if (first && (first->friction != shape.friction || first->rolling != shape.rolling ||
                    first->restitution != shape.restitution)) {
        findings_.Remark(shape.place,
                         "changed: an object has one surface, that of its first shape");
      }
      if (!first) first = &shape;
    }
    if (!first) return surface;
    surface.friction = first->friction.value_or(kUsualFriction);
    surface.restitution = first->restitution.value_or(0);
    const bool is_round = std::ranges::any_of(merged.shapes, [](const ForeignShape& shape) {
      return shape.collides && !std::holds_alternative<scene::Block>(shape.geometry);
    });
    if (first->rolling && (is_round || *first->rolling > 0)) {
      surface.rolling_friction = first->rolling;
    }
    return surface;
  }

  void RemarkInertia(const MergedObject& merged, const scene::ObjectSpec& object) {
    if (!merged.inertia || object.is_static()) return;
    const auto solids = scene::SolidsOf(object.whole);
    const Matrix3 made =
        scene::MassPropertiesOf(solids, object.mass, object.center_of_mass).inertia;
    const Matrix3 R = object.pose_in_world().rotation().transpose() * merged.X_WO.rotation();
    const Matrix3 written = R * *merged.inertia * R.transpose();
    if ((made - written).norm() <= 0.01 * written.norm()) return;
    findings_.Remark(merged.place,
                     "changed: its inertia; SMILE spreads the mass evenly over the shapes");
  }

  /// Adds the slider by which an object slides on the one before it.
  void AddSlider(std::size_t index, scene::ObjectSpec* object) {
    for (const MergedSlide& slide : merged_.slides) {
      if (slide.second != index) continue;
      const auto first = made_.find(slide.first);
      if (first == made_.end() || first->second + 1 != scene_.objects.size()) {
        return findings_.Remark(slide.joint.place,
                                "changed: a slide on a body that was left out sets its body free");
      }
      const scene::SliderSpec slider = SliderOf(slide, first->second, *object);
      scene_.objects[first->second].whole.X_PE = slider.pose_of_first();
      object->whole.X_PE = slider.pose_of_second();
      scene_.sliders.push_back(slider);
    }
  }

  scene::SliderSpec SliderOf(const MergedSlide& slide, std::size_t first,
                             const scene::ObjectSpec& second) {
    const ForeignJoint& joint = slide.joint;
    // The offset of a rail counts along -x.
    const Vector3 x = -(X_TW_.rotation() * joint.axis_in_world);
    const RigidTransform X_WA = scene_.objects[first].pose_in_world();
    scene::SliderSpec slider{
        .X_WJ = {Quaternion::FromTwoVectors(Vector3::UnitX(), x), X_WA.translation()},
        .first_object = first,
        .min_offset = *joint.lower,
        .max_offset = *joint.upper,
        .initial_offset = joint.position};
    const RigidTransform X_JO(Vector3(-joint.position, 0, 0));
    slider.X_JA = slider.X_WJ.inverse() * X_WA;
    slider.X_JB = (slider.X_WJ * X_JO).inverse() * second.pose_in_world();
    // A force per speed on a mass takes that fraction of the speed in a second.
    slider.damping = std::clamp(1 - std::exp(-joint.damping / second.mass), 0.0, 1.0);
    return slider;
  }

  void AddCamera(const ForeignCamera& foreign) {
    if (scene_.cameras.size() == scene::kMaxCameras) {
      return findings_.Remark(foreign.place, "left out: a scene has at most " +
                                                 std::to_string(scene::kMaxCameras) + " cameras");
    }
    const RigidTransform X_WC = X_TW_ * foreign.X_WC;
    if (!IsPosition(X_WC.translation(), foreign.place, &findings_)) return;
    scene::CameraSpec camera{.p_WC = X_WC.translation(), .p_WQ = X_WC * Vector3::UnitZ()};
    if (!IsPosition(camera.p_WQ, foreign.place, &findings_)) return;
    camera.up_in_world = -X_WC.rotation().col(1);
    camera.vertical_field_of_view = foreign.vertical_field_of_view;
    if (!(camera.vertical_field_of_view >= kMinView && camera.vertical_field_of_view <= kMaxView)) {
      return findings_.Refuse(foreign.place, "found a field of view beyond 1 to 170 degrees");
    }
    for (const std::string_view taken : scene::kTakenCameraNames) camera_ids_.Reserve(taken);
    const bool begins_well =
        !foreign.name.empty() && std::isalpha(static_cast<unsigned char>(foreign.name[0]));
    camera.id = camera_ids_.Take(begins_well ? foreign.name : "camera_" + foreign.name,
                                 scene::kMaxCameraLetters - 6, foreign.place, &findings_);
    scene_.cameras.push_back(camera);
  }

  /// The first directional light is that of the scene.
  void SetLight(const ForeignLight& light) {
    if (&light != &foreign_.lights.front()) {
      return findings_.Remark(light.place, "left out: a scene has one light");
    }
    const Vector3 d = X_TW_.rotation() * light.direction_in_world;
    const Vector3 usual(0.3, 0.4, -1);
    scene::Lighting& lighting = scene_.lighting;
    if (std::hypot(d.x(), d.y()) > 1e-9) {
      lighting.turn = std::atan2(d.y(), d.x()) - std::atan2(usual.y(), usual.x());
      if (std::abs(lighting.turn) < 1e-9) lighting.turn = 0;
    }
    if (std::abs(d.normalized().z() - usual.normalized().z()) > 1e-3) {
      findings_.Remark(light.place, "changed: light falls at SMILE's usual angle to the table");
    }
    const double strongest = std::max({light.color.red, light.color.green, light.color.blue});
    if (!(strongest > 0)) return;
    lighting.brightness = std::min(std::round(strongest * 1e6) / 1e6, 4.0);
    lighting.color = InFileColors({std::clamp(light.color.red / strongest, 0.0, 1.0),
                                   std::clamp(light.color.green / strongest, 0.0, 1.0),
                                   std::clamp(light.color.blue / strongest, 0.0, 1.0)});
  }

  const ForeignWorld& foreign_;
  MergedWorld merged_;
  ImportFindings& findings_;
  scene::SceneSpec scene_;
  RigidTransform X_TW_;
  SceneIds ids_, camera_ids_;
  std::map<std::size_t, std::size_t> made_;  // index in the scene of each merged object
};

}  // namespace

scene::SceneSpec SceneOfWorld(const ForeignWorld& world, const std::string& table,
                              ImportFindings* findings) {
  return SceneMaker(world, findings).Make(table);
}

}  // namespace smile::scene_import
