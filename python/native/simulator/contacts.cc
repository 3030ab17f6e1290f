#include "contacts.h"

#include <stdexcept>

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
void WalkAll(Archive& archive, std::vector<task::ContactEvent>& contacts) {
  contacts.resize(archive.Count(contacts.size()));
  for (task::ContactEvent& contact : contacts) Walk(archive, contact);
}

}  // namespace

std::vector<std::byte> SerializeContacts(const std::vector<task::ContactEvent>& contacts) {
  Writer writer("contacts");
  std::vector<task::ContactEvent> copy = contacts;  // fields are visited as for reading
  WalkAll(writer, copy);
  return writer.bytes.Take();
}

std::vector<task::ContactEvent> ParseContacts(std::span<const std::byte> bytes) {
  std::vector<task::ContactEvent> contacts;
  try {
    Reader reader("contacts", bytes);
    WalkAll(reader, contacts);
    if (reader.bytes.ok() && reader.bytes.remaining() == 0) return contacts;
  } catch (const std::runtime_error&) {
  }
  throw std::invalid_argument("saved episode: it is truncated or damaged");
}

}  // namespace smile::python
