#include "page/requests.h"
#include "texts/message_json.h"

#include <gtest/gtest.h>

namespace smile::page {
namespace {

RequestTable MakeTable() {
  RequestTable table;
  table.requests["look"] = {[](const Request&) {
                              return Json{{"seen", 3}};
                            },
                            /*is_for_anyone=*/true};
  table.requests["load"] = {[](const Request&) -> Json {
    throw InputError(
        Diagnostic{.file = "a.xml", .line = 4, .element = "<block>", .message = "mass is -1"});
  }};
  return table;
}

TEST(Answer, AddsWhatTheHandlerFound) {
  EXPECT_EQ(Answer(MakeTable(), {.seq = 7, .what = "look"}, /*is_controller=*/false),
            (Json{{"t", "reply"}, {"seq", 7}, {"ok", true}, {"seen", 3}}));
}

TEST(Answer, GivesTheAddressOfEveryFinding) {
  const Json answer = Answer(MakeTable(), {.seq = 8, .what = "load"}, /*is_controller=*/true);
  EXPECT_FALSE(answer["ok"]);
  EXPECT_EQ(answer["diagnostics"][0]["line"], 4);
}

TEST(Answer, ReportsTheFailedPrecondition) {
  RequestTable table = MakeTable();
  std::optional<std::string> reason;
  int num_done = 0;
  table.requests["dig"] = {.handle =
                               [&num_done](const Request&) {
                                 ++num_done;
                                 return Json::object();
                               },
                           .refuse = [&reason](const Request&) { return reason; }};
  EXPECT_EQ(AllowedRequests(table), (Json{{"dig", true}})) << "others have no precondition";
  EXPECT_TRUE(Answer(table, {.what = "dig"}, /*is_controller=*/true)["ok"]);
  reason = "the ground is frozen";
  EXPECT_EQ(AllowedRequests(table), (Json{{"dig", *reason}}));
  EXPECT_EQ(texts::MessageOf(Answer(table, {.what = "dig"}, /*is_controller=*/true)["error"]),
            *reason);
  EXPECT_EQ(num_done, 1);
}

TEST(Answer, RefusesControlToWatchers) {
  const Json answer = Answer(MakeTable(), {.what = "load"}, /*is_controller=*/false);
  EXPECT_EQ(answer["error"], Json({{"say", "control.isMissing"}}));
}

TEST(Answer, MayBeDeferred) {
  RequestTable table = MakeTable();
  table.requests["dig"] = {[](const Request&) { return AnswersLater(); }};
  table.deferred.emplace_back([] {
    return std::vector<DeferredMessage>{
        {.client = 2,
         .message = AnswerWith({.seq = 9}, []() -> Json { throw RequestError("nothing found"); })}};
  });
  EXPECT_TRUE(IsLater(Answer(table, {.seq = 9, .what = "dig"}, /*is_controller=*/true)));
  EXPECT_FALSE(IsLater(Answer(table, {.seq = 9, .what = "dig"}, /*is_controller=*/false)));
  const std::vector<DeferredMessage> deferred = TakeDeferred(table);
  ASSERT_EQ(deferred.size(), 1u);
  EXPECT_EQ(deferred[0].message,
            (Json{{"t", "reply"}, {"seq", 9}, {"ok", false}, {"error", "nothing found"}}));
}

TEST(Answer, ListsKnownRequestsForAnUnknownOne) {
  const Json answer = Answer(MakeTable(), {.what = "loat"}, /*is_controller=*/true);
  EXPECT_EQ(answer["error"],
            R"(there is no request "loat", expected load or look; did you mean "load"?)");
}

}  // namespace
}  // namespace smile::page
