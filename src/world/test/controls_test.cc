#include "world/controls.h"

#include <gtest/gtest.h>

#include <random>

namespace smile::world {
namespace {

using scene::CustomControl;
using scene::IndicatorLights;
using scene::Part;
using scene::ToggleSwitch;

using model::ControlIndex;
using scene::ObjectSpec;

ObjectSpec ObjectWith(Part control) {
  ObjectSpec spec;
  spec.whole = std::move(control);
  return spec;
}

/// Controls with their own model.
class Panel {
 public:
  explicit Panel(std::vector<ObjectSpec> objects)
      : model_({.objects = std::move(objects)}), controls_(model_) {}

  std::string Trigger(std::size_t control, std::string_view part) {
    return controls_.Trigger(ControlIndex(control), part).value_or("");
  }
  void Set(std::size_t control, int state) { controls_.Set(ControlIndex(control), state); }
  void Override(std::size_t control, int state) {
    controls_.Override(ControlIndex(control), state);
  }
  const model::Model& model() const { return model_; }
  const std::vector<ControlState>& states() const { return controls_.states(); }

 private:
  model::Model model_;
  Controls controls_;
};

ObjectSpec Switch(const std::string& id, int num_states, std::vector<std::string> downstream,
                  int initial_state = 0, bool is_left_pressed = true) {
  return ObjectWith({.id = id,
                     .shape = ToggleSwitch{.is_left_pressed = is_left_pressed,
                                           .num_states = num_states,
                                           .initial_state = initial_state,
                                           .downstream = std::move(downstream)}});
}

ObjectSpec Lights(const std::string& id, std::vector<std::string> names,
                  std::vector<std::string> downstream, int initial_state = 0) {
  IndicatorLights lights{.initial_state = initial_state, .downstream = std::move(downstream)};
  for (std::string& name : names) lights.states.push_back({.name = std::move(name), .lights = {}});
  return ObjectWith({.id = id, .shape = lights});
}

/// A switch of three states drives a lamp of three, which drives one of two.
Panel TrafficLights() {
  return Panel({Switch("S1", 3, {"L1"}, 0, false), Lights("L1", {"stop", "caution", "go"}, {"L2"}),
                Lights("L2", {"red", "dark"}, {})});
}

std::vector<std::string> Recorded(const Panel& panel) {
  std::vector<std::string> states;
  for (ControlIndex i : panel.model().controls()) {
    states.push_back(RecordedState(panel.model().control(i), panel.states()[i]));
  }
  return states;
}

using Words = std::vector<std::string>;

TEST(Controls, PassTheirStateOnWhereItExists) {
  Panel controls = TrafficLights();
  EXPECT_EQ(Recorded(controls), (Words{"1", "stop", "red"}));
  EXPECT_EQ(controls.Trigger(0, "S1-b1"), "");
  EXPECT_EQ(Recorded(controls), (Words{"0", "caution", "dark"}));
  EXPECT_EQ(controls.Trigger(0, ""), "");
  EXPECT_EQ(Recorded(controls), (Words{"1", "go", "dark"})) << "L2 has no third state";
  EXPECT_EQ(controls.Trigger(0, ""), "");
  EXPECT_EQ(Recorded(controls), (Words{"0", "stop", "red"}));
}

TEST(Controls, AreSetByThoseUpstreamAtTheStart) {
  const Panel controls({Lights("lamp", {"off", "on"}, {}, 1), Switch("S", 2, {"lamp"}, 0)});
  EXPECT_EQ(Recorded(controls), (Words{"off", "0"}));
}

TEST(Controls, ThatCannotBeTriggeredReportIt) {
  Panel controls = TrafficLights();
  EXPECT_EQ(controls.Trigger(1, ""),
            "'L1' is a row of lights: it follows other controls and cannot be triggered");
  EXPECT_EQ(controls.Trigger(0, "S1-b2"), "'S1-b2' is already pressed; press 'S1-b1'");
  EXPECT_EQ(controls.Trigger(0, "left"), "'S1' has no button 'left', expected S1-b1 or S1-b2");
  EXPECT_EQ(Recorded(controls), (Words{"1", "stop", "red"})) << "a refusal changes nothing";
}

TEST(Controls, ShowWhatABondForcesUponThemAndPassItOn) {
  Panel controls = TrafficLights();
  controls.Override(1, 2);
  EXPECT_EQ(Recorded(controls)[1], "go");
  EXPECT_EQ(VariantOf(controls.model().control(ControlIndex(1)), controls.states()[1]), 2);
  controls.Set(1, 1);
  EXPECT_EQ(Recorded(controls)[1], "go") << "the state beneath changes silently";
  controls.Override(1, -1);
  EXPECT_EQ(Recorded(controls), (Words{"1", "caution", "red"}));
}

/// A dial: pressing the pointer leads on, the face leads back, the rim leads nowhere.
ObjectSpec Dial() {
  const auto part = [](const char* id, std::optional<int> next,
                       scene::Shape shape = scene::Block{}) {
    return Part{.id = id, .next_state = next, .shape = std::move(shape)};
  };
  CustomControl dial{.name = "dial"};
  for (int state = 0; state < 3; ++state) {
    scene::Composite group;
    group.parts = {part("hand", (state + 1) % 3), part("face", std::nullopt), part("rim", -1)};
    dial.states.push_back(
        {.name = state == 1 ? "middle" : "", .parts = {part("group", (state + 2) % 3, group)}});
  }
  return ObjectWith({.id = "dial", .shape = dial});
}

TEST(CustomControl, ChangesToTheStateOfTheTriggeredPartOrItsParent) {
  Panel controls({Dial()});
  EXPECT_EQ(controls.Trigger(0, "hand"), "");
  EXPECT_EQ(Recorded(controls), Words{"middle"});
  EXPECT_EQ(controls.Trigger(0, "face"), "") << "what the composite around it says";
  EXPECT_EQ(Recorded(controls), Words{"0"});
  EXPECT_EQ(controls.Trigger(0, "rim"),
            "nothing would happen: 'rim' is not a part of 'dial' in its present state, or leads to "
            "no state");
  EXPECT_EQ(controls.Trigger(0, ""),
            "parts of 'dial' lead to different states; name one: 'face', 'group' or 'hand'");
}

TEST(Controls, EndWithAnyWiring) {
  std::mt19937 random(7);
  for (int round = 0; round < 200; ++round) {
    const int count = 2 + static_cast<int>(random() % 6);
    std::vector<ObjectSpec> objects;
    for (int i = 0; i < count; ++i) {
      std::vector<std::string> downstream;
      for (int k = static_cast<int>(random() % 4); k > 0; --k) {
        downstream.push_back("c" + std::to_string(random() % static_cast<unsigned>(count)));
      }
      objects.push_back(Switch("c" + std::to_string(i), 2 + static_cast<int>(random() % 3),
                               std::move(downstream)));
    }
    Panel controls(objects);
    for (int k = 0; k < 20; ++k) {
      const auto control = random() % static_cast<unsigned>(count);
      if (random() % 3 == 0) controls.Override(control, static_cast<int>(random() % 4) - 1);
      ASSERT_EQ(controls.Trigger(control, ""), "");
      for (ControlIndex i : controls.model().controls()) {
        const int state = controls.states()[i].state;
        const int num_states = scene::NumStatesOf(*controls.model().control(i).part);
        ASSERT_TRUE(state >= 0 && state < num_states);
      }
    }
  }
}

TEST(Controls, DriveOneAnotherThroughAVeryLongLine) {
  std::vector<ObjectSpec> objects;
  constexpr int kCount = 20'000;
  for (int i = 0; i < kCount; ++i) {
    objects.push_back(Switch("c" + std::to_string(i), 2, {"c" + std::to_string(i + 1)}));
  }
  Panel controls(objects);
  EXPECT_EQ(controls.Trigger(0, ""), "");
  EXPECT_EQ(controls.states().back().state, 1);
}

}  // namespace
}  // namespace smile::world
