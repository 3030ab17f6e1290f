// Hashes decide whether results of an earlier evaluation are still valid. They cover everything
// that results may depend on: too wide a hash repeats runs in vain, too narrow a one mixes results
// that cannot be compared.

#include "experiment/content_hash.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <stdexcept>
#include <vector>

#include "base/files.h"
#include "base/hash_text.h"
#include "base/state_hash.h"
#include "scene_xml/mesh_files.h"
#include "scene_xml/scene_writer.h"

namespace smile::experiment {
namespace {

namespace fs = std::filesystem;

/// Limits of a folder that is hashed. More indicates a wrong folder, such as the home folder.
constexpr std::size_t kMaxFiles = 100'000;
constexpr std::uintmax_t kMaxBytes = std::uintmax_t{4} << 30;

/// Adds the bytes of a file in pieces, so that large files need little memory.
/// @throws std::runtime_error if it cannot be read.
void AddFile(const fs::path& path, StateHash* hash) {
  std::ifstream file(path, std::ios::binary);
  std::array<char, 1 << 16> buffer;
  while (file) {
    file.read(buffer.data(), buffer.size());
    // The last piece is shorter; reading past the end sets eof and fail.
    hash->Add(std::string_view(buffer.data(), static_cast<std::size_t>(file.gcount())));
  }
  if (!file.eof()) throw std::runtime_error(path.string() + ": cannot be read");
}

/// True for files that a program writes when it runs, which are no part of it.
bool IsLeftOver(const fs::path& path) {
  return path.extension() == ".pyc" || path.filename() == "__pycache__";
}

/// Returns the regular files in a folder and its subfolders. They are sorted, since directories are
/// read in any order.
std::vector<fs::path> FilesBelow(const fs::path& folder) {
  std::vector<fs::path> files;
  std::uintmax_t bytes = 0;
  // Size and number are checked while listing, so that a wrong folder is refused before it is read.
  for (fs::recursive_directory_iterator it(folder), end; it != end; ++it) {
    if (!it->is_regular_file() || IsLeftOver(it->path())) continue;
    files.push_back(it->path());
    bytes += it->file_size();
    if (files.size() > kMaxFiles || bytes > kMaxBytes) {
      throw std::runtime_error(folder.string() + ": contains more than " +
                               std::to_string(kMaxFiles) +
                               " files or 4 GiB, expected a folder of its own");
    }
  }
  std::ranges::sort(files);
  return files;
}

StateHash HashOfFiles(const std::vector<fs::path>& files, const fs::path& folder) {
  StateHash hash;
  for (const fs::path& file : files) {
    // Names are part of the content: renaming a file changes the hash.
    hash.Add(std::string_view(file.lexically_relative(folder).native()));
    AddFile(file, &hash);
  }
  return hash;
}

/// Appends the Python files in a folder, and those of the packages in it, in any order.
void AddModules(const fs::path& folder, std::vector<fs::path>* files) {
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const fs::path& path = entry.path();
    if (entry.is_regular_file() && path.extension() == ".py") files->push_back(path);
    // Not through links, which may lead back here.
    const bool is_package = entry.is_directory() && fs::exists(path / "__init__.py");
    if (is_package && !entry.is_symlink()) AddModules(path, files);
  }
}

StateHash HashOfProgram(const fs::path& brain) {
  if (fs::is_directory(brain)) return HashOfFiles(FilesBelow(brain), brain);
  if (brain.extension() != ".py") return HashOfFiles({brain}, brain.parent_path());
  // A Python program may import any module next to it.
  const fs::path program = fs::absolute(brain);
  std::vector<fs::path> files;
  AddModules(program.parent_path(), &files);
  std::ranges::sort(files);
  // Added once more, so that two programs in one folder have different hashes.
  files.push_back(program);
  return HashOfFiles(files, program.parent_path());
}

}  // namespace

std::string ContentOf(const fs::path& path) {
  if (fs::is_directory(path)) return HashText(HashOfFiles(FilesBelow(path), path).value());
  return HashText(HashOfFiles({path}, path.parent_path()).value());
}

std::string ContentOfBrain(const fs::path& brain) {
  StateHash hash = HashOfProgram(brain);
  AddFile(DataFile("learner/constants.json"), &hash);
  return HashText(hash.value());
}

std::string ContentOf(const scene::SceneSpec& scene) {
  StateHash hash;
  hash.Add(scene_xml::WriteScene(scene));
  for (const scene_xml::MeshFile& file : scene_xml::MeshFilesOf(scene)) {
    hash.Add(std::string_view(file.name));
    const scene::SurfaceMesh& surface = file.mesh->surface;
    // Counts separate what follows, so that no two different meshes give the same sequence of
    // numbers.
    hash.Add(std::uint64_t{surface.vertices.size()});
    for (const Eigen::Vector3f& vertex : surface.vertices) {
      for (float coordinate : vertex) hash.Add(double{coordinate});
    }
    for (const auto& triangle : surface.triangles) {
      for (std::uint32_t corner : triangle) hash.Add(std::uint64_t{corner});
    }
  }
  return HashText(hash.value());
}

std::string ContentOf(const std::vector<robot::RobotFile>& files) {
  StateHash hash;
  for (const robot::RobotFile& file : files) {
    hash.Add(std::string_view(file.name));
    hash.Add(std::string_view(*file.bytes));
  }
  return HashText(hash.value());
}

}  // namespace smile::experiment
