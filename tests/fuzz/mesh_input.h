#pragma once

#include <string>
#include <string_view>

#include "scene/custom_mesh.h"

namespace smile::fuzz {

/// Imports a mesh from bytes of which the first chooses the format (0 STL, 1 OBJ, 2 DAE, 3 glTF,
/// 4 GLB) and the rest is the file, with limits that keep one input to a fraction of a second.
/// Whatever other file it names is there, a small one.
/// @throws InputError when it is no mesh.
scene::SurfaceMesh ImportHostileMesh(std::string_view bytes);

/// What is wrong with how we take these bytes, in words; empty when all is well.
///
/// Invalid bytes are refused with a reason. A mesh has numbers and corners that exist, comes
/// back from an STL file the same, and a small one can be felt: convex pieces of finite size.
std::string FaultWithMesh(std::string_view bytes);

}  // namespace smile::fuzz
