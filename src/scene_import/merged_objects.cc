#include <algorithm>

#include "base/wording.h"
#include "scene_import/internal_merged_objects.h"
#include "scene_import/internal_shapes.h"

namespace smile::scene_import {
namespace {

class BodyMerger {
 public:
  BodyMerger(const ForeignWorld& world, ImportFindings* findings)
      : world_(world), findings_(*findings) {}

  MergedWorld Merge() {
    for (const ForeignBody& body : world_.bodies) {
      object_of_.push_back(ObjectFor(body));
      if (object_of_.back() >= 0) AddBody(body, &object(object_of_.back()));
    }
    return std::move(merged_);
  }

 private:
  MergedObject& object(int index) { return merged_.objects[static_cast<std::size_t>(index)]; }

  /// Returns the object that a body is a part of.
  int ObjectFor(const ForeignBody& body) {
    const int parent = body.parent < 0 ? -1 : object_of_[static_cast<std::size_t>(body.parent)];
    if (body.joint.kind == ForeignJointKind::kFree) return Begin(body, false);
    if (body.joint.kind == ForeignJointKind::kSlide && parent >= 0) {
      const std::string fault = FaultOfSlide(body.joint, parent);
      if (fault.empty()) {
        const int index = Begin(body, false);
        merged_.slides.push_back(
            {static_cast<std::size_t>(parent), static_cast<std::size_t>(index), body.joint});
        return index;
      }
      findings_.Remark(body.joint.place, "changed: a slide " + fault + " is fixed");
    } else if (body.joint.kind != ForeignJointKind::kFixed) {
      findings_.Remark(body.joint.place,
                       "changed: SMILE has no joint like this " + Printable(body.joint.word) +
                           (parent < 0 ? " on the world" : "") + ", so its body is fixed");
    }
    return parent >= 0 ? parent : Begin(body, true);
  }

  /// Returns why a slide has no counterpart, in words that follow `a slide`; empty if it has one.
  std::string FaultOfSlide(const ForeignJoint& joint, int parent) const {
    const auto index = static_cast<std::size_t>(parent);
    for (const MergedSlide& slide : merged_.slides) {
      if (slide.first == index) return "on a body that carries another one";
      if (slide.second == index) return "on a body that slides itself";
    }
    if (!joint.lower || !joint.upper) return "without limits";
    const bool is_within = *joint.lower < *joint.upper && joint.position >= *joint.lower &&
                           joint.position <= *joint.upper;
    if (!is_within) return "whose position is not within its limits";
    if (std::max(-*joint.lower, *joint.upper) > 1000) return "of more than 1 km";
    return "";
  }

  int Begin(const ForeignBody& body, bool is_static) {
    merged_.objects.push_back(
        {.place = body.place, .name = body.name, .X_WO = body.X_WB, .is_static = is_static});
    return static_cast<int>(merged_.objects.size()) - 1;
  }

  static void AddBody(const ForeignBody& body, MergedObject* object) {
    const RigidTransform X_OB = object->X_WO.inverse() * body.X_WB;
    ++object->num_bodies;
    if (body.mass) {
      object->mass += body.mass->mass;
      object->moment += body.mass->mass * (X_OB * body.mass->p_BBcm);
      object->inertia = body.mass->inertia;
    }
    std::vector<ForeignShape> shapes = body.shapes;
    MoveShapes(X_OB, &shapes);
    for (ForeignShape& shape : shapes) {
      if (!body.mass) {
        object->mass += shape.mass;
        object->moment += shape.mass * (shape.X_BE * shape.center_of_mass);
      }
      object->shapes.push_back(std::move(shape));
    }
    if (object->num_bodies > 1) object->inertia.reset();
  }

  const ForeignWorld& world_;
  ImportFindings& findings_;
  MergedWorld merged_;
  std::vector<int> object_of_;  // for each body
};

}  // namespace

MergedWorld MergeBodies(const ForeignWorld& world, ImportFindings* findings) {
  return BodyMerger(world, findings).Merge();
}

}  // namespace smile::scene_import
