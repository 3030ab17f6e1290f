#include "studio/internal_studio_loop.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "page/test/web_client.h"

namespace smile::studio {
namespace {

using namespace std::chrono_literals;

/// Session with one thing that moves in each tick until the request `stop`.
class MovingThing : public SessionInterface {
 public:
  MovingThing() {
    table_.requests["stop"] = {[this](const page::Request&) {
      is_moving_ = false;
      messages_.push_back({{"t", "event"}, {"kind", "stopped"}});
      return Json{{"at", place_}};
    }};
  }

  const page::RequestTable& requests() const override { return table_; }
  bool Tick() override {
    if (is_waiting_) return false;
    ++num_ticks_;
    if (is_moving_) ++place_;
    return true;
  }
  SessionUpdates TakeUpdates() override {
    SessionUpdates updates{.messages = std::exchange(messages_, {})};
    if (std::exchange(is_seen_, false)) {
      updates.view = Image{.width_px = 1, .height_px = 1, .color = {1, 2, 3}};
      updates.is_view_recorded = true;
    }
    return updates;
  }
  std::vector<Json> Everything() const override { return {{{"t", "scene"}, {"scene", 1}}}; }
  double speed_factor() const override { return 3; }
  void SetMeasuredSpeed(double factor) override { measured_ = factor; }
  page::Poses NextPoses() override {
    const auto x = static_cast<float>(place_);
    return {.scene = 1, .tick = 5, .is_key = true, .frames = {1}, .values = {x, 0, 0, 0, 0, 0, 1}};
  }

  void See() { is_seen_ = true; }
  void SetWaiting(bool is_waiting) { is_waiting_ = is_waiting; }
  int num_ticks() const { return num_ticks_; }
  double measured() const { return measured_; }

 private:
  page::RequestTable table_;
  std::vector<Json> messages_;
  bool is_moving_ = true, is_seen_ = false, is_waiting_ = false;
  int place_ = 0, num_ticks_ = 0;
  double measured_ = 0;
};

class StudioLoopTest : public ::testing::Test {
 protected:
  StudioLoopTest() {
    std::filesystem::create_directories(page_);
    std::ofstream(page_ / "index.html") << "page";
    server_.emplace(page::ServerOptions{.page = page_});
    loop_.emplace(&thing_, &*server_);
  }
  ~StudioLoopTest() override { std::filesystem::remove_all(page_); }

  page::WebClient Join() {
    page::WebClient client(std::stoi(server_->link().substr(server_->link().rfind(':') + 1)));
    client.Upgrade();
    client.Hello();
    return client;
  }
  /// Returns the reply to a request, after one step of the loop.
  Json Ask(page::WebClient* client, const Json& request) {
    client->SendJson(request);
    client->SendJson({{"seq", 1000}, {"do", "ping"}});
    // The server has taken in the one when it answers the other.
    while (client->Await("reply")["seq"] != 1000) {
    }
    loop_->Step();
    return client->Await("reply");
  }

  std::filesystem::path page_ =
      std::filesystem::temp_directory_path() / ("smile_loop_" + std::to_string(getpid()));
  MovingThing thing_;
  std::optional<page::Server> server_;
  std::optional<StudioLoop> loop_;
};

TEST_F(StudioLoopTest, SendsEverythingThenPosesToNewClients) {
  page::WebClient client = Join();
  loop_->Step();
  std::vector<int> opcodes;
  while (opcodes.empty() || opcodes.back() != 2) {
    const std::optional<page::WebClient::Message> message = client.Next();
    ASSERT_TRUE(message);
    if (message->payload.find("clients") == std::string::npos) opcodes.push_back(message->opcode);
  }
  EXPECT_EQ(opcodes, (std::vector<int>{1, 2}));
}

TEST_F(StudioLoopTest, CarriesOutRequestsBeforeTicks) {
  page::WebClient client = Join();
  client.Ask({{"do", "take_control"}});
  loop_->Step();
  const Json reply = Ask(&client, {{"seq", 9}, {"do", "stop"}});
  EXPECT_EQ(reply["seq"], 9);
  EXPECT_EQ(reply["at"], 3);  // after one step
  EXPECT_EQ(client.Await("event")["kind"], "stopped");
}

TEST_F(StudioLoopTest, KeepsTheRequestedSpeedAndReportsTheMeasuredOne) {
  for (int frame = 0; frame < 5; ++frame) loop_->Step();
  EXPECT_EQ(thing_.num_ticks(), 15);
  EXPECT_GT(thing_.measured(), 0);
}

TEST_F(StudioLoopTest, CatchesUpOnWaitingTicks) {
  thing_.SetWaiting(true);
  for (int frame = 0; frame < 2; ++frame) loop_->Step();
  EXPECT_EQ(thing_.measured(), 0);
  thing_.SetWaiting(false);
  loop_->Step();
  EXPECT_EQ(thing_.num_ticks(), 9);
  loop_->Step();
  EXPECT_EQ(thing_.num_ticks(), 12);
}

TEST_F(StudioLoopTest, SendsViewsAsPictures) {
  page::WebClient client = Join();
  loop_->Step();
  thing_.See();
  loop_->Step();
  std::optional<page::WebClient::Message> view = client.Next();
  while (view && (view->opcode != 2 || view->payload[0] != 2)) view = client.Next();
  ASSERT_TRUE(view);
  EXPECT_EQ(view->payload[1], 1);  // it was recorded
  EXPECT_EQ(view->payload.substr(16, 4), "\x89PNG");
}

TEST(FrameTimer, KeepsTimeAndDropsLateTicks) {
  const FrameTimer::Time start{};
  FrameTimer timer(start);
  FrameTimer::Time now = start;
  for (int frame = 0; frame < 120; ++frame) {
    timer.EndFrame(timer.BeginFrame(now), 0, now);
    now = timer.next_frame();
  }
  EXPECT_NEAR(timer.speed(), 1, 1e-6);
  EXPECT_NEAR(std::chrono::duration<double>(now - start).count(), 2, 1e-6);

  // Every tick takes a tenth of a second: a sixth of real time is what can be.
  for (int frame = 0; frame < 40; ++frame) {
    const int ticks = timer.BeginFrame(now);
    now += 100ms * ticks;
    timer.EndFrame(ticks, 0, now);
  }
  EXPECT_NEAR(timer.speed(), 1 / 6.0, 1e-6);
  // Late frames are not made up for.
  timer.BeginFrame(now);
  EXPECT_GE(timer.next_frame(), now - 100ms);
}

TEST(FrameTimer, CatchesUpOnShortWaits) {
  FrameTimer timer(FrameTimer::Time{});
  for (int frame = 0; frame < 100; ++frame) {
    const FrameTimer::Time now = timer.next_frame();
    const int due = timer.BeginFrame(now);
    timer.EndFrame(0, due, now);
  }
  EXPECT_EQ(timer.speed(), 0);
  EXPECT_EQ(timer.BeginFrame(timer.next_frame()), 7);
}

TEST(FrameTimer, SlowTimeHasFramesWithoutTicks) {
  FrameTimer timer(FrameTimer::Time{});
  timer.SetFactor(0.25);
  int ticks = 0;
  for (int frame = 0; frame < 8; ++frame) ticks += timer.BeginFrame(FrameTimer::Time{});
  EXPECT_EQ(ticks, 2);
}

}  // namespace
}  // namespace smile::studio
