#pragma once

#include <vector>

#include "scene_import/foreign_world.h"

namespace smile::scene_import {

// Shapes with the mass of a density of 1 kg/m3: readers multiply by theirs, or set a mass.

/// @param size  full lengths [m].
ForeignShape BlockShape(const Vector3& size);
ForeignShape SphereShape(double radius);
/// @param length  along z of the returned shape's body frame [m].
ForeignShape CylinderShape(double radius, double length);

/// Returns a capsule as a cylinder, which has all its mass, and two spheres.
/// @param length  of the cylinder along z [m].
std::vector<ForeignShape> CapsuleShapes(double radius, double length);

/// Moves shapes to a frame S of their body.
void MoveShapes(const RigidTransform& X_BS, std::vector<ForeignShape>* shapes);

/// True if all lengths are those of a shape that a scene may contain; else adds a fault.
bool AreSpans(std::initializer_list<double> spans, const Place& place, ImportFindings* findings);
/// True if a position is one that a scene may contain; else adds a fault.
bool IsPosition(const Vector3& p, const Place& place, ImportFindings* findings);
/// True for a mass that an object may have; else adds a fault.
bool IsMass(double mass, const Place& place, ImportFindings* findings);

/// Returns the friction of SMILE, whose contacts have the product of two, of one of which two equal
/// ones make that of their contact.
double FrictionOfContact(double contact);

}  // namespace smile::scene_import
