#include "recording/internal_trace_format.h"

// Layout of names, counts and events in `trace.bin`. Numbers are little-endian, strings have their
// length before them (u32). A list of names is its length (u32) and the strings.

namespace smile::recording {
namespace {

constexpr std::uint8_t kNoHand = 255;
/// Limit on the properties that one event can name.
constexpr std::uint32_t kMaxProperties = 256;

/// True for kinds of events that name the object that did it.
bool HasCause(sim::EventKind kind) {
  return kind == sim::EventKind::kPressed || kind == sim::EventKind::kUsed;
}

}  // namespace

void PutNames(const std::vector<std::string>& names, ByteWriter* out) {
  out->Put(static_cast<std::uint32_t>(names.size()));
  for (const std::string& name : names) out->PutString(name);
}

std::vector<std::string> GetNames(std::uint32_t max_count, ByteReader* in) {
  std::vector<std::string> names;
  const auto count = in->Get<std::uint32_t>();
  // Stops at the first error: a damaged length must not cost memory.
  for (std::uint32_t i = 0; i < count && i < max_count && in->ok(); ++i) {
    names.push_back(in->GetString());
  }
  return names;
}

void Put(const TraceCounts& counts, ByteWriter* out) {
  for (std::uint32_t count : {counts.objects, counts.controls, counts.bonds}) out->Put(count);
}

TraceCounts GetCounts(ByteReader* in) {
  TraceCounts counts;
  for (auto* count : {&counts.objects, &counts.controls, &counts.bonds}) {
    *count = in->Get<std::uint32_t>();
  }
  return counts;
}

void Put(const sim::Event& event, ByteWriter* out) {
  // kind u8, hand u8 (255: none), six strings, guest, host and tightness (i32, -1: none),
  // properties, and for events of several objects their ids.
  out->Put(static_cast<std::uint8_t>(event.kind));
  out->Put(event.hand ? static_cast<std::uint8_t>(*event.hand) : kNoHand);
  for (const std::string* text :
       {&event.arm, &event.object, &event.reason, &event.part, &event.control, &event.state}) {
    out->PutString(*text);
  }
  for (int number : {NumberOf(event.guest), NumberOf(event.host), event.tightness}) {
    out->Put(number);
  }
  PutNames(event.properties, out);
  // Written only if not empty, since older programs do not know this field.
  if (!event.objects.empty()) PutNames(event.objects, out);
  // These kinds are unknown to older programs as well.
  if (HasCause(event.kind)) out->PutString(event.by);
}

std::optional<sim::Event> GetEvent(ByteReader* in) {
  // Kinds and hands are checked before the cast: an enumerator that does not exist is undefined to
  // switch on.
  const auto kind = in->Get<std::uint8_t>();
  const auto hand = in->Get<std::uint8_t>();
  const bool is_known = kind <= static_cast<std::uint8_t>(sim::EventKind::kCleared) ||
                        static_cast<sim::EventKind>(kind) == sim::EventKind::kDisplaced ||
                        HasCause(static_cast<sim::EventKind>(kind));
  if (!is_known) return std::nullopt;
  if (hand != kNoHand && hand >= demonstrator::kHandNames.size()) return std::nullopt;
  sim::Event event{.kind = static_cast<sim::EventKind>(kind)};
  if (hand != kNoHand) event.hand = demonstrator::kHandNames[hand];
  for (std::string* text :
       {&event.arm, &event.object, &event.reason, &event.part, &event.control, &event.state}) {
    *text = in->GetString();
  }
  event.guest = IndexOf<model::GuestIndex>(in->Get<int>());
  event.host = IndexOf<model::HostIndex>(in->Get<int>());
  event.tightness = in->Get<int>();
  event.properties = GetNames(kMaxProperties, in);
  if (HasCause(event.kind)) {
    event.by = in->GetString();
    return in->ok() ? std::optional(event) : std::nullopt;
  }
  // An event ends with its record, so remaining bytes mean that the field is there.
  if (in->remaining() > 0) event.objects = GetNames(kMaxNames, in);
  if (!in->ok()) return std::nullopt;
  return event;
}

}  // namespace smile::recording
