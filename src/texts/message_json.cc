#include "texts/message_json.h"

#include <stdexcept>

namespace smile::texts {
namespace {

Json ValueOf(const MessageArgument& argument) {
  if (const auto* number = std::get_if<double>(&argument.value)) return *number;
  return ToJson(std::get<UserMessage>(argument.value));
}

}  // namespace

Json EnglishOf(const UserMessage& message) { return static_cast<const std::string&>(message); }

Json ToJson(const UserMessage& message) {
  if (message.id().empty()) return EnglishOf(message);
  Json json = {{"say", message.id()}};
  for (const MessageArgument& argument : message.arguments()) {
    json["with"][argument.name] = ValueOf(argument);
  }
  return json;
}

UserMessage MessageOf(const Json& json) {
  if (json.is_string()) return json.get<std::string>();
  if (!json.is_object() || !json.contains("say") || !json["say"].is_string()) {
    throw std::invalid_argument("found " + ToText(json) + ", expected a string or a message");
  }
  std::vector<MessageArgument> arguments;
  const Json with = json.value("with", Json::object());
  for (const auto& [name, value] : with.items()) {
    if (value.is_number()) {
      arguments.emplace_back(name, value.get<double>());
    } else {
      arguments.emplace_back(name, MessageOf(value));
    }
  }
  return Say(json["say"].get<std::string>(), std::move(arguments));
}

void AddMessage(const UserMessage& message, Json* object) {
  if (!message.id().empty()) (*object)["message"] = ToJson(message);
}

UserMessage MessageBeside(std::string english, const Json& object) {
  try {
    if (object.contains("message")) return MessageOf(object["message"]);
  } catch (const std::logic_error&) {
    // Of another version, or changed by hand.
  }
  return english;
}

}  // namespace smile::texts
