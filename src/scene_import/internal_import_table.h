#pragma once

#include <string>

#include "scene/scene_spec.h"
#include "scene_import/internal_merged_objects.h"

namespace smile::scene_import {

/// Table of an imported world, and where its top is.
struct ImportTable {
  scene::TableSpec spec;
  RigidTransform X_WT;  ///< T: center of the top, z up
};

/// Chooses the table of a world and removes its shape: the one that is named, else the largest
/// horizontal static box whose name contains `table`, else the ground.
/// @throws InputError if no static horizontal box or plane has that name.
ImportTable TakeTable(const std::string& name, MergedWorld* world, ImportFindings* findings);

/// Removes static shapes that lie wholly below the top of the table, where SMILE has the table and
/// the floor.
/// @param world  already placed, with T as its origin.
void RemoveBelowTable(MergedWorld* world, ImportFindings* findings);

}  // namespace smile::scene_import
