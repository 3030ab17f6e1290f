#include "texts/user_message.h"

#include <stdexcept>

#include "texts/internal_english_table.h"
#include "texts/internal_message_format.h"

namespace smile::texts {
namespace {

std::string English(std::string_view id, const std::vector<MessageArgument>& arguments) {
  const auto format = FindEnglish(id);
  if (!format) throw std::logic_error("texts/en.json has no program." + std::string(id));
  return Render(*format, arguments);
}

}  // namespace

UserMessage::UserMessage() = default;
UserMessage::UserMessage(const UserMessage&) = default;
UserMessage::UserMessage(UserMessage&&) noexcept = default;
UserMessage& UserMessage::operator=(const UserMessage&) = default;
UserMessage& UserMessage::operator=(UserMessage&&) noexcept = default;
UserMessage::~UserMessage() = default;
UserMessage::UserMessage(std::string text) : std::string(std::move(text)) {}
UserMessage::UserMessage(std::string_view text) : std::string(text) {}
UserMessage::UserMessage(const char* text) : std::string(text) {}

UserMessage::UserMessage(std::string text, std::string_view id,
                         std::vector<MessageArgument> arguments)
    : std::string(std::move(text)), id_(id), arguments_(std::move(arguments)) {}

UserMessage Say(std::string_view id, std::vector<MessageArgument> arguments) {
  std::string text = English(id, arguments);
  return {std::move(text), id, std::move(arguments)};
}

UserMessage Say(std::string_view id) { return Say(id, {}); }

}  // namespace smile::texts
