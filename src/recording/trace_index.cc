#include "recording/trace_index.h"

#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>
#include <string>

#include "base/diagnostic.h"
#include "base/files.h"
#include "recording/internal_trace_format.h"

// A trace has no fixed distances: to find its middle or its end, a reader would go through all of
// it. `trace.index` is a list of places, appended to as the trace is. It can be deleted, may end
// before the trace (a program was killed, or is older than the index), and may belong to another
// trace (files were copied). An entry is therefore compared with its record before it is used.

namespace smile::recording {
namespace {

constexpr std::array kIndexMagic = {'S', 'M', 'I', 'L', 'E', 'I', 'D', 'X'};
constexpr std::uint32_t kIndexVersion = 1;
constexpr std::size_t kIndexHead = kIndexMagic.size() + sizeof kIndexVersion;
constexpr std::size_t kEntryBytes = 3 * 8 + 1;

void Put(const TraceEntry& entry, ByteWriter* out) {
  out->Put(entry.place);
  out->Put(entry.tick);
  out->Put(entry.hash);
  out->Put(entry.kind);
}

/// Returns nullopt for a kind that does not exist.
std::optional<TraceEntry> GetEntry(ByteReader* in) {
  TraceEntry entry{.place = in->Get<std::uint64_t>(),
                   .tick = in->Get<std::uint64_t>(),
                   .hash = in->Get<std::uint64_t>()};
  const auto kind = in->Get<std::uint8_t>();
  if (kind < static_cast<std::uint8_t>(TraceEntry::Kind::kKeyframe) ||
      kind > static_cast<std::uint8_t>(TraceEntry::Kind::kReturn)) {
    return std::nullopt;
  }
  entry.kind = static_cast<TraceEntry::Kind>(kind);
  return entry;
}

/// True if the record at the entry's place begins as the entry says.
bool Fits(const TraceEntry& entry, FileWindows* trace) {
  const auto bytes = trace->At(entry.place, 2 * 8);
  ByteReader in(bytes);
  return in.Get<std::uint64_t>() == entry.tick && in.Get<std::uint64_t>() == entry.hash && in.ok();
}

/// Returns the text of the file; nullopt if it does not exist, is too large, or is no index.
std::optional<std::string> ReadIndexFile(const std::filesystem::path& path, std::size_t max_bytes) {
  std::string text;
  try {
    text = ReadFile(path, max_bytes);
  } catch (const std::runtime_error&) {
    // Missing, too large, or unreadable: the trace is read instead.
    return std::nullopt;
  }
  ByteReader in(std::as_bytes(std::span(text)));
  for (char letter : kIndexMagic) {
    if (in.Get<char>() != letter) return std::nullopt;
  }
  if (in.Get<std::uint32_t>() != kIndexVersion || !in.ok()) return std::nullopt;
  return text;
}

}  // namespace

std::filesystem::path TraceIndexOf(const std::filesystem::path& trace) {
  return trace.parent_path() / "trace.index";
}

std::vector<std::byte> BytesOf(const TraceEntry& entry) {
  ByteWriter out;
  Put(entry, &out);
  return out.Take();
}

std::vector<std::byte> BytesOf(std::span<const TraceEntry> entries) {
  ByteWriter out;
  for (char letter : kIndexMagic) out.Put(letter);
  out.Put(kIndexVersion);
  for (const TraceEntry& entry : entries) Put(entry, &out);
  return out.Take();
}

std::vector<TraceEntry> ReadTraceIndex(const std::filesystem::path& trace_path,
                                       FileWindows* trace) {
  // Each record that has an entry is larger than it, so no index is larger than its trace.
  const std::optional<std::string> text =
      ReadIndexFile(TraceIndexOf(trace_path), static_cast<std::size_t>(trace->size()));
  if (!text) return {};
  ByteReader in(std::as_bytes(std::span(*text)).subspan(kIndexHead));
  std::vector<TraceEntry> entries;
  entries.reserve(in.remaining() / kEntryBytes);
  // An incomplete last entry is the end of an interrupted program.
  while (in.remaining() >= kEntryBytes) {
    const std::optional<TraceEntry> entry = GetEntry(&in);
    const bool is_in_order = entries.empty() || (entry && entry->place > entries.back().place);
    if (!entry || !is_in_order) return {};
    // The trace lost its end, as after a power failure.
    if (entry->place >= trace->size()) break;
    entries.push_back(*entry);
  }
  // Both files only grow: if the last entry fits, so do those before it.
  if (entries.empty() || !Fits(entries.front(), trace) || !Fits(entries.back(), trace)) return {};
  return entries;
}

}  // namespace smile::recording
