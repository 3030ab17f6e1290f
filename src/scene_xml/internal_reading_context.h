#pragma once

#include "scene/scene_spec.h"
#include "scene_xml/internal_findings.h"
#include "scene_xml/internal_id_registry.h"
#include "scene_xml/internal_mesh_cache.h"
#include "scene_xml/internal_references.h"

namespace smile::scene_xml {

/// State that the readers of a scene's elements share.
struct ReadingContext {
  Findings* findings = nullptr;
  IdRegistry ids;
  References references;
  MeshCache* meshes = nullptr;
  double meters_per_unit = scene::kMetersPerUnit;
};

}  // namespace smile::scene_xml
