#include "page/page_protocol.h"

#include <map>

#include "datasets/dataset_requests.h"
#include "page/protocol_text.h"
#include "session_fixture.h"
#include "sharing/sharing.h"
#include "sim/action_summary.h"
#include "studio/library_requests.h"

namespace smile::studio {
namespace {

class PageProtocol : public SessionFixture {};

TEST_F(PageProtocol, NamesEveryRequestAndWhoMaySendIt) {
  Begin();
  page::RequestTable table = session_->requests();
  const library::Library library(root_ / "recordings");
  AddLibraryRequests(&library, &*jobs_, &table);
  datasets::DatasetRequests datasets({}, &library);
  datasets.AddTo(&table, {});
  sharing::Sharing sharing({}, &library);
  sharing.AddTo(&table, {}, {});
  // Those of the connection itself; see server_test.cc.
  std::map<std::string, bool> done = {{"hello", true},
                                      {"ping", true},
                                      {"take_control", true},
                                      {"keep_control", false},
                                      {"give_control", false}};
  for (const auto& [name, registered] : table.requests) done[name] = registered.is_for_anyone;
  std::map<std::string, bool> described;
  for (const page::RequestForm& form : page::RequestForms())
    described[form.name] = form.is_for_anyone;
  EXPECT_EQ(described, done);
}

TEST(PageProtocolTable, ReportsErrorsOfAMessage) {
  EXPECT_EQ(page::MisfitOf({{"t", "looks"}, {"looks", {1, 2}}}), "");
  EXPECT_EQ(page::MisfitOf({{"t", "looks"}, {"looks", {1, "2"}}}), ".looks.1 is \"2\"");
  EXPECT_EQ(page::MisfitOf({{"t", "nothing"}}), "there is no message \"nothing\"");
  const Json spawned = {{"t", "reply"}, {"seq", 1}, {"ok", true}, {"objects", {"a"}}};
  EXPECT_EQ(page::MisfitOf(spawned, "spawn"), "");
  EXPECT_EQ(page::MisfitOf(spawned, "clear"), ".objects is unknown");
  EXPECT_EQ(page::MisfitOf({{"t", "reply"}, {"seq", 1}, {"ok", false}}, "clear"),
            ".error is missing");
  EXPECT_EQ(page::MisfitOfRequest({{"do", "spawn"}, {"preset", "blocks"}}), ".seed is missing");
}

TEST(PageProtocolTable, ContainsEveryKindOfAction) {
  for (int kind = 0; kind <= static_cast<int>(sim::ActionKind::kLoad); ++kind) {
    const sim::ActionSummary summary{.kind = static_cast<sim::ActionKind>(kind),
                                     .hand = sim::HandName::kLeft,
                                     .what = "a",
                                     .onto = model::Support{.object = "b"}};
    const Json reply = {{"t", "reply"}, {"seq", 1}, {"ok", true}, {"deed", sim::ToJson(summary)}};
    EXPECT_EQ(page::MisfitOf(reply, "command"), "") << ToText(reply);
  }
}

TEST(PageProtocolTable, DescribesRequestsAndUpdates) {
  EXPECT_NE(page::RequestMarkdown().find(
                "| `speed` | `factor`: 0.1 to 4 | | sets the ratio of simulated to real time |\n"),
            std::string::npos);
  EXPECT_NE(page::UpdateMarkdown().find("| `looks` | `looks` | one number per choice |\n"),
            std::string::npos);
  EXPECT_NE(
      page::ProtocolTypeScript().find(
          "  spawn: { fields: { preset: string; seed: number }; answer: { objects: string[] } "
          "};\n"),
      std::string::npos);
}

}  // namespace
}  // namespace smile::studio
