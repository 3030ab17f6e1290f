// Adding and removing objects without a hand.

#include <map>

#include "everything_scene.h"
#include "random_hands.h"
#include "scene_xml/scene_reader.h"
#include "scene_xml/scene_writer.h"
#include "sim/add.h"
#include "sim/script.h"
#include "sim/spawning.h"
#include "simulation_fixture.h"

namespace smile::sim {
namespace {

Spawn SpawnOf(const std::string& content, const std::string& attributes = "") {
  return {.xml = "<tabletop xmlns=\"http://synapse.cs.umd.edu/tabletop-xml\"" + attributes + ">" +
                 content + "</tabletop>"};
}

class SpawnTest : public SimulationFixture {
 protected:
  std::optional<Refusal> Add(const std::string& content, const std::string& attributes = "") {
    return simulation_->Apply(SpawnOf(content, attributes));
  }
  /// Returns the reason why nothing was added.
  std::string RefusalOf(const std::string& content, const std::string& attributes = "") {
    const std::uint64_t before = simulation_->state_hash();
    const auto refusal = Add(content, attributes);
    EXPECT_EQ(simulation_->state_hash(), before);
    EXPECT_EQ(simulation_->model().objects().size(), 2u);
    return refusal.value_or("it was added");
  }

  std::unique_ptr<Simulation> simulation_ =
      MakeSimulation({BlockAt("a", {0, 0, 0.05}), BlockAt("b", {0.3, 0, 0.4})}, false);
};

TEST_F(SpawnTest, PresentObjectsKeepTheirStateExactly) {
  ASSERT_FALSE(simulation_->Apply(Grasp{.hand = HandName::kLeft, .object = "a"}));
  ASSERT_FALSE(simulation_->Apply(MoveTo{.hand = HandName::kLeft, .p_WH = {0, 0.2, 0.3}}));
  TickSeconds(*simulation_, 0.2);  // `b` falls
  const auto state_of = [this](const char* id) {
    const physics::Body& body = simulation_->physics().body(simulation_->tabletop().Find(id)->body);
    return std::tuple(body.pose_in_world(), body.linear_velocity(), body.angular_velocity(),
                      body.is_awake());
  };
  const auto a = state_of("a"), b = state_of("b");
  ASSERT_LT(std::get<1>(b).z(), -0.5);
  ASSERT_EQ(Add("<block id=\"c\" location=\"(-5,0,0.5)\"/>"), std::nullopt);
  EXPECT_EQ(state_of("a"), a);
  EXPECT_EQ(state_of("b"), b);
  EXPECT_EQ(simulation_->demonstrator().hand(HandName::kLeft).held,
            simulation_->tabletop().Find("a")->body);
  EXPECT_EQ(PositionOf(*simulation_, "c"), Vector3(-0.5, 0, 0.05));
  EXPECT_EQ(simulation_->start_model()->objects().size(), 2u);
  TickSeconds(*simulation_, 1);
  EXPECT_NEAR(PositionOf(*simulation_, "c").z(), 0.05, 1e-4);
}

TEST_F(SpawnTest, AddThenUndoThenRedoLeadsThereAndBack) {
  TickSeconds(*simulation_, 0.1);
  const std::uint64_t before = simulation_->state_hash();
  const std::shared_ptr<const model::Model> model = simulation_->shared_model();
  ASSERT_EQ(Add("<block id=\"c\" location=\"(-5,0,3)\"/>"), std::nullopt);
  EXPECT_EQ(WordsOf(*simulation_->history().current().summary), "added c");
  TickSeconds(*simulation_, 0.1);
  const std::uint64_t after = simulation_->state_hash();
  ASSERT_EQ(simulation_->Apply(Undo()), std::nullopt);
  EXPECT_EQ(simulation_->state_hash(), before);
  EXPECT_EQ(simulation_->shared_model(), model);
  EXPECT_EQ(simulation_->tabletop().Find("c"), nullptr);
  TickSeconds(*simulation_, 0.3);
  ASSERT_EQ(simulation_->Apply(Redo()), std::nullopt);
  EXPECT_EQ(simulation_->state_hash(), after);
  EXPECT_NE(simulation_->tabletop().Find("c"), nullptr);
  // Undone actions use no ids.
  ASSERT_EQ(simulation_->Apply(Undo()), std::nullopt);
  EXPECT_EQ(Add("<block id=\"c\" location=\"(5,0,0.5)\"/>"), std::nullopt);
}

TEST_F(SpawnTest, MechanismsWorkAsThoseOfTheStart) {
  ASSERT_EQ(Add(R"x(<composite id="panel" location="(-5,0,0.5)"><block location="(0,0,0)"/>
      <toggleSwitch id="power" location="(0,0,0.6)"><downstream id="lamp"/></toggleSwitch>
      <indicatorLights id="lamp" location="(0,0.4,0.6)"><state descriptionName="off"/>
      <state descriptionName="on"><light id="0"/></state></indicatorLights></composite>)x"),
            std::nullopt);
  ASSERT_EQ(simulation_->Apply(Trigger{.hand = HandName::kAny, .control = "power"}), std::nullopt);
  const auto lamp = simulation_->model().FindControl("lamp");
  EXPECT_EQ(simulation_->tabletop().controls().states()[*lamp].state, 1);
  ASSERT_EQ(Add("<composite id=\"nut\" location=\"(5,0,0.5)\"><block "
                "location=\"(0,0,0)\"/><hostBondPoint id=\"hole\" "
                "type=\"m\" location=\"(0,0,0.5)\"><tightness location=\"(0,0,0.5)\"/>"
                "</hostBondPoint></composite><composite id=\"screw\" location=\"(5,4,3)\"><block "
                "location=\"(0,0,0)\"/>"
                "<guestBondPoint id=\"tip\" type=\"m\" initBondHostId=\"hole\" "
                "initBondTightness=\"1\"/></composite>"),
            std::nullopt);
  EXPECT_NEAR((PositionOf(*simulation_, "screw") - Vector3(0.5, 0, 0.15)).norm(), 0, 1e-9);
  EXPECT_EQ(simulation_->Apply(Loosen{.hand = HandName::kAny, .object = "screw"}), std::nullopt);
}

TEST_F(SpawnTest, ReportsWhyNothingIsAdded) {
  EXPECT_EQ(RefusalOf("<bloc id=\"c\"/>").substr(0, 53),
            "the objects to add are not a scene: added:1: <bloc id");
  EXPECT_EQ(simulation_->Apply(Spawn{.xml = "{}"})->substr(0, 34),
            "the objects to add are not a scene");
  EXPECT_EQ(RefusalOf("<block id=\"b\" location=\"(5,0,1)\"/>"),
            "the objects to add have ids that were used before: b");
  EXPECT_EQ(RefusalOf("<block id=\"c\" location=\"(0.5,0,1)\"/>"),
            "there is no room for 'c': 'a' is in the way");
  EXPECT_EQ(
      RefusalOf("<block id=\"c\" xspan=\"9\" yspan=\"1\" zspan=\"9\" location=\"(0,0,4.5)\"/>"),
      "there is no room for 'c': 'a' and 'b' are in the way");
  EXPECT_EQ(RefusalOf(""), "there is no object to add");
  EXPECT_EQ(RefusalOf("<camera id=\"c\" location=\"(1,0,1)\" target=\"(0,0,0)\"/>"),
            "a camera cannot be added");
  EXPECT_EQ(RefusalOf("<block id=\"c\" location=\"(5,0,1)\"/>", " metersPerUnit=\"0.2\""),
            "the objects to add have 0.2 meters per unit, expected those of the scene, 0.1");
  EXPECT_EQ(RefusalOf("<block id=\"c\" location=\"(5,0,1)\"/>", " xspan=\"7\""),
            "the objects to add have a table of another size");
  EXPECT_NE(RefusalOf("<customMesh id=\"c\" file=\"scene.stl\"/>").find("not a scene"),
            std::string::npos);
  EXPECT_NE(RefusalOf("<include file=\"/etc/passwd\"/>").find("not a scene"), std::string::npos);
  std::string many;
  for (int i = 0; i <= kCommandSceneLimits.max_objects; ++i)
    many += "<block location=\"(0,0,0)\"/>";
  EXPECT_NE(RefusalOf(many).find("2000"), std::string::npos);
  EXPECT_EQ(RefusalOf(std::string(kMaxSceneText, ' ')), "the objects to add are longer than 1 MiB");
}

TEST_F(SpawnTest, ARefusalListsTenObjectsAtMost) {
  std::string row;
  for (int i = 0; i < 13; ++i) {
    row += "<block id=\"c" + std::to_string(10 + i) + "\" xspan=\"0.5\" location=\"(" +
           std::to_string(i - 6) + ",3,0.5)\"/>";
  }
  ASSERT_EQ(Add(row), std::nullopt);
  EXPECT_EQ(Add(row),
            "the objects to add have ids that were used before: c10, c11, c12, c13, c14, c15, "
            "c16, c17, c18, c19 and 3 more");
}

TEST_F(SpawnTest, RemoveRemovesFreeObjects) {
  ASSERT_FALSE(simulation_->Apply(Grasp{.hand = HandName::kLeft, .object = "a"}));
  EXPECT_EQ(*simulation_->Apply(Remove{.object = "a"}),
            "the left hand holds 'a'; release it first");
  EXPECT_EQ(*simulation_->Apply(Remove{.object = "c"}), "there is no object 'c'");
  const std::uint64_t before = simulation_->state_hash();
  ASSERT_EQ(simulation_->Apply(Remove{.object = "b"}), std::nullopt);
  EXPECT_EQ(simulation_->tabletop().Find("b"), nullptr);
  EXPECT_EQ(WordsOf(*simulation_->history().current().summary), "removed b");
  EXPECT_EQ(Add("<block id=\"b\" location=\"(5,0,1)\"/>"),
            "the objects to add have ids that were used before: b")
      << "an id names one object for ever";
  ASSERT_EQ(simulation_->Apply(Undo()), std::nullopt);
  EXPECT_EQ(simulation_->state_hash(), before);
}

TEST_F(SpawnTest, ClearLeavesWhatIsHeldAndWhatHangsOnIt) {
  Simulation simulation(EverythingScene::Make());
  ASSERT_FALSE(simulation.Apply(Grasp{.hand = HandName::kLeft, .object = "drawer"}));
  ASSERT_FALSE(simulation.Apply(Attend{.hand = HandName::kLeft, .properties = {"color"}}));
  const std::uint64_t before = simulation.state_hash();
  ASSERT_EQ(simulation.Apply(Clear()), std::nullopt);
  std::vector<std::string> left;
  for (const world::Object& object : simulation.tabletop().objects()) {
    if (simulation.tabletop().IsPresent(object)) left.push_back(object.id());
  }
  EXPECT_EQ(left, (std::vector<std::string>{"case", "drawer"}));
  const Event& cleared = simulation.history().current().events.front();
  EXPECT_EQ(cleared.kind, EventKind::kCleared);
  EXPECT_EQ(cleared.objects.size(), simulation.model().objects().size() - 2);
  EXPECT_EQ(*simulation.Apply(Clear()), "nothing to clear");
  TickSeconds(simulation, 0.1);
  ASSERT_EQ(simulation.Apply(Undo()), std::nullopt);
  EXPECT_EQ(simulation.state_hash(), before);
}

TEST_F(SpawnTest, AStateWithAddedObjectsContinuesInAFreshSimulation) {
  ASSERT_EQ(Add("<block id=\"c\" location=\"(-5,0,2)\"/>"), std::nullopt);
  ASSERT_EQ(simulation_->Apply(Remove{.object = "a"}), std::nullopt);
  TickSeconds(*simulation_, 0.1);
  const SimulationState state = simulation_->Save();
  Simulation fresh(simulation_->start_model()), grown(simulation_->shared_model());
  for (Simulation* other : {&fresh, &grown}) {
    other->Restore(state);
    EXPECT_EQ(other->state_hash(), simulation_->state_hash());
    EXPECT_NE(other->tabletop().Find("c"), nullptr);
  }
  ASSERT_EQ(Add("<block id=\"d\" location=\"(5,0,2)\"/>"), std::nullopt);
  TickSeconds(*simulation_, 0.5);
  for (Simulation* other : {&fresh, &grown}) {
    ASSERT_EQ(other->Apply(SpawnOf("<block id=\"d\" location=\"(5,0,2)\"/>")), std::nullopt);
    TickSeconds(*other, 0.5);
    EXPECT_EQ(other->state_hash(), simulation_->state_hash());
  }
}

TEST_F(SpawnTest, ReadyMadeObjectsGoToFreeSpace) {
  struct Ear : Listener {
    void OnCommand(const Simulation&, const Command& command) override { log.push_back(command); }
    std::vector<Command> log;
  } ear;
  simulation_->AddListener(&ear);
  ScriptPlayer player(
      ParseScript("{\"do\": \"add\", \"preset\": \"stack_3\", \"seed\": 3}\n"
                  "{\"do\": \"add\", \"preset\": \"stack_3\", \"seed\": 3}\n"
                  "{\"do\": \"add\", \"preset\": \"ring\"}\n"
                  "{\"do\": \"remove\", \"object\": \"ring_1\"}",
                  "demo.jsonl", scene::kMetersPerUnit));
  player.Advance(simulation_.get());
  EXPECT_TRUE(player.is_finished());
  ASSERT_EQ(ear.log.size(), 4u);
  EXPECT_TRUE(std::holds_alternative<Spawn>(ear.log[0]));
  EXPECT_EQ(simulation_->model().objects().size(), 2u + 3 + 3 + 1);
  EXPECT_EQ(simulation_->tabletop().Find("ring_1"), nullptr);
  EXPECT_NE(simulation_->tabletop().Find("smallblock_6"), nullptr);
  Refusal refusal;
  const auto placed = sim::SpawnOf(sim::Add{.preset = "big_block", .p_WQ = Vector3(-0.6, 0.3, 0)},
                                   *simulation_, &refusal);
  ASSERT_TRUE(placed) << refusal;
  ASSERT_EQ(simulation_->Apply(*placed), std::nullopt);
  EXPECT_LT((PositionOf(*simulation_, simulation_->tabletop().objects().back().id()) -
             Vector3(-0.6, 0.3, 0))
                .head<2>()
                .norm(),
            1e-9);
  EXPECT_EQ(sim::SpawnOf(sim::Add{.preset = "tower"}, *simulation_, &refusal), std::nullopt);
  EXPECT_EQ(refusal.substr(0, 31), "\"preset\" is \"tower\", expected b");
}

TEST_F(SpawnTest, AStateWithAddedObjectsIsRestoredWithTheRobot) {
  simulation_ = MakeSimulation({BlockAt("a", {0, 0, 0.05})}, /*with_robot=*/true);
  ASSERT_EQ(Add("<block id=\"c\" location=\"(-5,2,2)\"/>"), std::nullopt);
  TickSeconds(*simulation_, 0.1);
  Simulation fresh(simulation_->start_model());
  fresh.Restore(simulation_->Save());
  for (int i = 0; i < 10; ++i) {
    fresh.Tick();
    simulation_->Tick();
  }
  EXPECT_EQ(fresh.state_hash(), simulation_->state_hash());
}

class SpawnProperty : public SimulationFixture, public ::testing::WithParamInterface<unsigned> {};

INSTANTIATE_TEST_SUITE_P(Seeds, SpawnProperty, testing::Range(31u, 34u));

TEST_P(SpawnProperty, AddingAndRemovingObjectsReplays) {
  Simulation simulation(EverythingScene::Make());
  RandomHands hands(GetParam(), /*changes_objects=*/true);
  std::map<std::size_t, int> num_done;
  for (int i = 0; i < 250; ++i) {
    const Command command = hands.Next(simulation);
    const std::uint64_t before = simulation.state_hash();
    if (simulation.Apply(command)) {
      ASSERT_EQ(simulation.state_hash(), before) << "a refused command changed something";
    } else {
      ++num_done[command.index()];
    }
    if (i % 3 == 0) simulation.Tick();
  }
  EXPECT_GT(num_done[Command(Spawn{}).index()], 3);
  EXPECT_GT(num_done[Command(Remove{}).index()], 0);
  // A model depends on its scene only, not on the scene's history; and a scene can be written.
  const std::string xml = scene_xml::WriteScene(simulation.scene());
  EXPECT_EQ(scene_xml::ReadSceneText(xml, "everything.xml").scene->objects.size(),
            simulation.scene().objects.size());
  Simulation again(simulation.start_model());
  for (const TimedCommand& timed : simulation.history().CommandsDone()) {
    while (again.tick() < timed.tick) again.Tick();
    ASSERT_EQ(again.Apply(timed.command), std::nullopt);
  }
  while (again.tick() < simulation.tick()) again.Tick();
  EXPECT_EQ(again.state_hash(), simulation.state_hash());
  EXPECT_EQ(again.scene(), simulation.scene());
}

}  // namespace
}  // namespace smile::sim
