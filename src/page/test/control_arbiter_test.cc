#include "page/internal_control_arbiter.h"

#include <gtest/gtest.h>

#include "page/control_requests.h"

namespace smile::page {
namespace {

using std::chrono::seconds;

class ControlArbiterTest : public ::testing::Test {
 protected:
  ControlArbiterTest() {
    for (const ClientId client : {1, 2, 3}) arbiter_.Join(client);
    EXPECT_TRUE(arbiter_.Take(1, /*by_force=*/false, At(0)));
  }

  static ControlArbiter::Time At(int second) { return ControlArbiter::Time(seconds(100 + second)); }
  bool Ask(ClientId client, int second) { return arbiter_.Take(client, false, At(second)); }
  bool Force(ClientId client, int second) { return arbiter_.Take(client, true, At(second)); }

  ControlArbiter arbiter_{seconds(30)};
};

TEST_F(ControlArbiterTest, LimitsEachClientToOneRequestPerTenSeconds) {
  EXPECT_FALSE(Ask(2, 5));
  EXPECT_THROW((void)Ask(2, 6), RequestError);
  EXPECT_FALSE(Ask(3, 8)) << "another may";
  EXPECT_THROW((void)Ask(2, 14), RequestError);
  EXPECT_FALSE(Ask(2, 15));
  EXPECT_EQ(arbiter_.controller(), 1);
}

TEST_F(ControlArbiterTest, LimitsAllClientsToOneRequestPerThreeSeconds) {
  EXPECT_FALSE(Ask(2, 5));
  EXPECT_THROW((void)Ask(3, 6), RequestError);
  // A client that leaves and reconnects is another client.
  arbiter_.Leave(2);
  arbiter_.Join(4);
  EXPECT_THROW((void)Ask(4, 7), RequestError);
  EXPECT_THROW((void)Force(4, 7), RequestError) << "it would ask, too";
  EXPECT_FALSE(Ask(4, 8)) << "a refused request asks no client";
  EXPECT_THROW((void)Force(3, 10), RequestError);
  EXPECT_FALSE(Force(3, 11));
  // The new controller was not asked.
  arbiter_.Give(1, 3, At(11));
  EXPECT_FALSE(Ask(4, 11));
}

TEST_F(ControlArbiterTest, ForceRequiresSilenceAfterARequest) {
  EXPECT_FALSE(Force(2, 500)) << "an idle controller is asked first";
  EXPECT_THROW((void)Force(2, 529), RequestError);
  EXPECT_EQ(arbiter_.controller(), 1);
  EXPECT_FALSE(Force(3, 529)) << "a client that did not ask cannot force";
  EXPECT_TRUE(Force(2, 530));
  EXPECT_EQ(arbiter_.controller(), 2);
  EXPECT_FALSE(Force(3, 1000)) << "the new controller was not asked";
}

TEST_F(ControlArbiterTest, ActivityKeepsControl) {
  EXPECT_FALSE(Ask(2, 0));
  arbiter_.NoteSignOfLife(1, At(20));
  EXPECT_THROW((void)Force(2, 49), RequestError);
  EXPECT_TRUE(Force(2, 50));
}

TEST(ControlRequests, NotifiesTheRefusedClient) {
  RequestTable table;
  AddControlRequests(&table);
  const Request request{.client = 1, .seq = 1, .what = "keep_control", .fields = {{"from", 2}}};
  EXPECT_EQ(Answer(table, request, /*is_controller=*/false)["ok"], false);
  EXPECT_TRUE(TakeDeferred(table).empty());
  EXPECT_EQ(Answer(table, request, /*is_controller=*/true)["ok"], true);
  const std::vector<DeferredMessage> deferred = TakeDeferred(table);
  ASSERT_EQ(deferred.size(), 1u);
  EXPECT_EQ(deferred[0].client, 2);
  EXPECT_EQ(deferred[0].message, (Json{{"t", "control_kept"}, {"by", 1}}));
  EXPECT_TRUE(TakeDeferred(table).empty());
}

}  // namespace
}  // namespace smile::page
