// The program's messages for people: each id that it sends is in the table, with these arguments,
// and each message of the table is sent. The page's tests compare the languages.

#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <string_view>

#include "base/files.h"
#include "base/json.h"

namespace smile::messages {
namespace {

namespace fs = std::filesystem;
using Names = std::set<std::string>;

const fs::path kRoot = SMILE_SOURCE_DIR;

/// Calls `visit` with the content of each pair of outermost braces.
void ForEachField(std::string_view text, const std::function<void(std::string_view)>& visit) {
  int depth = 0;
  std::size_t open = 0;
  for (std::size_t k = 0; k < text.size(); ++k) {
    if (text[k] == '{' && depth++ == 0) open = k;
    if (text[k] == '}' && --depth == 0) visit(text.substr(open + 1, k - open - 1));
  }
}

/// Adds the arguments of a message, also those within the cases of others.
void AddArgumentsIn(std::string_view message, Names* names) {
  ForEachField(message, [names](std::string_view field) {
    names->emplace(field.substr(0, field.find(',')));
    if (field.find('{') != std::string_view::npos) {
      ForEachField(field, [names](std::string_view text) { AddArgumentsIn(text, names); });
    }
  });
}

/// The arguments of each message of the program in English, by its id.
std::map<std::string, Names> Table() {
  std::map<std::string, Names> table;
  const Json json = ParseJson(ReadFile(kRoot / "texts/en.json", 1 << 24));
  for (const auto& [subject, messages] : json["program"].items()) {
    for (const auto& [key, message] : messages.items()) {
      std::string id = subject;
      id += "." + key;
      AddArgumentsIn(message.get<std::string>(), &table[id]);
    }
  }
  return table;
}

/// The names of the arguments in the parentheses of a call, which begin the text; those of other
/// calls within it do not count.
Names ArgumentsOfCall(std::string_view text) {
  Names names;
  int depth = 0;
  bool is_quoted = false;
  for (std::size_t k = 0; k < text.size(); ++k) {
    if (text[k] == '"' && text[k - 1] != '\\') is_quoted = !is_quoted;
    if (is_quoted) continue;
    if (text[k] == '(' || text[k] == '{') ++depth;
    if ((text[k] == ')' || text[k] == '}') && --depth == 0) return names;
    // Within the call, the list and the argument, the name comes first: ("id", {{"name", …
    if (depth == 3 && text.substr(k, 2) == "{\"") {
      names.emplace(text.substr(k + 2, text.find('"', k + 2) - k - 2));
    }
  }
  return names;
}

/// Calls `visit` with the path and the text of each source that sends messages, but not of tests.
void ForEachSource(const std::function<void(const fs::path&, const std::string&)>& visit) {
  for (const auto& entry : fs::recursive_directory_iterator(kRoot / "src")) {
    const fs::path& path = entry.path();
    const bool is_source = path.extension() == ".cc" || path.extension() == ".h";
    if (!is_source || path.parent_path().filename() == "test") continue;
    const std::string text = ReadFile(path, 1 << 24);
    const bool is_list = path.parent_path().filename() == "texts" && path.stem() == "lists";
    if (is_list || text.find("texts::Say") != std::string::npos) visit(path, text);
  }
}

TEST(Messages, AreInTheTableWithTheArgumentsOfTheirCalls) {
  const auto table = Table();
  const std::regex call(R"re(\bSay\(\s*("([\w.]+)")?)re");
  Names said;
  ForEachSource([&](const fs::path& path, const std::string& text) {
    for (std::sregex_iterator it(text.begin(), text.end(), call), end; it != end; ++it) {
      const std::string id = (*it)[2];
      ASSERT_TRUE(table.contains(id))
          << path << ": " << it->str() << ", expected an id of texts/en.json, as a literal";
      const std::size_t open = text.find('(', static_cast<std::size_t>(it->position()));
      EXPECT_EQ(ArgumentsOfCall(std::string_view(text).substr(open)), table.at(id))
          << path << ": " << id;
      said.insert(id);
    }
  });
  EXPECT_GT(said.size(), 100u);
  for (const auto& [id, names] : table) EXPECT_TRUE(said.contains(id)) << id << " is never sent";
}

TEST(Messages, AreComparedWithNestedArguments) {
  EXPECT_EQ(ArgumentsOfCall(
                R"lit(("a.b", {{"one", Say("c.d", {{"inner", f(1)}})}, {"two", "(}"}}) {"x"})lit"),
            (Names{"one", "two"}));
  Names names;
  AddArgumentsIn("{a} {b, plural, one {# of {c}} other {{d, number}}}", &names);
  EXPECT_EQ(names, (Names{"a", "b", "c", "d"}));
}

}  // namespace
}  // namespace smile::messages
