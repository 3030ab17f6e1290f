#include "recording/conflicts.h"

#include <array>
#include <stdexcept>
#include <string_view>
#include <system_error>

#include "base/diagnostic.h"
#include "base/files.h"
#include "base/json_node.h"
#include "base/wording.h"
#include "texts/message_json.h"

// `conflicts.json` is for people: no replay needs it, and a recording without it is complete.

namespace smile::recording {
namespace {

constexpr std::size_t kMaxFileBytes = 8u << 20;
/// Of all reasons that are written; a letter may take six in the file, and is there twice.
constexpr std::size_t kMaxReasonBytes = 512u << 10;
constexpr double kMaxConflictSeconds = 31 * 86400.0;
constexpr std::array<std::string_view, 1> kFileMembers{"conflicts"};
constexpr std::array<std::string_view, 4> kConflictMembers{"hand", "seconds", "reason", "message"};

std::filesystem::path FileIn(const std::filesystem::path& directory) {
  return directory / "conflicts.json";
}

std::optional<demonstrator::HandName> ReadHand(const JsonNode& node) {
  if (node.IsNull()) return std::nullopt;
  const auto hand = demonstrator::ParseHandName(node.String());
  if (!hand) node.Fail("found " + Quoted(node.String()) + ", expected a hand or null");
  return hand;
}

Conflict ReadConflict(const JsonNode& node) {
  node.ExpectMembers(kConflictMembers);
  return {.hand = ReadHand(node.Member("hand")),
          .seconds = node.Member("seconds").Number(0, kMaxConflictSeconds),
          .reason = texts::MessageBeside(node.Member("reason").ShortString(kMaxReasonBytes),
                                         node.value())};
}

}  // namespace

Json ToJson(const std::vector<Conflict>& conflicts) {
  Json json = Json::array();
  for (const Conflict& one : conflicts) {
    json.push_back({{"hand", one.hand ? Json(ToString(*one.hand)) : Json()},
                    {"seconds", one.seconds},
                    {"reason", one.reason}});
    texts::AddMessage(one.reason, &json.back());
  }
  return json;
}

void WriteConflicts(const std::filesystem::path& directory,
                    const std::vector<Conflict>& conflicts) {
  if (conflicts.empty()) return;
  std::vector<Conflict> kept;
  std::size_t bytes = 0;
  for (const Conflict& one : conflicts) {
    bytes += one.reason.size();
    if (kept.size() == kMaxConflicts || bytes > kMaxReasonBytes) break;
    kept.push_back(one);
  }
  WriteFile(FileIn(directory), ToText(Json{{"conflicts", ToJson(kept)}}, 2) + "\n");
}

std::vector<Conflict> ReadConflicts(const std::filesystem::path& directory) {
  const std::filesystem::path path = FileIn(directory);
  std::error_code error;
  if (!std::filesystem::exists(path, error)) return {};
  const std::string file = path.string(), text = ReadFile(path, kMaxFileBytes);
  try {
    const Json json = ParseJson(text);
    const JsonNode root(json, file, "");
    root.ExpectMembers(kFileMembers);
    std::vector<Conflict> conflicts;
    for (const JsonNode& node : root.Member("conflicts").ItemsUpTo(kMaxConflicts)) {
      conflicts.push_back(ReadConflict(node));
    }
    return conflicts;
  } catch (const std::invalid_argument& fault) {
    throw InputError({file, 0, "", fault.what()});
  }
}

void RemoveConflictsAfter(const std::filesystem::path& directory, double seconds) {
  std::vector<Conflict> conflicts = ReadConflicts(directory);
  if (conflicts.empty()) return;
  std::erase_if(conflicts, [=](const Conflict& one) { return one.seconds > seconds; });
  std::filesystem::remove(FileIn(directory));
  WriteConflicts(directory, conflicts);
}

}  // namespace smile::recording
