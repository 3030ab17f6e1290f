#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <system_error>

#include "base/diagnostic.h"
#include "base/files.h"
#include "base/json.h"
#include "base/wording.h"
#include "robot/internal_robot_file_set.h"

// A robot description refers to other files. There are two ways to find them: OriginalFinder looks
// into the file system, within allowed folders, and gives each file the name under which recordings
// keep it. KeptFinder finds files of a recording by that name only. Both derive the name from the
// reference alone, so a kept robot reads exactly what the original did.

namespace smile::robot::internal {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxReference = 1000;
constexpr std::string_view kPackageScheme = "package://", kFileScheme = "file://";
/// Folders of kept files that are not below the URDF.
constexpr const char* kPackages = "packages";
constexpr const char* kElsewhere = "elsewhere";

/// A parsed reference.
struct Reference {
  enum class Kind { kPackage, kAbsolute, kRelative } kind = Kind::kRelative;
  std::string package;
  fs::path path;  ///< in the package, from the root, or from the folder of the referring file
};

bool HasStepsUp(const fs::path& path) { return std::ranges::find(path, "..") != path.end(); }

/// Parses a reference.
/// @throws BadReference unless it is a package, an absolute or a relative path.
Reference Parse(const std::string& text) {
  if (text.empty() || text.size() > kMaxReference || text.find('\0') != std::string::npos) {
    throw BadReference(": expected the name of a file");
  }
  if (text.starts_with(kPackageScheme)) {
    // package://PACKAGE/PATH, as in ROS.
    const std::string rest = text.substr(kPackageScheme.size());
    const std::size_t slash = rest.find('/');
    const std::string package = rest.substr(0, slash);
    const fs::path path = slash == std::string::npos ? "" : rest.substr(slash + 1);
    if (package.empty() || package == "." || package == ".." || path.empty() ||
        path.is_absolute() || HasStepsUp(path)) {
      // Steps up could leave the package.
      throw BadReference(": expected package://PACKAGE/PATH without ..");
    }
    return {Reference::Kind::kPackage, package, path.lexically_normal()};
  }
  const bool is_url = text.starts_with(kFileScheme);
  if (!is_url && text.find("://") != std::string::npos) {
    throw BadReference(": expected package://, file:// or a path");
  }
  // Any other scheme would need a network or is a mistake.
  const fs::path path = is_url ? text.substr(kFileScheme.size()) : text;
  if (is_url && !path.is_absolute()) throw BadReference(": expected file:///PATH from the root");
  return {path.is_absolute() ? Reference::Kind::kAbsolute : Reference::Kind::kRelative,
          {},
          path.lexically_normal()};
}

/// Returns the name under which a file is kept. It depends on the reference only, not on where the
/// file lies, so that a kept robot finds its own files.
std::string NameOfKept(const FoundFile& from, const Reference& reference) {
  if (reference.kind == Reference::Kind::kPackage) {
    return (fs::path(kPackages) / reference.package / reference.path).string();
  }
  const fs::path place = fs::path(from.name).parent_path() / reference.path;
  const fs::path normal = place.lexically_normal();
  if (reference.kind == Reference::Kind::kRelative && !HasStepsUp(normal)) return normal.string();
  // Outside the folder: steps up become folders named `up`.
  fs::path name = kElsewhere;
  for (const fs::path& step : normal.relative_path()) name /= step == ".." ? "up" : step;
  return name.string();
}

fs::path FolderOf(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

/// Cache of files: a mesh may be referred to thousands of times.
class ReadFiles {
 public:
  /// Returns the bytes of a file.
  /// @param read  reads the bytes or throws; called again if the cached file exceeds the limit.
  std::shared_ptr<const std::string> Get(const fs::path& path, std::size_t max_bytes,
                                         const std::function<std::string()>& read) {
    std::shared_ptr<const std::string>& bytes = files_[path];
    if (!bytes || bytes->size() > max_bytes) bytes = std::make_shared<const std::string>(read());
    return bytes;
  }

 private:
  std::map<fs::path, std::shared_ptr<const std::string>> files_;
};

/// Returns a side file with another `start`; the same one if it does not contain that pose. Faults
/// are found when it is read.
FoundFile WithStart(FoundFile side_file, const std::string& pose) {
  Json root;
  try {
    root = ParseJson(*side_file.bytes);
  } catch (const std::invalid_argument&) {
    return side_file;
  }
  if (!root.is_object() || !root.contains("poses") || !root["poses"].contains(pose)) {
    return side_file;
  }
  root["start"] = pose;
  side_file.bytes = std::make_shared<const std::string>(ToText(root, 2) + "\n");
  return side_file;
}

class OriginalFinder : public FileFinder {
 public:
  OriginalFinder(const fs::path& urdf_path, const RobotReaderOptions& options)
      : kept_(FolderOf(urdf_path)),
        side_file_(options.side_file),
        side_file_text_(options.side_file_text),
        start_pose_(options.start_pose),
        roots_(options.package_roots) {
    allowed_ = roots_;
    allowed_.push_back(kept_);
    if (!side_file_.empty()) allowed_.push_back(FolderOf(side_file_));
  }

  FoundFile Find(const FoundFile& from, const std::string& text, std::size_t max_bytes) override {
    const Reference reference = Parse(text);
    bool is_outside = false;
    for (const fs::path& path : PlacesOf(from, reference)) {
      std::error_code error;
      const fs::path canonical = fs::canonical(path, error);
      if (error) continue;
      if (IsAllowed(canonical)) {
        return {NameOfKept(from, reference), path,
                read_.Get(canonical, max_bytes, [&] { return Read(canonical, max_bytes); })};
      }
      // It exists, but must not be read: the message says so if no other place has it.
      is_outside = true;
    }
    const bool is_package = reference.kind == Reference::Kind::kPackage;
    throw BadReference(
        std::string(is_outside ? " is outside, expected inside " : ": expected a file in ") +
        (is_package ? "a --path folder that contains the folder " + Quoted(reference.package)
                    : "the folder of the robot, in a --path folder or below these"));
  }

  std::optional<FoundFile> FindSideFile(const FoundFile& urdf,
                                        std::size_t max_bytes) const override {
    std::optional<FoundFile> found = FindWrittenSideFile(urdf, max_bytes);
    if (found && !start_pose_.empty()) found = WithStart(*std::move(found), start_pose_);
    return found;
  }

 private:
  std::optional<FoundFile> FindWrittenSideFile(const FoundFile& urdf, std::size_t max_bytes) const {
    // Its kept name is beside the URDF, wherever it lies.
    const std::string name = fs::path(urdf.name).replace_extension(".robot.json").string();
    fs::path path = side_file_;
    if (side_file_text_) {
      path = urdf.path;
      return FoundFile{name, path.replace_extension(".robot.json"),
                       std::make_shared<const std::string>(*side_file_text_)};
    }
    if (path.empty()) {  // not requested by name: links must not lead elsewhere
      path = urdf.path;
      path.replace_extension(".robot.json");
      std::error_code error;
      const fs::path canonical = fs::canonical(path, error);
      if (error) return std::nullopt;
      if (!IsAllowed(canonical)) {
        throw InputError({path.string(), 0, "",
                          "is outside, expected inside the folder of the robot, in a --path folder "
                          "or named by --side-file"});
      }
    }
    return FoundFile{name, path, std::make_shared<const std::string>(ReadFile(path, max_bytes))};
  }
  bool IsAllowed(const fs::path& canonical) const {
    return std::ranges::any_of(allowed_,
                               [&](const fs::path& folder) { return IsWithin(canonical, folder); });
  }
  /// Returns the places to search, in order; the last one is that of a kept robot.
  std::vector<fs::path> PlacesOf(const FoundFile& from, const Reference& reference) const {
    // A recording's own robot folder can thus be read like an original one.
    const fs::path kept = kept_ / NameOfKept(from, reference);
    if (reference.kind == Reference::Kind::kAbsolute) return {reference.path, kept};
    if (reference.kind == Reference::Kind::kRelative) {
      return {FolderOf(from.path) / reference.path, kept};
    }
    std::vector<fs::path> places;
    for (const fs::path& root : roots_) {
      places.push_back(root / reference.package / reference.path);
      std::error_code error;
      // A --path folder may contain the package, or be the package itself.
      if (fs::canonical(root, error).filename() == reference.package) {
        places.push_back(root / reference.path);
      }
    }
    places.push_back(kept);
    return places;
  }
  static std::string Read(const fs::path& path, std::size_t max_bytes) {
    try {
      return ReadFile(path, max_bytes);
    } catch (const InputError& error) {  // it is too large, or a folder
      throw BadReference(": " + error.diagnostics().front().message);
    }
  }

  fs::path kept_;  ///< the folder of the URDF
  fs::path side_file_;
  std::optional<std::string> side_file_text_;
  std::string start_pose_;
  std::vector<fs::path> roots_, allowed_;
  ReadFiles read_;  // by canonical path
};

class KeptFinder : public FileFinder {
 public:
  explicit KeptFinder(OpenRobotFile open) : open_(std::move(open)) {}

  FoundFile Find(const FoundFile& from, const std::string& text, std::size_t max_bytes) override {
    const std::string name = NameOfKept(from, Parse(text));
    return Found(name, from, read_.Get(name, max_bytes, [&] {
      std::optional<std::string> bytes = open_(name, max_bytes);
      if (!bytes) throw BadReference(": expected " + Quoted(name) + " among the robot's files");
      return *std::move(bytes);
    }));
  }
  std::optional<FoundFile> FindSideFile(const FoundFile& urdf,
                                        std::size_t max_bytes) const override {
    const std::string name = fs::path(urdf.name).replace_extension(".robot.json").string();
    std::optional<std::string> bytes = open_(name, max_bytes);
    if (!bytes) return std::nullopt;
    return Found(name, urdf, std::make_shared<const std::string>(*std::move(bytes)));
  }

 private:
  static FoundFile Found(const std::string& name, const FoundFile& from,
                         std::shared_ptr<const std::string> bytes) {
    // The folder of all files: the path without as many components as the name has.
    fs::path folder = from.path;
    for (fs::path left = from.name; !left.empty(); left = left.parent_path()) {
      folder = folder.parent_path();
    }
    return {name, folder / name, std::move(bytes)};
  }

  OpenRobotFile open_;
  ReadFiles read_;  // by name
};

}  // namespace

std::unique_ptr<FileFinder> MakeOriginalFinder(const fs::path& urdf_path,
                                               const RobotReaderOptions& options) {
  return std::make_unique<OriginalFinder>(urdf_path, options);
}

std::unique_ptr<FileFinder> MakeKeptFinder(const OpenRobotFile& open) {
  return std::make_unique<KeptFinder>(open);
}

}  // namespace smile::robot::internal
