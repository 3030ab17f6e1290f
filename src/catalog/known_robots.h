#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "robot/robot_model.h"

namespace smile::catalog {

/// Returns the content hash of a URDF: any other byte gives another hash.
std::string UrdfHash(std::string_view text);

/// Returns the hash of what determines how a robot moves: the names of its joints, and for each its
/// type (a continuous joint is a revolute one), the joint that carries it, its origin in the link
/// of that joint (with fixed joints between them folded in), its axis, and the joint that it
/// mimics.
///
/// Positions are rounded to 0.01 mm, and directions to 1e-4, which joins descriptions that write pi
/// with four decimals or more. Not included are limits, masses, shapes, materials, and names of
/// links: descriptions of one robot differ in these, from release to release and by the options
/// they were made with.
std::string KinematicsHash(const robot::RobotModel& model);

/// A side file that ships for a description.
struct KnownRobot {
  /// What the description has in common with those that the side file was made for.
  enum class Match { kContent, kKinematics };

  std::filesystem::path side_file;
  Match match = Match::kContent;

  bool operator==(const KnownRobot&) const = default;
};

/// Returns the words for a match: `by its content`, `by its kinematics`.
std::string_view WordsFor(KnownRobot::Match match);

/// Finds the side file in `robots/known` for a description: the one whose `urdf_hashes` contain its
/// content hash, or otherwise the first one whose `kinematics_hashes` contain its kinematics hash
/// and which fits, so that all its names exist and its poses are within limits.
/// @returns nullopt if there is none, or the file is not a URDF.
/// @throws std::runtime_error if a file cannot be read.
std::optional<KnownRobot> FindKnownRobot(const std::filesystem::path& urdf);

}  // namespace smile::catalog
