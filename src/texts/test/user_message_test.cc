#include "texts/user_message.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

#include "texts/internal_message_format.h"
#include "texts/lists.h"
#include "texts/message_error.h"
#include "texts/message_json.h"

namespace smile::texts {
namespace {

TEST(Render, FillsInArgumentsOfAllKinds) {
  const auto render = [](const char* format, std::vector<MessageArgument> arguments) {
    return Render(format, arguments);
  };
  EXPECT_EQ(render("{a} and {a}, {b}", {{"a", "x"}, {"b", 0.1}}), "x and x, 0.1");
  EXPECT_EQ(render("{a, number, tenths}|{a, number, whole}|{a, number}", {{"a", 2.25}}),
            "2.2|2|2.25");
  const char* const objects = "{n, plural, one {# object} other {# objects of {kind}}}";
  EXPECT_EQ(render(objects, {{"n", 1}, {"kind", "a"}}), "1 object");
  EXPECT_EQ(render(objects, {{"n", 12}, {"kind", "a"}}), "12 objects of a");
  const char* const hands = "{hand, select, both {both hands} other {the {hand} hand}}!";
  EXPECT_EQ(render(hands, {{"hand", "both"}}), "both hands!");
  EXPECT_EQ(render(hands, {{"hand", "left"}}), "the left hand!");
}

TEST(Render, ReportsFaultsOfMessages) {
  EXPECT_THROW(Render("{a}", {}), std::logic_error);
  EXPECT_THROW(Render("{a", {{"a", "x"}}), std::logic_error);
  EXPECT_THROW(Render("{a, plural, one {b}}", {{"a", 2}}), std::logic_error);
  EXPECT_THROW(Render("{a, plural, other {b}}", {{"a", "x"}}), std::logic_error);
  EXPECT_THROW(Render("{a, number, thirds}", {{"a", 2}}), std::logic_error);
  EXPECT_THROW(Render("{a, list}", {{"a", 2}}), std::logic_error);
}

TEST(UserMessage, IsItsEnglishText) {
  const UserMessage message =
      Say("world.noRoom",
          {{"object", Say("world.object", {{"object", "b03"}})}, {"blocker", Say("world.robot")}});
  EXPECT_EQ(message, "there is no room for 'b03': the robot is in the way");
  const std::string text = message;
  EXPECT_EQ(text, message);
  EXPECT_THROW(Say("world.unheardOf"), std::logic_error);
  EXPECT_THROW(Say("world.object"), std::logic_error);
}

TEST(UserMessage, IsSentWithIdAndArguments) {
  const UserMessage object = Say("world.object", {{"object", "b03"}});
  const UserMessage message = Say("lists.andMore", {{"list", object}, {"number", 2}});
  const Json json = ToJson(message);
  EXPECT_EQ(ToText(json), R"({"say":"lists.andMore","with":{"list":{"say":"world.object","with":)"
                          R"({"object":"b03"}},"number":2.0}})");
  EXPECT_EQ(MessageOf(json), "'b03' and 2 more");
  EXPECT_EQ(ToJson(MessageOf(json)), json);
  EXPECT_EQ(ToJson("as it is"), "as it is");
  EXPECT_EQ(ToJson(Say("world.table")), (Json{{"say", "world.table"}}));
  EXPECT_THROW(MessageOf(Json{{"with", 1}}), std::invalid_argument);
}

TEST(UserMessage, IsThrownWithId) {
  const MessageError error(Say("world.table"));
  EXPECT_STREQ(error.what(), "the table");
  EXPECT_EQ(error.message().id(), "world.table");
}

TEST(Lists, HaveCommasAndAnAnd) {
  EXPECT_EQ(AllOf({}), "");
  EXPECT_EQ(AllOf({"a"}), "a");
  EXPECT_EQ(AllOf({"a", "b"}), "a and b");
  EXPECT_EQ(AllOf({"a", "b", "c"}), "a, b and c");
  EXPECT_EQ(EachOf({"a", "b"}), "a, b");
}

}  // namespace
}  // namespace smile::texts
