#include "experiment/shard.h"

#include <algorithm>
#include <charconv>
#include <stdexcept>
#include <system_error>

#include "base/files.h"
#include "base/json_node.h"
#include "base/wording.h"
#include "experiment/json_file.h"

namespace smile::experiment {
namespace {

constexpr const char* kMarkFile = "shard.json";
constexpr std::size_t kMaxShards = 1'000'000, kMaxKindBytes = 32;

/// Returns a whole number from 1 to kMaxShards; nullopt for any other text.
std::optional<std::size_t> ShardNumberIn(std::string_view text) {
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  if (number < 1 || number > kMaxShards) return std::nullopt;
  return number;
}

}  // namespace

Shard ParseShard(std::string_view text) {
  const std::size_t slash = std::min(text.find('/'), text.size());
  const auto index = ShardNumberIn(text.substr(0, slash));
  const auto count = ShardNumberIn(text.substr(std::min(slash + 1, text.size())));
  if (!index || !count || *index > *count) {
    throw std::invalid_argument("shard: found " + Quoted(text) +
                                ", expected a number and the number of all shards, such as 2/8");
  }
  return {.index = *index, .count = *count};
}

std::string ToString(const Shard& shard) {
  return std::to_string(shard.index) + "/" + std::to_string(shard.count);
}

void WriteMark(const ShardMark& mark, const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / kMarkFile;
  if (mark.shard.is_whole()) {
    // A whole job may continue in the folder of a shard, of which it contains everything.
    std::filesystem::remove(file);
    return;
  }
  WriteFile(file, ToText({{"format", 1},
                          {"kind", mark.kind},
                          {"shard", mark.shard.index},
                          {"shards", mark.shard.count},
                          {"whole", mark.whole}},
                         2) +
                      "\n");
}

std::optional<ShardMark> ReadMark(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / kMarkFile;
  if (!std::filesystem::exists(file)) return std::nullopt;
  const Json json = ReadJsonFile(file);
  const std::string name = file.string();
  const JsonNode node(json, name, "");
  node.ExpectObject();
  node.Member("format").Whole(1, 1);
  const std::size_t count = node.Member("shards").Whole(2, kMaxShards);
  return ShardMark{.kind = node.Member("kind").ShortString(kMaxKindBytes),
                   .shard = {.index = node.Member("shard").Whole(1, count), .count = count},
                   .whole = node.Member("whole").value()};
}

}  // namespace smile::experiment
