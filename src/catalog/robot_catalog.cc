#include "catalog/robot_catalog.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <optional>
#include <stdexcept>
#include <system_error>

#include "base/files.h"
#include "base/wording.h"
#include "catalog/internal_robot_folders.h"
#include "catalog/known_robots.h"

// Robots are files: a folder of the user has one folder per robot, and `robots/` those that ship.
// `robots/known/` has side files for descriptions of others, which do not ship.

namespace smile::catalog {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxName = 40;

bool IsName(const std::string& name) {
  const auto is_letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
  return !name.empty() && name.size() <= kMaxName && is_letter(name[0]) &&
         std::ranges::all_of(name, [&](char c) {
           return is_letter(c) || (c >= '0' && c <= '9') || c == '_' || c == '-';
         });
}

}  // namespace

fs::path UserRobotFolder() {
  for (const auto& [variable, below] : {std::pair("XDG_DATA_HOME", "smile/robots"),
                                        std::pair("HOME", ".local/share/smile/robots")}) {
    const char* folder = std::getenv(variable);
    if (folder != nullptr && *folder != '\0') return fs::path(folder) / below;
  }
  throw std::runtime_error("neither XDG_DATA_HOME nor HOME is set, expected a folder for robots");
}

std::vector<CatalogEntry> AllRobots() {
  std::vector<CatalogEntry> robots;
  for (const fs::path& file : internal::EntriesOf(internal::ShippedFolder())) {
    if (file.extension() == ".urdf") {
      robots.push_back({.name = file.stem().string(), .urdf = file, .is_shipped = true});
    }
  }
  for (const fs::path& folder : internal::EntriesOf(UserRobotFolder())) {
    const std::string name = folder.filename().string();
    const fs::path urdf = folder / (name + ".urdf");
    std::error_code error;
    if (IsName(name) && fs::is_regular_file(urdf, error)) {
      robots.push_back({.name = name, .urdf = urdf, .is_shipped = false});
    }
  }
  return robots;
}

RobotSource FindRobot(const std::string& name_or_path) {
  const fs::path path = name_or_path;
  std::error_code error;
  const bool is_path = name_or_path.find('/') != std::string::npos || path.extension() == ".urdf" ||
                       fs::is_regular_file(path, error);
  if (!is_path) {
    const std::vector<CatalogEntry> robots = AllRobots();
    const auto found = std::ranges::find(robots, name_or_path, &CatalogEntry::name);
    if (found != robots.end()) return {.urdf = found->urdf, .side_file = {}};
    std::vector<std::string_view> names;
    for (const CatalogEntry& robot : robots) names.push_back(robot.name);
    throw std::invalid_argument("no robot is called " + Quoted(name_or_path) + ", expected " +
                                OneOf(names) + ", or the path of a URDF" +
                                DidYouMean(name_or_path, names));
  }
  fs::path own = path;
  if (fs::exists(own.replace_extension(".robot.json"), error))
    return {.urdf = path, .side_file = {}};
  const std::optional<KnownRobot> known = FindKnownRobot(path);
  return {.urdf = path, .side_file = known ? known->side_file : fs::path()};
}

void CheckNewName(const std::string& name) {
  if (!IsName(name)) {
    throw std::invalid_argument("the name is " + Quoted(name) +
                                ", expected a letter, then letters, digits, _ or -, " +
                                std::to_string(kMaxName) + " at most");
  }
  for (const CatalogEntry& robot : AllRobots()) {
    if (robot.name != name) continue;
    throw std::invalid_argument("there is a robot " + Quoted(name) + ", " + robot.urdf.string() +
                                ", expected another name");
  }
}

fs::path AddRobot(const std::string& name, const std::vector<robot::RobotFile>& files) {
  const fs::path folder = UserRobotFolder() / name;
  // Complete or not at all: the folder gets its name when all files are in it.
  const fs::path unfinished = UserRobotFolder() / ("." + name + ".unfinished");
  std::error_code error;
  fs::remove_all(unfinished, error);
  const fs::path side_file = fs::path(files.at(0).name).replace_extension(".robot.json");
  for (std::size_t i = 0; i < files.size(); ++i) {
    const std::string file = i == 0                       ? name + ".urdf"
                             : files[i].name == side_file ? name + ".robot.json"
                                                          : files[i].name;
    MakeDirectories((unfinished / file).parent_path());
    WriteFile(unfinished / file, *files[i].bytes);
  }
  fs::rename(unfinished, folder, error);
  if (error) throw std::runtime_error(folder.string() + ": " + error.message());
  return folder;
}

}  // namespace smile::catalog
