#include "studio/event_message.h"

#include "sim/event_words.h"
#include "texts/message_json.h"

namespace smile::studio {

Json EventMessage(const sim::Event& event, std::uint64_t tick, const model::Model& model) {
  Json message = {{"t", "event"}, {"kind", ToString(event.kind)}, {"tick", tick}};
  if (event.hand) message["hand"] = ToString(*event.hand);
  const auto add = [&message](const char* name, const std::string& text) {
    if (!text.empty()) message[name] = text;
  };
  add("arm", event.arm);
  add("object", event.object);
  add("by", event.by);
  add("reason", event.reason);
  add("part", event.part);
  add("control", event.control);
  add("state", event.state);
  if (const auto words = sim::WordsOf(event)) message["words"] = texts::ToJson(*words);
  if (event.guest && event.host) {
    message["guest"] = model.guest(*event.guest).point->id;
    message["host"] = model.host(*event.host).point->id;
    message["tightness"] = event.tightness;
  }
  if (!event.objects.empty()) message["objects"] = event.objects;
  if (event.kind == sim::EventKind::kAttended) message["properties"] = event.properties;
  return message;
}

}  // namespace smile::studio
