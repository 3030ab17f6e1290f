// Finds the brains of some folders and gives each the shortest name that is unique: `wave.py`, or
// `matlab/learner` where another folder also has a `learner`. Lists and names are computed from the
// files each time; nothing is registered anywhere.

#include "library/brain_choices.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>
#include <string_view>
#include <system_error>
#include <utility>

#include "base/files.h"

namespace smile::library {
namespace {

namespace fs = std::filesystem;

/// Length of the beginning of a script that is searched for the declaration. Executables are read,
/// too; this bounds the time that a large one takes.
constexpr std::size_t kMaxDeclarationBytes = 16u << 10;

/// Former paths of shipped brains, and the present ones.
constexpr std::array<std::pair<const char*, const char*>, 3> kRenamedBrains{{
    {"matlab/um", "matlab/learner"},
    {"python/um", "python/learner"},
    {"python/um/um.py", "python/learner/learner.py"},
}};

/// Program with the path by which people know it: that of its folder if it has one of its own.
struct FoundProgram {
  fs::path known_as;
  BrainChoice choice;
};

bool IsPlainFile(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

/// Returns the brain at a path, a file or a folder; nullopt if it is none.
std::optional<BrainChoice> ProgramAt(const fs::path& path) {
  // In the order in which brain::FindBrainProgram() decides, so that a listed brain starts as its
  // kind says. A folder NAME with NAME.py is known by the folder and started by the file.
  const fs::path octave = path / "agentBehavior.m";
  if (IsPlainFile(octave)) {
    return BrainChoice{.kind = "octave", .path = path, .imitates = DeclaresImitation(octave)};
  }
  const fs::path package = path / (path.filename().string() + ".py");
  const fs::path file = IsPlainFile(package) ? package : path;
  if (!IsPlainFile(file)) return std::nullopt;
  const bool is_python = file.extension() == ".py";
  if (!is_python && ::access(file.c_str(), X_OK) != 0) return std::nullopt;
  return BrainChoice{.name = "",
                     .kind = is_python ? "python" : "program",
                     .path = file,
                     .imitates = DeclaresImitation(file)};
}

/// Adds the programs of a folder, sorted by name, except those that are listed already.
void AddProgramsOf(const fs::path& folder, std::vector<FoundProgram>* all) {
  std::error_code error;
  // A map, since the order of a directory iterator is arbitrary. A folder that does not exist gives
  // an error code, hence no entries.
  std::map<std::string, FoundProgram> found;
  for (const auto& entry : fs::directory_iterator(fs::absolute(folder).lexically_normal(), error)) {
    std::optional<BrainChoice> choice = ProgramAt(entry.path());
    if (choice) found[entry.path().filename()] = {entry.path(), *std::move(choice)};
  }
  for (auto& entry : found) {
    FoundProgram& program = entry.second;
    // By identity of the file: folders may overlap, or reach a program by links.
    const bool is_new = std::ranges::none_of(*all, [&](const FoundProgram& other) {
      return fs::equivalent(other.choice.path, program.choice.path, error);
    });
    if (is_new) all->push_back(std::move(program));
  }
}

/// Returns the last parts of a path, or all of it if it has fewer.
fs::path LastPartsOf(const fs::path& path, std::ptrdiff_t num_parts) {
  const std::ptrdiff_t all = std::distance(path.begin(), path.end());
  fs::path end;
  for (auto part = std::next(path.begin(), std::max<std::ptrdiff_t>(0, all - num_parts));
       part != path.end(); ++part) {
    end /= *part;
  }
  return end;
}

/// Returns the shortest end of a path that is unique among all programs.
std::string ProgramNameOf(const fs::path& path, const std::vector<FoundProgram>& all) {
  const std::ptrdiff_t num_parts = std::distance(path.begin(), path.end());
  // Quadratic in the number of brains, of which there are a few dozen.
  for (std::ptrdiff_t count = 1; count < num_parts; ++count) {
    const fs::path name = LastPartsOf(path, count);
    const auto has_it = [&](const FoundProgram& one) {
      return LastPartsOf(one.known_as, count) == name;
    };
    if (std::ranges::count_if(all, has_it) == 1) return name;
  }
  return path;
}

/// Returns a line of a script without comment marks and surrounding blanks.
std::string_view UncommentedOf(std::string_view line) {
  const std::size_t begin = line.find_first_not_of("%#/*\"' \t");
  if (begin == std::string_view::npos) return {};
  return line.substr(begin, line.find_last_not_of(" \t\r") + 1 - begin);
}

}  // namespace

std::vector<BrainChoice> BrainsIn(const std::vector<fs::path>& folders) {
  std::vector<FoundProgram> all;
  for (const fs::path& folder : folders) AddProgramsOf(folder, &all);
  std::vector<BrainChoice> choices;
  for (const FoundProgram& found : all) {
    choices.push_back(found.choice);
    choices.back().name = ProgramNameOf(found.known_as, all);
  }
  return choices;
}

std::vector<fs::path> BrainFolders(std::vector<fs::path> own) {
  for (const char* shipped : {"matlab/examples", "python/examples", "matlab", "python"}) {
    own.push_back(DataFile(shipped));
  }
  return own;
}

const BrainChoice* BrainNamed(const std::vector<BrainChoice>& choices, const std::string& name) {
  // Exact names first: `learner` must not find `old/learner` if a brain has the very name.
  const auto exact = std::ranges::find(choices, name, &BrainChoice::name);
  if (exact != choices.end()) return &*exact;
  const auto last = std::ranges::find_if(
      choices, [&](const BrainChoice& choice) { return choice.name.ends_with("/" + name); });
  if (last != choices.end() && !name.empty()) return &*last;
  for (const auto& [former, present] : kRenamedBrains) {
    if (name == former) return BrainNamed(choices, present);
  }
  return nullptr;
}

fs::path PresentBrainPath(const fs::path& brain) {
  std::error_code error;
  if (fs::exists(brain, error)) return brain;
  // People complete folders with a slash at the end.
  const fs::path path = brain.has_filename() ? brain : brain.parent_path();
  for (const auto& [former, present] : kRenamedBrains) {
    const fs::path end = former;
    const std::ptrdiff_t num_parts = std::distance(end.begin(), end.end());
    if (LastPartsOf(path, num_parts) != end) continue;
    fs::path folder = path;
    // The present path begins in the same folder as the former one, for example that of an
    // installation.
    for (std::ptrdiff_t i = 0; i < num_parts; ++i) folder = folder.parent_path();
    if (fs::exists(folder / present, error)) return folder / present;
  }
  return brain;
}

bool DeclaresImitation(const fs::path& script) {
  std::ifstream file(script, std::ios::binary);
  std::string begin(kMaxDeclarationBytes, '\0');
  file.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  std::istringstream lines(begin.substr(0, static_cast<std::size_t>(file.gcount())));
  for (std::string line; std::getline(lines, line);) {
    if (UncommentedOf(line) == "smile: imitates") return true;
  }
  return false;
}

}  // namespace smile::library
