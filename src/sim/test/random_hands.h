#pragma once

#include <random>
#include <string>
#include <vector>

#include "sim/drag.h"
#include "sim/simulation.h"

namespace smile::sim {

/// Hands that do whatever comes to their mind to an EverythingScene.
class RandomHands {
 public:
  explicit RandomHands(unsigned seed) : random_(seed) {}

  Command Next(const Simulation& simulation) {
    // Mostly two of them, so that they hold what the other wants; `any` is free for mechanisms.
    using enum HandName;
    const HandName hand = Pick(std::vector{kLeft, kLeft, kLeft, kRight, kRight, kRight, kBoth});
    const std::string object = Pick(simulation.tabletop().objects()).id();
    switch (random_() % 15) {
      case 0:
      case 1:
        // The panel stays: whoever destroys it takes all controls away.
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
      case 13:  // off the table
        return MoveTo{.hand = hand, .p_WH = {Uniform(2) < 0 ? -1.3 : 1.3, Uniform(0.4), 0.2}};
      default:
        if (random_() % 4 == 0) return Destroy{.hand = hand};
        return MoveTo{.hand = hand, .p_WH = {Uniform(0.6), Uniform(0.4), 0.2}, .speed = 0.3};
    }
  }

 private:
  static std::string HeldBy(HandName hand, const Simulation& simulation) {
    const world::Object* held =
        simulation.tabletop().Find(simulation.demonstrator().hand(hand).held);
    return held != nullptr ? held->id() : "";
  }

  inline static const std::vector<std::string> kScrews = {"screw", "spare"};
  inline static const std::vector<std::string> kProperties = {"colour", "shape", "order"};

  template <class T>
  const T& Pick(const std::vector<T>& things) {
    return things[random_() % things.size()];
  }
  double Uniform(double limit) { return std::uniform_real_distribution(-limit, limit)(random_); }

  std::mt19937 random_;
};

}  // namespace smile::sim
