#include "scene_xml/internal_inclusion.h"

#include <iterator>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "base/files.h"
#include "base/wording.h"
#include "scene_xml/internal_allowed_folders.h"
#include "scene_xml/internal_attribute_reader.h"
#include "scene_xml/internal_element_choice.h"
#include "scene_xml/internal_root_reader.h"

// Includes are resolved before templates, since files typically define templates. Content is
// inserted in place of the `include`, so the order of objects is that of reading the files in
// place.

namespace smile::scene_xml {
namespace {

namespace fs = std::filesystem;

/// Replaces includes depth first. `seen_` contains the canonical names of all files read, including
/// the main file: each is read once, so circles end by themselves.
class IncludeResolver {
 public:
  IncludeResolver(const fs::path* main_file, const std::vector<fs::path>& search_roots,
                  const SceneLimits& limits, const ReadCounts& counts, ReadingContext* reading)
      : limits_(limits), counts_(counts), reading_(*reading), folders_(main_file, search_roots) {
    if (!main_file) return;
    std::error_code error;
    seen_.insert(fs::canonical(*main_file, error));
  }

  /// @param folder  of the file; nullptr if it has none.
  void Resolve(const fs::path* folder, SceneElement* root) {
    std::vector<SceneElement> content;
    for (SceneElement& child : root->children) {
      if (!child.Is("include")) {
        content.push_back(std::move(child));
        continue;
      }
      std::vector<SceneElement> included = Include(folder, child);
      std::move(included.begin(), included.end(), std::back_inserter(content));
    }
    root->children = std::move(content);
  }

  bool has_all() const { return has_all_; }

 private:
  using FoundFile = AllowedFolders::FoundFile;

  /// Adds a finding. References to the missing content are not reported in addition.
  void Fail(const SceneElement& include, const std::string& message) {
    has_all_ = false;
    reading_.findings->Add(include.place, AddressOf(include), message);
  }

  /// Returns the content of an included file; nothing if it was included before.
  std::vector<SceneElement> Include(const fs::path* folder, const SceneElement& include) {
    AttributeReader attributes(include, &reading_);
    const std::string file = attributes.RequiredText("file");
    attributes.RefuseUnknown();
    for (const SceneElement& child : include.children) RefuseElement(child, {}, &reading_);
    if (!attributes.Text("file")) {
      has_all_ = false;
      return {};
    }
    const std::optional<FoundFile> found = Find(folder, file, include);
    // A file that was read already is no fault: two files may include the same library of
    // templates.
    if (!found || !seen_.insert(found->canonical).second) return {};
    if (static_cast<int>(seen_.size()) > limits_.max_files) {
      Fail(include,
           "found more than " + std::to_string(limits_.max_files) + " files, expected fewer");
      return {};
    }
    return ContentOf(*found, include);
  }

  /// Finds the file in the folder of the including file or a search root.
  std::optional<FoundFile> Find(const fs::path* folder, const std::string& file,
                                const SceneElement& include) {
    AllowedFolders::Search search = folders_.Find(folder, file);
    if (search.found) return std::move(search.found);
    Fail(include, "found file=" + Quoted(file) + search.expected);
    return std::nullopt;
  }

  /// Reads and parses a file and resolves its own includes, relative to its folder. The limits on
  /// bytes and elements hold for all files together.
  std::vector<SceneElement> ContentOf(const FoundFile& file, const SceneElement& include) {
    std::string text;
    try {
      // By its canonical name, the one that was checked: a link that changes meanwhile leads
      // nowhere else.
      text = ReadFile(file.canonical, limits_.max_file_bytes - counts_.num_bytes);
    } catch (const std::runtime_error& error) {
      Fail(include, "found file=" + Quoted(*include.FindAttribute("file")) + ", which " +
                        WithoutPath(error.what(), file.canonical.string()) +
                        ", expected a scene file that fits the limit of " +
                        std::to_string(limits_.max_file_bytes) + " bytes for all files");
      return {};
    }
    counts_.num_bytes += text.size();
    const int id = reading_.findings->sources().AddFile(file.name.string());
    std::optional<SceneElement> root =
        ParseSceneXml(text, id, limits_, &counts_.num_elements, reading_.findings);
    if (!root || !CheckIncludedRoot(*root, &reading_)) {
      has_all_ = false;
      return {};
    }
    // The name as found, and not the canonical one: messages show the files as their author sees
    // them.
    const fs::path folder = FolderOf(file.name);
    Resolve(&folder, &*root);
    return std::move(root->children);
  }

  const SceneLimits& limits_;
  ReadCounts counts_;
  ReadingContext& reading_;
  AllowedFolders folders_;
  std::set<fs::path> seen_;  // canonical
  bool has_all_ = true;
};

}  // namespace

bool ResolveIncludes(const fs::path* main_file, const std::vector<fs::path>& search_roots,
                     const SceneLimits& limits, const ReadCounts& counts, SceneElement* root,
                     ReadingContext* reading) {
  IncludeResolver resolver(main_file, search_roots, limits, counts, reading);
  const fs::path folder = main_file ? FolderOf(*main_file) : fs::path();
  resolver.Resolve(main_file ? &folder : nullptr, root);
  return resolver.has_all();
}

}  // namespace smile::scene_xml
