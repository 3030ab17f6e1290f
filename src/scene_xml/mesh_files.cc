#include "scene_xml/mesh_files.h"

#include <algorithm>
#include <set>
#include <variant>

// Names of the mesh files that are written beside a scene. The original files may have any format,
// name and place; copies are STL files with plain names.

namespace smile::scene_xml {
namespace {

/// Collects the distinct meshes of a scene, in the order of their first use.
class MeshFileCollector {
 public:
  void Append(const scene::Part& part) {
    if (const auto* custom = std::get_if<scene::Custom>(&part.shape)) {
      Add(*custom);
    } else if (const auto* composite = std::get_if<scene::Composite>(&part.shape)) {
      for (const scene::Part& child : composite->parts) Append(child);
    } else if (const auto* control = std::get_if<scene::CustomControl>(&part.shape)) {
      for (const auto& state : control->states) {
        for (const scene::Part& child : state.parts) Append(child);
      }
    }
  }

  std::vector<MeshFile> Take() { return std::move(files_); }

 private:
  void Add(const scene::Custom& custom) {
    // Identity of the shared mesh, not equality: comparing triangles would be slow.
    const auto is_same = [&](const MeshFile& file) { return file.mesh == custom.mesh; };
    if (std::ranges::any_of(files_, is_same)) return;
    const std::string word = TameNameOf(custom.file);
    std::string name = word + ".stl";
    // Different files may have the same last name, or names that differ only in replaced letters.
    for (int number = 2; !names_.insert(name).second; ++number) {
      name = word + "_" + std::to_string(number) + ".stl";
    }
    files_.push_back({name, custom.mesh});
  }

  /// Returns a name that is valid on every file system: other letters become `_`.
  static std::string TameNameOf(const std::string& file) {
    constexpr std::size_t kMaxLength = 60;
    std::string name = WordOfMeshFile(file).substr(0, kMaxLength);
    for (char& letter : name) {
      const bool is_tame = (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
                           (letter >= '0' && letter <= '9') || letter == '-';
      if (!is_tame) letter = '_';
    }
    return name.empty() ? "mesh" : name;
  }

  std::vector<MeshFile> files_;
  std::set<std::string> names_;
};

}  // namespace

std::vector<MeshFile> MeshFilesOf(const scene::SceneSpec& scene) {
  MeshFileCollector collector;
  for (const scene::ObjectSpec& object : scene.objects) collector.Append(object.whole);
  return collector.Take();
}

std::string WordOfMeshFile(std::string_view file) {
  const std::size_t slash = file.rfind('/');
  if (slash != std::string_view::npos) file.remove_prefix(slash + 1);
  // Up to the first dot: `gear.v2.obj` is a `gear`.
  return std::string(file.substr(0, file.find('.')));
}

std::string ShapeWordOf(const scene::Shape& shape, std::string_view element) {
  const auto* custom = std::get_if<scene::Custom>(&shape);
  return custom ? WordOfMeshFile(custom->file) : std::string(element);
}

}  // namespace smile::scene_xml
