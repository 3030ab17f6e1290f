#include "texts/internal_english_table.h"

#include <functional>
#include <map>
#include <string>

#include "base/json.h"

namespace smile::texts {
namespace {

using Table = std::map<std::string, std::string, std::less<>>;

/// Adds all messages of a subject, with their paths as ids.
void AddMessages(const Json& subject, const std::string& path, Table* table) {
  for (const auto& [key, entry] : subject.items()) {
    if (entry.is_object()) {
      AddMessages(entry, path + key + ".", table);
    } else {
      (*table)[path + key] = entry.get<std::string>();
    }
  }
}

}  // namespace

std::optional<std::string_view> FindEnglish(std::string_view id) {
  // Read at first use; constant from then on.
  static const Table kTable = [] {
    Table table;
    AddMessages(ParseJson(kEnglishJson).at("program"), "", &table);
    return table;
  }();
  const auto found = kTable.find(id);
  if (found == kTable.end()) return std::nullopt;
  return found->second;
}

}  // namespace smile::texts
