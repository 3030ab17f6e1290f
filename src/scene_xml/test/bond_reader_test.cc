#include <gtest/gtest.h>

#include "scene_xml/scene_writer.h"
#include "scene_xml/test/scene_text.h"

namespace smile::scene_xml {
namespace {

std::string Body(const std::string& points) {
  return "<composite location='(0,0,0)'>" + points + "</composite>\n";
}

/// A host H with two stages.
std::string HostBody(const std::string& attributes = "") {
  return Body("<hostBondPoint id='H' type='M3' " + attributes +
              "><tightness location='(0,0,1)' downstreamState='1'/>"
              "<tightness downstreamLock='1'/></hostBondPoint>");
}

std::string GuestBody(const std::string& attributes, const std::string& type = "M3") {
  return Body("<guestBondPoint type='" + type + "' " + attributes + "/>");
}

std::string FaultOfBond(const std::string& guest) { return FaultOf(SceneText(guest + HostBody())); }

TEST(BondReader, ReadsGuestsHostsAndStages) {
  const scene::SceneSpec scene = MustRead(
      SceneText(GuestBody("id='G' location='(0,0,-1)' initBondHostId='H' initBondTightness='2' "
                          "downstream='ignored'") +
                HostBody("downstream='L' downstreamOverride='L' downstreamLock='H'") +
                "<toggleSwitch id='L' location='(0,0,0)'/>"));
  const auto& guest = std::get<scene::Composite>(scene.objects[0].whole.shape).guests.at(0);
  EXPECT_EQ(guest, (scene::GuestPoint{"G", "M3", RigidTransform(Vector3(0, 0, -0.1)), "H", 2}));
  const auto& host = std::get<scene::Composite>(scene.objects[1].whole.shape).hosts.at(0);
  EXPECT_EQ(host.downstream + host.downstream_override + host.downstream_lock, "LLH");
  EXPECT_EQ(host.stages,
            (std::vector<scene::TightnessStage>{{RigidTransform(Vector3(0, 0, 0.1)), 1, false},
                                                {RigidTransform(), std::nullopt, true}}));
  EXPECT_TRUE(MustRead(WriteScene(scene)) == scene);
}

TEST(BondReader, GivesPointsIdsInTheOrderOfTheFile) {
  const std::string connector =
      "<composite id='connector' location='(0,0,0)'><guestBondPoint id='plug' type='a'/>"
      "<guestBondPoint id='plug' type='a'/><hostBondPoint id='hole' type='a'><tightness/>"
      "</hostBondPoint><hostBondPoint id='hole' type='a'><tightness/></hostBondPoint></composite>";
  const scene::SceneSpec scene = MustRead(SceneText(connector + connector + connector));
  EXPECT_EQ(scene.objects[0].id() + " " + scene.objects[1].id() + " " + scene.objects[2].id(),
            "connector connector#2 connector#7");
  const auto& points = std::get<scene::Composite>(scene.objects[1].whole.shape);
  EXPECT_EQ(points.guests[0].id + " " + points.guests[1].id, "plug#3 plug#4");
  EXPECT_EQ(points.hosts[0].id + " " + points.hosts[1].id, "hole#5 hole#6");
}

TEST(BondReader, TakesPointsAndStagesFromTemplates) {
  const scene::SceneSpec scene = MustRead(SceneText(
      "<def name='thread'><tightness location='(0,0,$z$)'/><tightness/></def>"
      "<def name='hole'><hostBondPoint type='M3'><instance def='thread'><var name='z' value='2'/>"
      "</instance></hostBondPoint></def>" +
      Body("<instance def='hole'/><instance def='hole'/>")));
  const auto& hosts = std::get<scene::Composite>(scene.objects[0].whole.shape).hosts;
  ASSERT_EQ(hosts.size(), 2u);
  EXPECT_EQ(hosts[1].id, "obj#1");
  ASSERT_EQ(hosts[1].stages.size(), 2u);
  EXPECT_EQ(hosts[1].stages[0].X_HS, RigidTransform(Vector3(0, 0, 0.2)));
}

TEST(BondFaults, ReportWhyABondIsImpossible) {
  EXPECT_EQ(FaultOfBond(GuestBody("initBondHostId='H'")),
            "test.xml:3: <guestBondPoint>: found the default of initBondTightness, expected 1 or "
            "more with an initBondHostId: at 0 they are not fastened");
  EXPECT_EQ(FaultOfBond(GuestBody("initBondHostId='H' initBondTightness='3'")),
            "test.xml:3: <guestBondPoint>: found initBondTightness=\"3\", expected 1 to 2, the "
            "stages of hostBondPoint H");
  EXPECT_EQ(FaultOfBond(GuestBody("initBondHostId='H' initBondTightness='1'", "M4")),
            "test.xml:3: <guestBondPoint>: found type=\"M4\", expected \"M3\", the type of "
            "hostBondPoint H");
  EXPECT_EQ(FaultOfBond(GuestBody("id='h' initBondHostId='h' initBondTightness='1'")),
            "test.xml:3: <guestBondPoint id=\"h\">: found initBondHostId=\"h\", expected the id of "
            "a hostBondPoint in this scene; did you mean \"H\"?");
  const std::string bond = GuestBody("initBondHostId='H' initBondTightness='1'");
  EXPECT_EQ(FaultOfBond(bond + bond),
            "test.xml:4: <guestBondPoint>: found initBondHostId=\"H\", expected a hostBondPoint "
            "that holds no other guest");
}

TEST(BondFaults, RefuseBondsOfObjectsThatAreConnected) {
  const auto body = [](const std::string& host_id, const std::string& bonds_to) {
    return Body("<hostBondPoint id='" + host_id + "' type='a'><tightness/></hostBondPoint>" +
                "<guestBondPoint type='a' initBondHostId='" + bonds_to +
                "' initBondTightness='1'/>");
  };
  EXPECT_EQ(FaultOf(SceneText(body("A", "A"))),
            "test.xml:3: <guestBondPoint>: found initBondHostId=\"A\", expected a hostBondPoint of "
            "another object");
  EXPECT_EQ(FaultOf(SceneText(body("A", "B") + body("B", "C") + body("C", "A"))),
            "test.xml:5: <guestBondPoint>: found initBondHostId=\"A\", expected objects that no "
            "other bonds connect");
}

TEST(BondFaults, NameTheStageThatForcesAStateThatIsNone) {
  EXPECT_EQ(FaultOf(SceneText(HostBody("downstreamOverride='L'") +
                              "<toggleSwitch id='L' numStates='1' location='(0,0,0)'/>")),
            "test.xml:3: <hostBondPoint id=\"H\">: found downstreamState=\"1\" in tightness 1, "
            "expected a state of L, from 0 to 0");
}

TEST(BondFaults, ReportWhatBondPointsRequire) {
  EXPECT_EQ(FaultOf(SceneText(Body("<hostBondPoint type='a'/>"))),
            "test.xml:3: <hostBondPoint>: found 0 tightness elements, expected 1 to 256");
  EXPECT_EQ(FaultOf(SceneText(Body("<guestBondPoint/>"))),
            "test.xml:3: <guestBondPoint>: found no type, expected type=\"…\"");
  EXPECT_NE(FaultOf(SceneText(Body("<guestBondPoint type='a b'/>"))).find("expected a word"),
            std::string::npos);
  EXPECT_NE(FaultOf(SceneText("<guestBondPoint type='a'/>"))
                .find("found an element that does not belong"),
            std::string::npos)
      << "bond points are parts of composites";
}

}  // namespace
}  // namespace smile::scene_xml
