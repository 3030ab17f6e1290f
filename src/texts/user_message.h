#pragma once

#include <concepts>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace smile::texts {

struct MessageArgument;

/// Message for people: its English text, which the command line prints and logs contain, and the id
/// and arguments from which the page renders the same message in its own language.
///
/// A message without an id is text as it is, such as a quotation of a file. Assigned to a
/// `std::string`, a message is its English text.
class UserMessage : public std::string {
 public:
  // Defined where MessageArgument is complete.
  UserMessage();
  UserMessage(const UserMessage&);
  UserMessage(UserMessage&&) noexcept;
  UserMessage& operator=(const UserMessage&);
  UserMessage& operator=(UserMessage&&) noexcept;
  ~UserMessage();
  // Implicit: text as it is.
  UserMessage(std::string text);
  UserMessage(std::string_view text);
  UserMessage(const char* text);
  /// Returns the path of the message in `program` of texts/en.json; empty for text as it is.
  const std::string& id() const { return id_; }
  const std::vector<MessageArgument>& arguments() const { return arguments_; }

 private:
  UserMessage(std::string text, std::string_view id, std::vector<MessageArgument> arguments);
  friend UserMessage Say(std::string_view id, std::vector<MessageArgument> arguments);

  std::string id_;
  std::vector<MessageArgument> arguments_;
};

/// Argument of a message: another message, such as the id of an object as it is, or a number.
struct MessageArgument {
  MessageArgument(std::string_view its_name, UserMessage text)
      : name(its_name), value(std::move(text)) {}
  MessageArgument(std::string_view its_name, double number) : name(its_name), value(number) {}
  MessageArgument(std::string_view its_name, std::integral auto number)
      : name(its_name), value(static_cast<double>(number)) {}

  std::string name;
  std::variant<UserMessage, double> value;
};

/// Returns a message of the table: `Say("hands.empty", {{"hand", "left"}})`. A test compares all
/// calls with the table, which is why ids are written out in them.
/// @throws std::logic_error if the table has no such message, or an argument is missing.
UserMessage Say(std::string_view id, std::vector<MessageArgument> arguments);
UserMessage Say(std::string_view id);

}  // namespace smile::texts
