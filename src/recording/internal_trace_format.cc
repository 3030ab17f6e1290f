#include "recording/internal_trace_format.h"

namespace smile::recording {
namespace {

constexpr std::uint8_t kNoHand = 255;
/// More properties than these nobody names.
constexpr std::uint32_t kMaxProperties = 256;

}  // namespace

void Put(const sim::Event& event, ByteWriter* out) {
  out->Put(static_cast<std::uint8_t>(event.kind));
  out->Put(event.hand ? static_cast<std::uint8_t>(*event.hand) : kNoHand);
  for (const std::string* text :
       {&event.arm, &event.object, &event.reason, &event.part, &event.control, &event.state}) {
    out->PutString(*text);
  }
  for (int number : {NumberOf(event.guest), NumberOf(event.host), event.tightness}) {
    out->Put(number);
  }
  out->Put(static_cast<std::uint32_t>(event.properties.size()));
  for (const std::string& property : event.properties) out->PutString(property);
}

std::optional<sim::Event> GetEvent(ByteReader* in) {
  const auto kind = in->Get<std::uint8_t>();
  const auto hand = in->Get<std::uint8_t>();
  if (kind > static_cast<std::uint8_t>(sim::EventKind::kCommandRefused)) return std::nullopt;
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
  const auto num_properties = in->Get<std::uint32_t>();
  for (std::uint32_t i = 0; i < num_properties && i < kMaxProperties && in->ok(); ++i) {
    event.properties.push_back(in->GetString());
  }
  if (!in->ok()) return std::nullopt;
  return event;
}

}  // namespace smile::recording
