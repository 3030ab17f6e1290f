// A viewer shows what a program does with a simulation, and cannot be used to change it.

#include "studio/viewer.h"

#include <gtest/gtest.h>

#include <atomic>
#include <fstream>
#include <thread>

#include "base/files.h"
#include "base/temporary_directory.h"
#include "page/page_protocol.h"
#include "page/test/web_client.h"
#include "scene_xml/scene_reader.h"
#include "texts/message_json.h"

namespace smile::studio {
namespace {

sim::Simulation Tower() {
  return sim::Simulation(scene_xml::LoadScene(DataFile("scenes/tower.xml")));
}

/// A simulation that ends before its viewer.
struct WatchedTower {
  ~WatchedTower() { watched->Detach(); }
  void Grasp(const std::string& object) {
    const auto lock = watched->Lock();
    ASSERT_FALSE(simulation.Apply(sim::Grasp{.hand = sim::HandName::kLeft, .object = object}));
  }

  sim::Simulation simulation = Tower();
  std::shared_ptr<WatchedSimulation> watched = std::make_shared<WatchedSimulation>(&simulation);
};

class ViewerTest : public ::testing::Test {
 protected:
  ViewerTest() { std::ofstream(page_.path() / "index.html") << "page"; }

  void Open(const WatchedTower& tower) {
    viewer_.emplace(page::ServerOptions{.page = page_.path()}, tower.watched);
  }
  page::WebClient Connect() {
    const std::string link = viewer_->link();
    return page::WebClient(std::stoi(link.substr(link.rfind(':') + 1)));
  }
  page::WebClient Join() {
    page::WebClient client = Connect();
    client.Upgrade();
    EXPECT_EQ(client.Hello()["ok"], true);
    return client;
  }

  /// Waits for a state in which the left hand holds `object`. Earlier ones may come first: a client
  /// that joins during a frame gets the moment with which the frame began.
  static bool AwaitInLeftHand(page::WebClient* client, const Json& object) {
    while (true) {
      const Json state = client->Await("state");
      if (state.is_null()) return false;
      if (state["hands"]["left"]["object"] == object) return true;
    }
  }

  TemporaryDirectory page_;
  std::optional<Viewer> viewer_;
};

TEST_F(ViewerTest, ShowsWhatAProgramDoes) {
  WatchedTower tower;
  Open(tower);
  page::WebClient client = Join();
  const Json scene = client.Await("scene");
  EXPECT_EQ(page::MisfitOf(scene), "");
  EXPECT_EQ(scene["objects"].size(), 3u);
  const Json state = client.Await("state");
  EXPECT_EQ(page::MisfitOf(state), "");
  EXPECT_EQ(state["mode"], "watched");
  tower.Grasp("RedBlock");
  EXPECT_EQ(client.Await("event")["object"], "RedBlock");
  EXPECT_TRUE(AwaitInLeftHand(&client, "RedBlock"));
}

TEST_F(ViewerTest, RefusesRequestsThatWouldChangeSomething) {
  constexpr const char* kReason = "a program controls this simulation; it can only be watched";
  const WatchedTower tower;
  Open(tower);
  page::WebClient client = Join();
  for (const page::RequestForm& form : page::RequestForms()) {
    if (form.is_for_anyone || form.name == "allowed" || form.name.ends_with("_control")) continue;
    EXPECT_EQ(texts::MessageOf(client.Ask({{"do", form.name}})["error"]), kReason) << form.name;
  }
  const Json allowed = client.Ask({{"do", "allowed"}, {"requests", {{{"do", "pause"}}}}});
  EXPECT_EQ(texts::MessageOf(allowed["allowed"][0]), kReason) << allowed;
  EXPECT_EQ(client.Ask({{"do", "library"}})["recordings"], Json::array());
  EXPECT_EQ(tower.simulation.tick(), 0u);
}

TEST_F(ViewerTest, MayBeFramedByANotebook) {
  const WatchedTower tower;
  Open(tower);
  const std::string page = Connect().Get("/");
  EXPECT_NE(page.find("Content-Security-Policy"), std::string::npos);
  EXPECT_EQ(page.find("frame-ancestors"), std::string::npos);
}

TEST_F(ViewerTest, ShowsTheNextSimulationAndTheLastMomentOfAnEndedOne) {
  {
    WatchedTower tower;
    Open(tower);
    tower.Grasp("RedBlock");
  }
  page::WebClient client = Join();
  EXPECT_TRUE(AwaitInLeftHand(&client, "RedBlock"));
  const WatchedTower next;
  viewer_->Show(next.watched);
  EXPECT_EQ(client.Await("scene")["scene"], 2);
  EXPECT_EQ(client.Await("state")["hands"]["left"]["object"], nullptr);
}

TEST(WatchedSimulation, ComputesTheBitsOfAnUnwatchedOne) {
  const auto run = [](WatchedSimulation* watched, sim::Simulation* simulation) {
    (void)simulation->Apply(sim::Grasp{.hand = sim::HandName::kLeft, .object = "RedBlock"});
    (void)simulation->Apply(
        sim::MoveTo{.hand = sim::HandName::kLeft, .p_WH = Vector3(0.3, 0.2, 0.2)});
    for (int i = 0; i < 60; ++i) {
      const auto lock = watched ? watched->Lock() : std::unique_lock<std::recursive_mutex>();
      for (int tick = 0; tick < 3; ++tick) simulation->Tick();
    }
    return simulation->state_hash();
  };
  sim::Simulation alone = Tower(), shown = Tower();
  WatchedSimulation watched(&shown);
  std::atomic<bool> is_over = false;
  std::thread viewer([&] {
    while (!is_over) watched.Latest();
  });
  EXPECT_EQ(run(&watched, &shown), run(nullptr, &alone));
  is_over = true;
  viewer.join();
  EXPECT_EQ(watched.Latest()->tick, 180u);
}

TEST(WatchedSimulation, PublishesDuringALongStep) {
  sim::Simulation simulation = Tower();
  WatchedSimulation watched(&simulation);
  const auto lock = watched.Lock();
  std::thread([&] { EXPECT_EQ(watched.Latest()->tick, 0u); }).join();
  simulation.Tick();
  std::thread([&] { EXPECT_EQ(watched.Latest()->tick, 1u); }).join();
}

TEST(WatchedSimulation, EndsAlsoWhileItIsLocked) {
  auto simulation =
      std::make_unique<sim::Simulation>(scene_xml::LoadScene(DataFile("scenes/tower.xml")));
  WatchedSimulation watched(simulation.get());
  const auto lock = watched.Lock();
  simulation->Tick();
  watched.Detach();
  simulation.reset();
  EXPECT_EQ(watched.Latest()->tick, 1u);
}

TEST(WatchedSimulation, IsSlowedDownToRealTime) {
  sim::Simulation simulation = Tower();
  WatchedSimulation watched(&simulation);
  watched.SetSpeed(2);
  const auto begin = std::chrono::steady_clock::now();
  for (int i = 0; i < 25; ++i) simulation.Tick();
  EXPECT_GE(std::chrono::steady_clock::now() - begin, std::chrono::milliseconds(200));
}

}  // namespace
}  // namespace smile::studio
