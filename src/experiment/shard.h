#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "base/json.h"

namespace smile::experiment {

/// Part of a job that is divided among several processes or machines: each `count`-th item, from
/// number `index` on.
struct Shard {
  std::size_t index = 1;  ///< 1 to count
  std::size_t count = 1;

  bool Contains(std::size_t item) const { return item % count == index - 1; }
  bool is_whole() const { return count == 1; }
  bool operator==(const Shard&) const = default;
};

/// Parses `2/8`.
/// @throws std::invalid_argument with what was found and expected.
Shard ParseShard(std::string_view text);

/// Returns `2/8`.
std::string ToString(const Shard& shard);

/// Content of `shard.json`, which marks a folder with the results of one shard.
struct ShardMark {
  std::string kind;  ///< `generation` or `evaluation`
  Shard shard;
  Json whole;  ///< what all shards agree on, beside the files in their folders
};

/// Writes the mark of a folder. A whole job has none.
void WriteMark(const ShardMark& mark, const std::filesystem::path& folder);

/// Returns the mark of a folder; nullopt without one.
/// @throws InputError if it is damaged.
std::optional<ShardMark> ReadMark(const std::filesystem::path& folder);

}  // namespace smile::experiment
