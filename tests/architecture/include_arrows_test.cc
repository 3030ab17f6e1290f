// The walls of the house: who includes whom is what src/CMakeLists.txt and docs/architecture.md
// say, and the files of a room include one another in no large circle.

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "base/files.h"

namespace {

namespace fs = std::filesystem;
using Rooms = std::map<std::string, std::set<std::string>>;

const fs::path kRoot = SMILE_SOURCE_DIR;

std::string Text(const fs::path& path) { return smile::ReadFile(path, 1 << 24); }

/// Which rooms each room names after `list`, as the build says.
Rooms TableOfTheBuild(const std::string& list = "MAY_INCLUDE") {
  Rooms table;
  const std::string text = Text(kRoot / "src/CMakeLists.txt");
  const std::regex call(R"(smile_room\((\w+)([^)]*)\))");
  for (std::sregex_iterator it(text.begin(), text.end(), call), end; it != end; ++it) {
    std::set<std::string>& neighbours = table[(*it)[1]];
    std::istringstream words((*it)[2]);
    bool is_neighbour = false;
    for (std::string word; words >> word;) {
      if (std::ranges::all_of(word, [](unsigned char c) { return c == '_' || std::isupper(c); })) {
        is_neighbour = word == list;
      } else if (is_neighbour) {
        neighbours.insert(word);
      }
    }
  }
  return table;
}

/// The same as docs/architecture.md says: rows `| room | may include |`.
Rooms TableOfTheDocument() {
  Rooms table;
  std::istringstream lines(Text(kRoot / "docs/architecture.md"));
  const std::regex row(R"(\| `(\w+)` \| ([^|]*) \|.*)");
  std::smatch match;
  for (std::string line; std::getline(lines, line);) {
    if (!std::regex_match(line, match, row)) continue;
    EXPECT_FALSE(table.contains(match[1])) << match[1] << " has two rows";
    std::set<std::string>& neighbours = table[match[1]];
    std::istringstream words(match[2]);
    for (std::string word; words >> word;) {
      while (!word.empty() && word.back() == ',') word.pop_back();
      if (word != "–") neighbours.insert(word);
    }
  }
  return table;
}

/// A room also sees what its neighbours see.
std::set<std::string> VisibleFrom(const std::string& room, const Rooms& table) {
  std::set<std::string> seen{room};
  for (const std::string& neighbour : table.at(room)) {
    seen.merge(VisibleFrom(neighbour, table));
  }
  return seen;
}

template <class Visit>
void ForEachSource(const std::string& room, Visit visit) {
  for (const auto& entry : fs::recursive_directory_iterator(kRoot / "src" / room)) {
    const std::string extension = entry.path().extension();
    if (extension == ".h" || extension == ".cc") visit(entry.path());
  }
}

std::set<std::string> IncludesOf(const fs::path& file) {
  std::set<std::string> includes;
  const std::string text = Text(file);
  const std::regex include(R"re(#include ["<]([^">]+)[">])re");
  for (std::sregex_iterator it(text.begin(), text.end(), include), end; it != end; ++it) {
    includes.insert((*it)[1]);
  }
  return includes;
}

TEST(Architecture, TheDocumentAndTheBuildNameTheSameArrows) {
  EXPECT_EQ(TableOfTheDocument(), TableOfTheBuild());
}

TEST(Architecture, EveryIncludeFollowsAnArrow) {
  const Rooms table = TableOfTheBuild(), of_tests = TableOfTheBuild("TESTS_MAY_INCLUDE");
  ASSERT_GE(table.size(), 14u);
  for (const auto& [room, neighbours] : table) {
    const std::set<std::string> visible = VisibleFrom(room, table);
    std::set<std::string> visible_in_tests = visible;
    for (const std::string& other : of_tests.at(room)) {
      visible_in_tests.merge(VisibleFrom(other, table));
    }
    ForEachSource(room, [&](const fs::path& file) {
      const bool is_test = file.parent_path().filename() == "test";
      for (const std::string& include : IncludesOf(file)) {
        const std::string target = include.substr(0, include.find('/'));
        if (!table.contains(target)) continue;
        EXPECT_TRUE((is_test ? visible_in_tests : visible).contains(target))
            << file << " includes " << include;
      }
    });
  }
}

TEST(Architecture, InternalHeadersStayInTheirRoom) {
  for (const auto& [room, neighbours] : TableOfTheBuild()) {
    ForEachSource(room, [&room = room](const fs::path& file) {
      for (const std::string& include : IncludesOf(file)) {
        if (include.find("/internal_") == std::string::npos) continue;
        EXPECT_EQ(include.substr(0, include.find('/')), room) << file << " includes " << include;
      }
    });
  }
}

TEST(Architecture, EveryLibraryHasOneHome) {
  const std::map<std::string, std::string> homes = {
      {"bt", "physics"},        {"Bullet", "physics"},
      {"libxml/", "xml"},       {"epoxy/", "camera"},
      {"EGL/", "camera"},       {"png.h", "image"},
      {"urdf_", "robot"},       {"libav", "video"},
      {"libsw", "video"},       {"CLI/", "app"},
      {"benchmark/", "bench"},  {"nlohmann/", "base"},
      {"assimp/", "mesh"},      {"archive", "library"},
      {"boost/", "web_server"}, {"openssl/", "web_server"},
  };
  Rooms table = TableOfTheBuild();
  table["app"];
  for (const auto& [room, neighbours] : table) {
    ForEachSource(room, [&, &room = room](const fs::path& file) {
      for (const std::string& include : IncludesOf(file)) {
        for (const auto& [prefix, home] : homes) {
          if (include.rfind(prefix, 0) != 0) continue;
          EXPECT_EQ(room, home) << file << " includes " << include;
          const bool is_public =
              file.extension() == ".h" && file.filename().string().rfind("internal_", 0) != 0;
          // No room includes app, and each room uses JSON.
          EXPECT_TRUE(!is_public || home == "base" || home == "app")
              << file << " shows " << include << " to all";
        }
      }
    });
  }
}

// Files of a room that all include one another, directly or by way of others, can only be read
// together: such knots stay small.

using Units = std::set<std::string>;
using IncludeGraph = std::map<std::string, Units>;

constexpr std::size_t kMaxFilesInAKnot = 3;

/// Which units of a room include which; a header and its source are one unit, `room/name`.
IncludeGraph GraphOf(const std::string& room) {
  IncludeGraph graph;
  for (const auto& entry : fs::directory_iterator(kRoot / "src" / room)) {
    const std::string extension = entry.path().extension();
    if (extension != ".h" && extension != ".cc") continue;
    const std::string unit = room + "/" + entry.path().stem().string();
    for (const std::string& include : IncludesOf(entry.path())) {
      const std::string included = include.substr(0, include.rfind('.'));
      if (included != unit && included.starts_with(room + "/")) graph[unit].insert(included);
    }
  }
  return graph;
}

void AddReachable(const std::string& unit, const IncludeGraph& graph, Units* reached) {
  const auto includes = graph.find(unit);
  if (includes == graph.end()) return;
  for (const std::string& included : includes->second) {
    if (reached->insert(included).second) AddReachable(included, graph, reached);
  }
}

/// The strongly connected components of more than one unit.
std::vector<Units> KnotsOf(const IncludeGraph& graph) {
  std::map<std::string, Units> reachable;
  for (const auto& [unit, includes] : graph) AddReachable(unit, graph, &reachable[unit]);
  std::set<Units> knots;
  for (const auto& [unit, reached] : reachable) {
    Units knot;
    for (const std::string& other : reached) {
      if (reachable.contains(other) && reachable.at(other).contains(unit)) knot.insert(other);
    }
    if (!knot.empty()) knots.insert(knot);
  }
  return {knots.begin(), knots.end()};
}

std::string ListOf(const Units& units) {
  std::string list;
  for (const std::string& unit : units) list += "\n  " + unit;
  return list;
}

TEST(Architecture, FindsKnotsOfUnitsThatIncludeOneAnother) {
  const IncludeGraph graph = {
      {"a", {"b"}}, {"b", {"c"}}, {"c", {"a", "d"}}, {"d", {"e"}}, {"f", {"a"}}};
  EXPECT_EQ(KnotsOf(graph), (std::vector<Units>{{"a", "b", "c"}}));
}

TEST(Architecture, NoKnotHasMoreThanThreeFiles) {
  Rooms rooms = TableOfTheBuild();
  rooms["app"];
  std::size_t num_units = 0;
  for (const auto& [room, neighbours] : rooms) {
    const IncludeGraph graph = GraphOf(room);
    num_units += graph.size();
    for (const Units& knot : KnotsOf(graph)) {
      EXPECT_LE(knot.size(), kMaxFilesInAKnot) << room << " has a knot of" << ListOf(knot);
    }
  }
  EXPECT_GT(num_units, 200u);
}

TEST(Architecture, ModelsAndRobotsDoNotIncludePhysics) {
  const Rooms table = TableOfTheBuild();
  EXPECT_FALSE(VisibleFrom("model", table).contains("physics"));
  EXPECT_FALSE(VisibleFrom("robot", table).contains("physics"));
}

}  // namespace
