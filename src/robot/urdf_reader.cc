#include "robot/urdf_reader.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "base/diagnostic.h"
#include "base/files.h"
#include "base/json.h"
#include "base/wording.h"
#include "robot/internal_model_builder.h"
#include "robot/internal_robot_file_set.h"
#include "robot/internal_side_file.h"

namespace smile::robot {
namespace {

using internal::FoundFile;
using internal::Mounting;
using internal::RobotFileSet;
using internal::SideFile;
using internal::UrdfDocument;
using internal::UrdfPart;

constexpr std::size_t kMaxUrdfBytes = 4 << 20, kMaxSideFileBytes = 1 << 20;

/// Disables collisions between all pairs of links, for a robot without a side file: links that
/// touch by construction are unknown, and overlapping links would keep physics busy. No joint moves
/// anyway.
void IgnoreLinkCollisions(RobotModel* model) {
  for (int second = 0; second < model->num_joints(); ++second) {
    for (int first = -1; first < second; ++first) model->never_collide.emplace_back(first, second);
  }
  std::ranges::sort(model->never_collide);
}

/// Reads the parts of grippers, each file once.
class PartReader {
 public:
  PartReader(const SideFile& side_file, const FoundFile& from, RobotFileSet* files)
      : side_file_(side_file), from_(from), files_(*files) {}

  UrdfPart Read(const Mounting& mounting) {
    auto entry = documents_.find(mounting.urdf);
    // Both arms usually have the same gripper.
    if (entry == documents_.end()) {
      const FoundFile file = Fetch(mounting);
      entry = documents_
                  .emplace(mounting.urdf, std::pair(file, std::make_shared<const UrdfDocument>(
                                                              *file.bytes, file.path.string())))
                  .first;
    }
    const auto& [file, document] = entry->second;
    return {file, document, mounting.prefix, mounting.to};
  }

 private:
  FoundFile Fetch(const Mounting& mounting) {
    try {
      return files_.Fetch(from_, mounting.urdf, kMaxUrdfBytes);
    } catch (const internal::BadReference& error) {
      side_file_.Fail(mounting.place + "/urdf", "found " + Quoted(mounting.urdf) + error.what());
    }
  }

  const SideFile& side_file_;
  const FoundFile& from_;
  RobotFileSet& files_;
  std::map<std::string, std::pair<FoundFile, std::shared_ptr<const UrdfDocument>>> documents_;
};

/// Refuses joints without limits of speed or effort, neither in the URDF nor in the side file.
void CheckLimits(const RobotModel& model, const std::vector<UrdfPart>& parts) {
  for (const scene::LinkSpec& link : model.links) {
    if (std::isfinite(link.max_velocity) && std::isfinite(link.max_effort)) continue;
    for (const UrdfPart& part : parts) {
      if (!link.joint_name.starts_with(part.prefix)) continue;
      const std::string name = link.joint_name.substr(part.prefix.size());
      if (!part.document->model().getJoint(name)) continue;
      part.document->Fail("joint", name,
                          "has no <limit>, expected velocity and effort, here or as limits in a "
                          "side file");
    }
  }
}

/// Reads a robot in this order: side file for the attached parts, then the model of all parts, then
/// the rest of the side file.
RobotReading Read(const FoundFile& urdf, const RobotReaderOptions& options, RobotFileSet* files) {
  // The URDF is the first of the kept files.
  files->Keep(urdf);
  std::vector<UrdfPart> parts{
      {urdf, std::make_shared<const UrdfDocument>(*urdf.bytes, urdf.path.string()), "", ""}};
  const std::optional<FoundFile> side = files->FetchSideFile(urdf, kMaxSideFileBytes);
  std::optional<SideFile> side_file;
  std::vector<Mounting> mountings;
  if (side) {
    side_file.emplace(*side, options.gripper);
    mountings = side_file->Mountings();
    PartReader reader(*side_file, *side, files);
    for (const Mounting& mounting : mountings) parts.push_back(reader.Read(mounting));
  } else if (!options.gripper.empty()) {
    throw InputError(
        {urdf.path.string(), 0, "",
         "has no side file that offers grippers, found the choice " + Quoted(options.gripper)});
  }
  internal::BuiltModel built = internal::BuildModel(parts, options.has_shapes, files);
  // Part 0 is the robot itself.
  for (std::size_t i = 0; i < mountings.size(); ++i) {
    // A part whose link does not exist was never attached.
    if (built.is_used[i + 1]) continue;
    side_file->Fail(mountings[i].place, "would be attached to " + Quoted(mountings[i].to) +
                                            ", expected the name of a link");
  }
  if (side_file) {
    side_file->Apply(&built, options.has_appearance);
  } else {
    IgnoreLinkCollisions(&built.model);
  }
  CheckLimits(built.model, parts);
  return {.model = std::move(built.model),
          .has_side_file = side.has_value(),
          .gripper = side_file ? side_file->gripper() : "",
          .gap = side_file ? side_file->Place("gap") : std::nullopt,
          .height = side_file ? side_file->Place("height") : std::nullopt,
          .files = files->TakeFiles()};
}

/// Returns the name for a kept URDF. Recordings store it in JSON, so a name that is not UTF-8 is
/// replaced.
std::string NameOfKept(const std::filesystem::path& urdf_path) {
  // ToText() replaces invalid UTF-8, so the name changes if it has any.
  const Json name = urdf_path.filename().string();
  return ParseJson(ToText(name)) == name ? name.get<std::string>() : "robot.urdf";
}

FoundFile UrdfAt(const std::filesystem::path& path, std::string bytes) {
  return {NameOfKept(path), path, std::make_shared<const std::string>(std::move(bytes))};
}

}  // namespace

RobotReading LoadRobot(const std::filesystem::path& urdf_path, const RobotReaderOptions& options) {
  RobotFileSet files(internal::MakeOriginalFinder(urdf_path, options));
  return Read(UrdfAt(urdf_path, ReadFile(urdf_path, kMaxUrdfBytes)), options, &files);
}

RobotModel ReadRobot(const std::filesystem::path& urdf_path, const RobotReaderOptions& options) {
  return LoadRobot(urdf_path, options).model;
}

RobotReading LoadKeptRobot(const std::filesystem::path& urdf_path, const std::string& gripper,
                           const OpenRobotFile& open) {
  RobotFileSet files(internal::MakeKeptFinder(open));
  std::optional<std::string> bytes = open(urdf_path.filename().string(), kMaxUrdfBytes);
  if (!bytes) throw InputError({urdf_path.string(), 0, "", "no such file"});
  return Read(UrdfAt(urdf_path, *std::move(bytes)), {.gripper = gripper}, &files);
}

}  // namespace smile::robot
