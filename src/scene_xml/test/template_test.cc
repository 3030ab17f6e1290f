#include <gtest/gtest.h>

#include "scene_xml/scene_writer.h"
#include "scene_xml/test/scene_text.h"

namespace smile::scene_xml {
namespace {

/// The text of the description `note` of each object.
std::vector<std::string> NotesOf(const std::string& content) {
  std::vector<std::string> notes;
  for (const scene::ObjectSpec& object : MustRead(SceneText(content)).objects) {
    for (const scene::Description& description : object.descriptions) {
      if (description.name == "note") notes.push_back(description.value);
    }
  }
  return notes;
}

/// An object that shows a text.
std::string Note(const std::string& text) {
  return "<block location='(0,0,0)'><description name='note' value='" + text + "'/></block>";
}
std::string Var(const std::string& name, const std::string& value, bool is_derived = false) {
  return "<var name='" + name + "' value='" + value + "'" +
         (is_derived ? " derived='true'/>" : "/>");
}
std::string Def(const std::string& name, const std::string& content) {
  return "<def name='" + name + "'>" + content + "</def>\n";
}
std::string Instance(const std::string& def, const std::string& variables = "") {
  return "<instance def='" + def + "'>" + variables + "</instance>\n";
}

using Texts = std::vector<std::string>;

TEST(Template, ReplacesItsInstance) {
  const scene::SceneSpec scene = MustRead(
      SceneText("<block id='before' location='(0,0,0)'/>"
                "<instance def='pair'><var name='id' value='p'/></instance>"
                "<composite id='whole' location='(0,0,0)'><instance def='pair'/></composite>"
                "<def name='pair'><var name='id' value='part'/>"
                "<block id='$id$1' location='(0,0,0)'/><block id='$id$2' location='(0,0,0)'/>"
                "</def><block id='after' location='(0,0,0)'/>"));
  ASSERT_EQ(scene.objects.size(), 5u);
  EXPECT_EQ(scene.objects[1].id(), "p1");
  EXPECT_EQ(scene.objects[2].id(), "p2");
  EXPECT_EQ(scene.objects[4].id(), "after");
  const auto& whole = std::get<scene::Composite>(scene.objects[3].whole.shape);
  ASSERT_EQ(whole.parts.size(), 2u);
  EXPECT_EQ(whole.parts[1].id, "part2");
}

TEST(Template, PrefersTheInstanceThenTheDefaultThenWhatIsAround) {
  const std::string inner =
      Def("inner", Var("b", "default") + Var("c", "default") + Note("$a$ $b$ $c$"));
  const std::string outer =
      Def("outer", Var("a", "around") + Var("b", "around") + Var("c", "around") +
                       Instance("inner", Var("c", "given")));
  EXPECT_EQ(NotesOf(inner + outer + Instance("outer")), Texts{"around default given"});
}

TEST(Template, EvaluatesAnInstancesValueOutsideAndADerivedOneInside) {
  const std::string def = Def("t", Var("len", "1") + Var("p", "none") + Note("$p$"));
  EXPECT_EQ(NotesOf(def + Instance("t", Var("p", "$len*2$", true))), Texts{"2"});
  EXPECT_EQ(NotesOf(def + Def("outer", Var("len", "7") + Instance("t", Var("p", "$len*2$"))) +
                    Instance("outer")),
            Texts{"14"});
  EXPECT_EQ(FaultOf(SceneText(def + Instance("t", Var("p", "$len*2$")))),
            "test.xml:4: <var name=\"p\">: found value=\"$len*2$\" with the unknown variable "
            "\"len\", expected one of the instance, of its def or of an instance around it");
}

TEST(Template, EvaluatesVariablesInTheOrderTheyNeedEachOther) {
  EXPECT_EQ(NotesOf(Def("t", Var("a", "$b*2$", true) + Var("b", "$c+1$", true) + Var("c", "3") +
                                 Var("loc", "(0,0,$a$)") + Note("$loc$")) +
                    Instance("t") + Instance("t", Var("c", "5"))),
            (Texts{"(0,0,8)", "(0,0,12)"}));
}

TEST(Template, MeansTheVariableAroundWhenAValueNamesItself) {
  EXPECT_EQ(NotesOf(Def("leaf", Var("id", "$id$Leaf", true) + Note("$id$")) +
                    Def("twig", Instance("leaf", Var("id", "$id$Twig")) + Instance("leaf")) +
                    Instance("twig", Var("id", "A"))),
            (Texts{"ATwig", "ALeaf"}));
}

TEST(Template, TakesTheNameOfATemplateFromAVariable) {
  EXPECT_EQ(NotesOf(Def("red", Note("r")) + Def("blue", Note("b")) +
                    Def("any", Instance("$kind$")) + Instance("any", Var("kind", "blue"))),
            Texts{"b"});
}

TEST(Template, IgnoresUnusedVariables) {
  EXPECT_EQ(NotesOf(Def("t", Note("n")) + Instance("t", Var("rocation", "(90, 0, 90)"))),
            Texts{"n"});
}

TEST(Template, CountsTheLaterOfTwoValues) {
  EXPECT_EQ(NotesOf(Def("t", Var("a", "1") + Var("a", "2") + Note("$a$ $b$")) +
                    Instance("t", Var("b", "3") + Var("b", "4"))),
            Texts{"2 4"});
}

TEST(Template, KeepsTheRulesOfIds) {
  const scene::SceneSpec scene =
      MustRead(SceneText(Def("t", "<block id='a' location='(0,0,0)'/>") + Instance("t") +
                         Instance("t") + "<block location='(0,0,0)'/>" + Instance("t")));
  Texts ids;
  for (const scene::ObjectSpec& object : scene.objects) ids.push_back(object.id());
  EXPECT_EQ(ids, (Texts{"a", "a#0", "obj", "a#1"}));
}

TEST(Template, EvaluatesOutsideOfTemplates) {
  EXPECT_EQ(NotesOf(Note("$1+1$ for $5")), Texts{"2 for $5"});
}

TEST(Template, MeansTheSameWhenWrittenAndReadAgain) {
  const scene::SceneSpec scene =
      MustRead(SceneText(Def("t", Var("x", "1/3") + "<block location='($x$,0,0.5)'><description "
                                                    "name='price' value='$p$'/></block>") +
                         Instance("t", Var("x", "$1/3$") + Var("p", "5$"))));
  EXPECT_TRUE(MustRead(WriteScene(scene)).objects == scene.objects);
}

TEST(Template, LeavesATraceOfWhereEachObjectCameFrom) {
  const SceneReading reading = ReadSceneText(
      SceneText("<def name='t'>\n<block location='(0,0,0)'/></def>\n<instance def='t'/>\n"
                "<block location='(0,0,0)'/>"),
      "a--b.xml");
  EXPECT_EQ(reading.origins, (Texts{"a--b.xml:4 (in the instance at a--b.xml:5)", "a--b.xml:6"}));
  const std::string text = WriteScene(*reading.scene, reading.origins);
  EXPECT_NE(text.find("\n  <!-- a- -b.xml:4 (in the instance at a- -b.xml:5) -->\n  <block"),
            std::string::npos)
      << text;
  EXPECT_TRUE(MustRead(text).objects == reading.scene->objects);
}

TEST(TemplateFaults, NameTheTemplateAndTheInstance) {
  EXPECT_EQ(
      FaultsOf(SceneText("<def name='cube'>\n<block location='(0,0,0)' colour='$color$'/>\n</def>\n"
                         "<instance def='cube'/>\n<instance def='cube'/>\n<instance def='cub'/>")),
      (Texts{"test.xml:4: <block>: found colour=\"$color$\" with the unknown variable \"color\", "
             "expected one of the instance, of its def or of an instance around it (in the "
             "instance at test.xml:6)",
             "test.xml:4: <block>: found attribute \"colour\", expected centerOfMass, color, "
             "friction, id, "
             "location, mass, pointable, restitution, rollingFriction, rotation, rotationMatrix, "
             "xspan, yspan or zspan; did you mean \"color\"? "
             "(in the instance at test.xml:6)",
             "test.xml:8: <instance def=\"cub\">: found def=\"cub\", expected the name of a def "
             "in this scene; did you mean \"cube\"?"}));
}

TEST(TemplateFaults, AlsoNameTheOutermostInstance) {
  EXPECT_EQ(FaultOf(SceneText("<def name='a'>\n<block location='$at$'/></def>\n"
                              "<def name='b'>\n<instance def='a'/></def>\n"
                              "<def name='c'>\n<instance def='b'/></def>\n"
                              "<instance def='c'><var name='at' value='here'/></instance>")),
            "test.xml:4: <block>: found location=\"here\", expected (x,y,z), three numbers from "
            "-1000000 to 1000000 (in the instance at test.xml:6, within that at test.xml:9)");
}

TEST(TemplateFaults, AreReportedOnceForAVariableAndItsUses) {
  EXPECT_EQ(FaultOf(SceneText("<def name='t'><var name='a' value='$nothing$'/>\n"
                              "<var name='b' value='$a*2$'/>\n"
                              "<block xspan='$a$' yspan='$b$' location='($b$,0,0)'/></def>\n"
                              "<instance def='t'/>")),
            "test.xml:3: <var name=\"a\">: found value=\"$nothing$\" with the unknown variable "
            "\"nothing\", expected one of the instance, of its def or of an instance around it "
            "(in the instance at test.xml:6)");
}

TEST(TemplateFaults, NameTheCircle) {
  EXPECT_EQ(
      FaultOf(SceneText("<def name='a'>\n<instance def='b'/></def>\n"
                        "<def name='b'>\n<instance def='a'/></def>\n<instance def='a'/>")),
      "test.xml:6: <instance def=\"a\">: found templates that contain each other in a cycle (a, b, "
      "a), expected an end (in the instance at test.xml:4, within that at test.xml:7)");
  EXPECT_EQ(
      FaultOf(SceneText("<def name='t'><var name='a' value='$b$'/>\n"
                        "<var name='b' value='$a$'/></def><instance def='t'/>")),
      "test.xml:3: <var name=\"a\">: found variables that depend on each other in a cycle (a, b, "
      "a), expected one of them to have a value of its own (in the instance at test.xml:4)");
}

TEST(TemplateFaults, NameASecondDefAndMisplacedOnes) {
  EXPECT_EQ(
      FaultsOf(SceneText("<def name='a'/>\n<def name='a'/>\n<var name='x' value='1'/>\n"
                         "<composite location='(0,0,0)'>\n<def name='b'/>\n"
                         "<include file='x.xml'/></composite>\n<def/>\n"
                         "<instance def='a' id='x'><block/></instance>")),
      (Texts{"test.xml:4: <def name=\"a\">: found a second def of this name, expected one; "
             "the first is at test.xml:3",
             "test.xml:5: <var name=\"x\">: found this element here, expected it directly "
             "in a def or an instance",
             "test.xml:7: <def name=\"b\">: found this element here, expected it directly "
             "in <tabletop>",
             "test.xml:8: <include>: found this element here, expected it directly in "
             "<tabletop>",
             "test.xml:9: <def>: found no name, expected name=\"…\"",
             "test.xml:10: <instance def=\"a\">: found attribute \"id\", expected def",
             "test.xml:10: <block>: found an element that does not belong here, expected var"}));
}

TEST(TemplateFaults, SuggestTheWordsOfTheLanguage) {
  EXPECT_TRUE(FaultOf(SceneText("<instanc def='a'/>")).ends_with("did you mean \"instance\"?"));
}

TEST(HostileTemplates, CannotMakeMoreElementsThanTheLimit) {
  std::string bomb = Def("t0", "<block location='(0,0,0)'/>");
  for (int i = 1; i <= 10; ++i) {
    std::string content;
    for (int k = 0; k < 10; ++k) content += Instance("t" + std::to_string(i - 1));
    bomb += Def("t" + std::to_string(i), content);
  }
  const std::string fault = FaultOf(SceneText(bomb + Instance("t10")));
  EXPECT_NE(fault.find("found more than 100000 elements out of templates, expected fewer"),
            std::string::npos)
      << fault;
}

TEST(HostileTemplates, CannotMakeMoreTextThanTheLimit) {
  std::string variables = Var("v0", std::string(1'000, 'x'));
  for (int i = 1; i < 40; ++i) {
    const std::string before = "$v" + std::to_string(i - 1) + "$";
    variables += Var("v" + std::to_string(i), before + before);
  }
  EXPECT_NE(
      FaultOf(SceneText(Def("t", variables) + Instance("t"))).find("exceeds the limits of a scene"),
      std::string::npos);
  std::string instances;
  for (int i = 0; i < 2'000; ++i) instances += Instance("t");
  EXPECT_NE(FaultOf(SceneText(Def("t", Note(std::string(100'000, 'x'))) + instances))
                .find("found more than 33554432 bytes out of templates"),
            std::string::npos);
}

TEST(HostileTemplates, CannotGoDeeperThanTheLimits) {
  std::string defs = Def("t0", "<block location='(0,0,0)'/>");
  for (int i = 1; i <= 100; ++i) {
    defs += Def("t" + std::to_string(i), Instance("t" + std::to_string(i - 1)));
  }
  MustRead(SceneText(defs + Instance("t63")));
  EXPECT_NE(FaultOf(SceneText(defs + Instance("t64"))).find("more than 64 instances inside"),
            std::string::npos);

  std::string open, close, deep;
  for (int i = 0; i < 90; ++i) open += "<composite location='(0,0,0)'>", close += "</composite>";
  deep = Def("a", open + "<block location='(0,0,0)'/>" + close) +
         Def("b", open + Instance("a") + close) + Def("c", open + Instance("b") + close);
  MustRead(SceneText(deep + Instance("b")));
  EXPECT_NE(FaultOf(SceneText(deep + Instance("c"))).find("more than 256 elements inside"),
            std::string::npos);

  std::string chain = Var("v0", "1");
  for (int i = 1; i <= 1'000; ++i) {
    chain += Var("v" + std::to_string(i), "$v" + std::to_string(i - 1) + "$");
  }
  MustRead(SceneText(Def("t", chain) + Instance("t")));
  std::string backwards = Var("v999", "1");
  for (int i = 0; i < 999; ++i) {
    backwards += Var("v" + std::to_string(i), "$v" + std::to_string(i + 1) + "$");
  }
  EXPECT_FALSE(FaultsOf(SceneText(Def("t", backwards) + Instance("t"))).empty());
}

}  // namespace
}  // namespace smile::scene_xml
