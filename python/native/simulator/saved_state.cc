#include "saved_state.h"

#include <stdexcept>

#include "base/bytes.h"
#include "base/state_hash.h"
#include "checkpoint/checkpoint.h"
#include "scene/field_archive.h"

namespace smile::python {
namespace {

struct Writer : scene::FieldWriter {
  using FieldWriter::FieldWriter;
};
struct Reader : scene::FieldReader {
  using FieldReader::FieldReader;
};

template <class Archive>
void WalkTexts(Archive& archive, std::vector<std::string>& texts) {
  texts.resize(archive.Count(texts.size()));
  for (std::string& text : texts) archive(text);
}

/// An index as a number; the largest one stands for no index.
template <class Archive, class I>
void WalkIndex(Archive& archive, std::optional<I>& index) {
  constexpr auto kNone = static_cast<std::uint32_t>(-1);
  std::uint32_t number = index ? static_cast<std::uint32_t>(*index) : kNone;
  archive(number);
  index = number == kNone ? std::nullopt : std::optional(I(number));
}

template <class Archive>
void Walk(Archive& archive, sim::Event& event) {
  archive(event.kind);
  scene::WalkOptional(archive, event.hand,
                      [&archive](demonstrator::HandName& hand) { archive(hand); });
  for (std::string* text : {&event.arm, &event.object, &event.reason, &event.part, &event.control,
                            &event.state, &event.by}) {
    archive(*text);
  }
  WalkIndex(archive, event.guest);
  WalkIndex(archive, event.host);
  archive(event.tightness);
  WalkTexts(archive, event.properties);
  WalkTexts(archive, event.objects);
}

template <class Archive>
void Walk(Archive& archive, task::ContactEvent& contact) {
  Walk(archive, contact.event);
  archive(contact.tick);
  scene::Walk(archive, contact.X_WB);
  WalkTexts(archive, contact.supports);
}

template <class Archive>
void WalkContacts(Archive& archive, std::vector<task::ContactEvent>& contacts) {
  contacts.resize(archive.Count(contacts.size()));
  for (task::ContactEvent& contact : contacts) Walk(archive, contact);
}

template <class Archive>
void WalkEpisodes(Archive& archive, SavedState& state) {
  state.episodes.resize(archive.Count(state.episodes.size()));
  for (auto& contacts : state.episodes) {
    scene::WalkOptional(archive, contacts, [&archive](std::vector<task::ContactEvent>& all) {
      WalkContacts(archive, all);
    });
  }
}

std::uint64_t HashOf(std::span<const std::byte> bytes) {
  StateHash hash;
  hash.Add(std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
  return hash.value();
}

[[noreturn]] void FailAsDamaged() {
  throw std::invalid_argument("saved state: it is truncated or damaged");
}

}  // namespace

std::vector<std::byte> Serialize(const SavedState& state) {
  Writer episodes("episodes");
  // Fields are visited as for reading.
  SavedState copy{.simulation = {}, .episodes = state.episodes};
  WalkEpisodes(episodes, copy);
  ByteWriter out;
  out.Put(static_cast<std::uint32_t>(episodes.bytes.size()));
  out.Put(HashOf(episodes.bytes.bytes()));
  out.PutBytes(episodes.bytes.bytes());
  out.PutBytes(checkpoint::Serialize(state.simulation));
  return out.Take();
}

SavedState ParseSavedState(std::span<const std::byte> bytes,
                           const std::shared_ptr<const model::Model>& start_model) {
  ByteReader in(bytes);
  const auto size = in.Get<std::uint32_t>();
  const auto hash = in.Get<std::uint64_t>();
  const std::span<const std::byte> episodes = in.GetBytes(size);
  if (!in.ok() || HashOf(episodes) != hash) FailAsDamaged();
  SavedState state;
  try {
    Reader reader("episodes", episodes);
    WalkEpisodes(reader, state);
    if (!reader.bytes.ok() || reader.bytes.remaining() > 0) FailAsDamaged();
  } catch (const std::runtime_error&) {
    FailAsDamaged();
  }
  state.simulation = checkpoint::ParseState(bytes.last(in.remaining()), start_model);
  return state;
}

}  // namespace smile::python
