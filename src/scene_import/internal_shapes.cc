#include "scene_import/internal_shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/wording.h"
#include "scene_import/internal_source_element.h"

namespace smile::scene_import {

ForeignShape BlockShape(const Vector3& size) {
  return {.geometry = scene::Block{size}, .mass = size.prod()};
}

ForeignShape SphereShape(double radius) {
  return {.geometry = scene::Sphere{radius},
          .mass = 4.0 / 3 * std::numbers::pi * std::pow(radius, 3)};
}

ForeignShape CylinderShape(double radius, double length) {
  return {.geometry = scene::Cylinder{.radius = radius, .length = length},
          .X_BE = CylinderFromZ(),
          .mass = std::numbers::pi * radius * radius * length};
}

std::vector<ForeignShape> CapsuleShapes(double radius, double length) {
  std::vector<ForeignShape> shapes{CylinderShape(radius, length), SphereShape(radius),
                                   SphereShape(radius)};
  shapes[0].mass += shapes[1].mass;  // two halves of a sphere
  shapes[1].mass = shapes[2].mass = 0;
  shapes[1].X_BE = RigidTransform(Vector3(0, 0, length / 2));
  shapes[2].X_BE = RigidTransform(Vector3(0, 0, -length / 2));
  return shapes;
}

void MoveShapes(const RigidTransform& X_BS, std::vector<ForeignShape>* shapes) {
  for (ForeignShape& shape : *shapes) shape.X_BE = X_BS * shape.X_BE;
}

bool AreSpans(std::initializer_list<double> spans, const Place& place, ImportFindings* findings) {
  for (const double span : spans) {
    if (span >= kMinSpan && span <= kMaxLength) continue;
    findings->Refuse(place, "found a length of " + NumberText(span) + " m, expected " +
                                NumberText(kMinSpan) + " to " + NumberText(kMaxLength) + " m");
    return false;
  }
  return true;
}

bool IsPosition(const Vector3& p, const Place& place, ImportFindings* findings) {
  if (p.allFinite() && p.cwiseAbs().maxCoeff() <= kMaxLength) return true;
  findings->Refuse(place, "found a position beyond " + NumberText(kMaxLength) + " m of the origin");
  return false;
}

bool IsMass(double mass, const Place& place, ImportFindings* findings) {
  if (mass >= 0 && mass <= kMaxMass) return true;
  findings->Refuse(place, "found a mass of " + NumberText(mass) + " kg, expected 0 to " +
                              NumberText(kMaxMass) + " kg");
  return false;
}

double FrictionOfContact(double contact) { return std::sqrt(std::clamp(contact, 0.0, 100.0)); }

}  // namespace smile::scene_import
