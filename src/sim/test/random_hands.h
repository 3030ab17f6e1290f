#pragma once

#include <optional>
#include <random>
#include <string>
#include <vector>

#include "sim/drag.h"
#include "sim/simulation.h"

namespace smile::sim {

/// Random commands of hands in an EverythingScene.
class RandomHands {
 public:
  /// @param changes_objects  adds, removes, moves and clears objects, too.
  explicit RandomHands(unsigned seed, bool changes_objects = false)
      : random_(seed), changes_objects_(changes_objects) {}

  Command Next(const Simulation& simulation) {
    if (changes_objects_ && random_() % 6 == 0) return NextChange(simulation);
    // Mostly two of them, so that they hold what the other wants; `any` is free for mechanisms.
    using enum HandName;
    const HandName hand = Pick(std::vector{kLeft, kLeft, kLeft, kRight, kRight, kRight, kBoth});
    const std::string object = AnObject(simulation);
    switch (random_() % 17) {
      case 0:
      case 1:
        // The panel stays: without it there are no controls.
        return Grasp{.hand = hand, .object = object == "panel" ? "ball" : object};
      case 2:
        return MoveTo{.hand = hand, .p_WH = {Uniform(0.6), Uniform(0.4), 0.1 + Uniform(0.1)}};
      case 3:
        return Rotate{.hand = hand, .angles_deg = {Uniform(90), Uniform(90), Uniform(90)}};
      case 4:
        return Release{.hand = hand};
      case 5:
        return Trigger{.hand = kAny,
                       .control = Pick(std::vector<std::string>{"power", "lamps", "dial"})};
      case 6:
        return Fasten{.hand = kAny, .object = Pick(kScrews)};
      case 7:
        return Loosen{.hand = kAny, .object = Pick(kScrews)};
      case 8:
        return Point{.hand = hand, .part = object};
      case 9:
        return Plane{.hand = hand, .angle_deg = Uniform(180)};
      case 10: {
        const double x = Uniform(0.5);
        const Drag drag{.hand = hand,
                        .p_WOrigin = {x, -1.5, 0.8},
                        .direction_in_world = {Uniform(0.3), 1, -0.4 + Uniform(0.1)},
                        .is_level = x > 0.1};
        Refusal refusal;
        return MoveOf(drag, simulation, &refusal).value_or(MoveTo{.hand = hand});
      }
      case 11:
        return Attend{.hand = HeldBy(kLeft, simulation).empty() ? kRight : kLeft,
                      .properties = {Pick(kProperties), Pick(kProperties)}};
      case 12:
        return Grasp{.hand = hand == kLeft ? kRight : kLeft, .object = HeldBy(hand, simulation)};
      case 13:
      case 14:
        if (const auto holder = HandWithTool(simulation)) {
          return Use{.hand = *holder, .loosens = random_() % 2 == 0};
        }
        return Grasp{.hand = hand, .object = ATool(simulation)};
      case 15:  // off the table
        return MoveTo{.hand = hand, .p_WH = {Uniform(2) < 0 ? -1.3 : 1.3, Uniform(0.4), 0.2}};
      default:
        if (random_() % 4 == 0) return Destroy{.hand = hand};
        return MoveTo{.hand = hand, .p_WH = {Uniform(0.6), Uniform(0.4), 0.2}, .speed = 0.3};
    }
  }

 private:
  std::string AnObject(const Simulation& simulation) {
    std::vector<std::string> ids;
    for (const world::Object& object : simulation.tabletop().objects()) ids.push_back(object.id());
    return Pick(ids);
  }
  /// Returns the id of a tool; of any object in a scene without tools.
  std::string ATool(const Simulation& simulation) {
    std::vector<std::string> ids;
    for (const world::Object& object : simulation.tabletop().objects()) {
      if (object.spec->tool) ids.push_back(object.id());
    }
    return ids.empty() ? AnObject(simulation) : Pick(ids);
  }
  static std::optional<HandName> HandWithTool(const Simulation& simulation) {
    for (const HandName hand : demonstrator::kHandNames) {
      const world::Object* held =
          simulation.tabletop().Find(simulation.demonstrator().hand(hand).held);
      if (held != nullptr && held->spec->tool) return hand;
    }
    return std::nullopt;
  }
  static std::string HeldBy(HandName hand, const Simulation& simulation) {
    const world::Object* held =
        simulation.tabletop().Find(simulation.demonstrator().hand(hand).held);
    return held != nullptr ? held->id() : "";
  }

  Command NextChange(const Simulation& simulation) {
    if (random_() % 16 == 0) return Clear{};
    if (random_() % 3 == 0) {
      return Displace{.objects = {AnObject(simulation), AnObject(simulation)},
                      .by = {Uniform(0.3), Uniform(0.3), 0.1 + Uniform(0.1)}};
    }
    if (random_() % 2 == 0) return Spawn{.xml = SomethingNew()};
    return Remove{.object = AnObject(simulation)};
  }

  /// Returns a scene with new ids, and one of several mechanisms.
  std::string SomethingNew() {
    const std::string number = std::to_string(num_spawned_++);
    const double x = Uniform(6), y = Uniform(4);
    const auto at = [x, y](double z, double dx = 0) {
      return "(" + std::to_string(x + dx) + "," + std::to_string(y) + "," + std::to_string(z) + ")";
    };
    const auto id = [&number](const char* name) { return "id=\"" + (name + number) + "\""; };
    std::string content;
    switch (num_spawned_ % 5) {
      case 0:
        content = "<block " + id("new_block") + " location=\"" + at(2) + "\"/>";
        break;
      case 1:
        content = "<chain " + id("new_rope") + " start=\"" + at(5) + "\" end=\"" + at(6, 1.5) +
                  "\" linkCount=\"4\"/>";
        break;
      case 2:
        content = "<sliderJoint location=\"" + at(3) + "\" max=\"2\" init=\"1\"><box " +
                  id("new_case") +
                  " location=\"(0,0,0)\" xspan=\"3\" yspan=\"2\" zspan=\"1\"/><block " +
                  id("new_drawer") +
                  " location=\"(0,0,0.2)\" xspan=\"2\" yspan=\"1\" zspan=\"0.4\"/></sliderJoint>";
        break;
      case 3:
        content = "<composite " + id("new_nut") + " location=\"" + at(1) +
                  "\"><block location=\"(0,0,0)\" zspan=\"0.5\"/><hostBondPoint " + id("new_hole") +
                  " type=\"new\" location=\"(0,0,0.25)\" downstream=\"new_switch" + number +
                  "\"><tightness location=\"(0,0,0)\"/></hostBondPoint></composite><composite " +
                  id("new_screw") + " location=\"" + at(4) +
                  "\"><block location=\"(0,0,0)\" xspan=\"0.3\" yspan=\"0.3\"/><guestBondPoint " +
                  id("new_tip") +
                  " type=\"new\" location=\"(0,0,-0.5)\" initBondHostId=\"new_hole" + number +
                  "\" initBondTightness=\"1\"/></composite><composite location=\"" + at(3, 2) +
                  "\" " + id("new_panel") + "><toggleSwitch " + id("new_switch") +
                  " location=\"(0,0,0)\" numStates=\"3\"/></composite>";
        break;
      default:
        content = "<sphere " + id("new_ball") + " radius=\"0.4\" location=\"" + at(3) + "\"/>";
    }
    return "<tabletop xmlns=\"http://synapse.cs.umd.edu/tabletop-xml\">" + content + "</tabletop>";
  }

  inline static const std::vector<std::string> kScrews = {"screw", "spare"};
  inline static const std::vector<std::string> kProperties = {"colour", "shape", "order"};

  template <class T>
  const T& Pick(const std::vector<T>& things) {
    return things[random_() % things.size()];
  }
  double Uniform(double limit) { return std::uniform_real_distribution(-limit, limit)(random_); }

  std::mt19937 random_;
  bool changes_objects_;
  int num_spawned_ = 0;
};

}  // namespace smile::sim
