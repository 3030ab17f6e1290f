#include "catalog/known_robots.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "base/diagnostic.h"
#include "base/files.h"
#include "base/hash_text.h"
#include "base/json.h"
#include "base/state_hash.h"
#include "catalog/internal_robot_folders.h"
#include "robot/urdf_reader.h"

// Two keys lead to a side file in `robots/known/`. The content hash is exact, but descriptions of
// one robot differ in comments, meshes and masses; the kinematics hash is what they share.

namespace smile::catalog {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxUrdfBytes = 4 << 20, kMaxSideFileBytes = 1 << 20;

/// Sizes of the cells into which numbers are rounded: lengths [m], and parts of directions, of
/// which a rotation of 1.5708 instead of pi/2 changes some by 4e-6.
constexpr double kLengthCell = 1e-5, kDirectionCell = 1e-4;

/// Adds a number, rounded. The limits between cells are aside from all numbers of few decimals, as
/// descriptions have them: otherwise a last bit could decide to which side such a number belongs.
void AddRounded(double number, double cell, StateHash* hash) {
  constexpr double kAside = 0.5437;
  hash->Add(
      static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(number / cell + kAside))));
}

bool Contains(const Json& side_file, const char* member, const std::string& hash) {
  const Json hashes = side_file.value(member, Json::array());
  return std::ranges::find(hashes, Json(hash)) != hashes.end();
}

/// Returns true if a side file fits a description of the same kinematics.
bool FitsKinematics(const fs::path& urdf, const fs::path& file, const Json& side_file) {
  if (!side_file.contains("kinematics_hashes")) return false;
  try {
    const robot::RobotModel model =
        robot::ReadRobot(urdf, {.side_file = file, .has_appearance = false, .has_shapes = false});
    return Contains(side_file, "kinematics_hashes", KinematicsHash(model));
  } catch (const InputError&) {
    // Other names or limits, or no URDF at all, which the next reader of the file reports.
    return false;
  }
}

}  // namespace

std::string UrdfHash(std::string_view text) {
  StateHash hash;
  hash.Add(text);
  return HashText(hash.value());
}

std::string KinematicsHash(const robot::RobotModel& model) {
  // By name, since the order of links may depend on the names of fixed joints between them.
  std::vector<const scene::LinkSpec*> links;
  for (const scene::LinkSpec& link : model.links) links.push_back(&link);
  std::ranges::sort(links, {}, &scene::LinkSpec::joint_name);
  const auto name_of = [&](int joint) {
    return joint < 0 ? std::string() : model.links[static_cast<std::size_t>(joint)].joint_name;
  };
  StateHash hash;
  for (const scene::LinkSpec* link : links) {
    hash.Add(std::string_view(link->joint_name));
    hash.Add(static_cast<std::uint64_t>(link->joint_type));
    hash.Add(std::string_view(name_of(link->parent)));
    for (double part : link->X_PJ.translation()) AddRounded(part, kLengthCell, &hash);
    for (double part : link->X_PJ.rotation().reshaped()) AddRounded(part, kDirectionCell, &hash);
    for (double part : link->axis) AddRounded(part, kDirectionCell, &hash);
    if (!link->mimic) continue;
    hash.Add(std::string_view(name_of(link->mimic->leader)));
    AddRounded(link->mimic->multiplier, kDirectionCell, &hash);
    AddRounded(link->mimic->offset, kDirectionCell, &hash);
  }
  return HashText(hash.value());
}

std::string_view WordsFor(KnownRobot::Match match) {
  return match == KnownRobot::Match::kContent ? "by its content" : "by its kinematics";
}

std::optional<KnownRobot> FindKnownRobot(const fs::path& urdf) {
  const std::string hash = UrdfHash(ReadFile(urdf, kMaxUrdfBytes));
  std::optional<KnownRobot> found;
  for (const fs::path& file : internal::EntriesOf(internal::ShippedFolder() / "known")) {
    const Json side_file = ParseJson(ReadFile(file, kMaxSideFileBytes));
    if (Contains(side_file, "urdf_hashes", hash)) return KnownRobot{file};
    if (!found && FitsKinematics(urdf, file, side_file)) {
      found = KnownRobot{file, KnownRobot::Match::kKinematics};
    }
  }
  return found;
}

}  // namespace smile::catalog
