#pragma once

#include <random>
#include <string>
#include <vector>

#include "sim/simulation.h"

namespace smile::sim {

/// Hands that do whatever comes to their mind to an EverythingScene.
class RandomHands {
 public:
  explicit RandomHands(unsigned seed) : random_(seed) {}

  Command Next(const Simulation& simulation) {
    const HandName hand = Pick(std::vector{HandName::kLeft, HandName::kRight});
    const std::string object = Pick(simulation.tabletop().objects()).id();
    switch (random_() % 10) {
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
      // The hand that never holds anything, so that it can.
      case 5:
        return Trigger{.hand = HandName::kAny,
                       .control = Pick(std::vector<std::string>{"power", "lamps", "dial"})};
      case 6:
        return Fasten{.hand = HandName::kAny, .object = Pick(kScrews)};
      case 7:
        return Loosen{.hand = HandName::kAny, .object = Pick(kScrews)};
      case 8:
        return Point{.hand = hand, .part = object};
      default:
        if (random_() % 4 == 0) return Destroy{.hand = hand};
        return MoveTo{.hand = hand, .p_WH = {Uniform(0.6), Uniform(0.4), 0.2}, .speed = 0.3};
    }
  }

 private:
  inline static const std::vector<std::string> kScrews = {"screw", "spare"};

  template <class T>
  const T& Pick(const std::vector<T>& things) {
    return things[random_() % things.size()];
  }
  double Uniform(double limit) { return std::uniform_real_distribution(-limit, limit)(random_); }

  std::mt19937 random_;
};

}  // namespace smile::sim
