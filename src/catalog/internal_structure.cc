#include "catalog/internal_structure.h"

#include <algorithm>
#include <cctype>
#include <cmath>

namespace smile::catalog::internal {
namespace {

/// Longest range of a joint that slides and still is one of a gripper [m].
constexpr double kLongestSlide = 0.2;
/// Distance of two arms from the plane between them, at which they are a left and a right one [m].
constexpr double kAside = 0.01;

class ArmFinder {
 public:
  /// @param shortest  joints of the shortest chain that counts.
  ArmFinder(const robot::RobotModel& model, int shortest)
      : model_(model),
        shortest_(shortest),
        children_(model.links.size() + 1),
        depths_(model.links.size(), 0) {
    // Parents come before children, so depths are complete from the end.
    for (int i = model.num_joints() - 1; i >= 0; --i) {
      depths_[i] += model.links[i].mimic ? 0 : 1;
      const int parent = model.links[i].parent;
      children_[parent + 1].insert(children_[parent + 1].begin(), i);
      if (parent >= 0) depths_[parent] = std::max(depths_[parent], depths_[i]);
    }
  }

  Structure Find() {
    Walk(-1, {});
    return std::move(found_);
  }

 private:
  /// Follows a chain from a link outwards.
  void Walk(int link, std::vector<int> chain) {
    const std::vector<int>& children = children_[link + 1];
    std::vector<int> longer;
    for (int child : children) {
      if (depths_[child] >= shortest_) longer.push_back(child);
    }
    // A hand, whose fingers may be as long as arms.
    if (static_cast<int>(chain.size()) > shortest_ && IsHand(children)) return End(link, chain);
    if (link < 0 || longer.size() > 1) {
      found_.torso.insert(found_.torso.end(), chain.begin(), chain.end());
      for (int child : longer) Continue(child, {});
    } else if (longer.size() == 1) {
      Continue(longer.front(), std::move(chain));
    } else if (children.size() == 1 && !BeginsGripper(children.front())) {
      Continue(children.front(), std::move(chain));
    } else {
      End(link, chain);
    }
  }
  void Continue(int child, std::vector<int> chain) {
    if (!model_.links[child].mimic) chain.push_back(child);
    Walk(child, std::move(chain));
  }

  void End(int link, const std::vector<int>& chain) {
    if (static_cast<int>(chain.size()) < shortest_) return;
    ArmChain arm{.name = "", .joints = chain, .palm = link, .beyond = {}};
    for (int i = link + 1; i < model_.num_joints(); ++i) {
      if (IsCarriedBy(model_, i, link)) arm.beyond.push_back(i);
    }
    found_.arms.push_back(std::move(arm));
  }

  bool IsHand(const std::vector<int>& children) const {
    return children.size() > 1 && std::ranges::all_of(children, [this](int child) {
             const scene::LinkSpec& link = model_.links[child];
             return HasWord(link.name + " " + link.joint_name,
                            {"finger", "thumb", "index", "middle", "ring", "pinky", "knuckle"});
           });
  }
  bool BeginsGripper(int child) const {
    const scene::LinkSpec& link = model_.links[child];
    if (link.mimic) return true;
    const bool is_last = children_[child + 1].empty();
    const bool slides_little =
        link.joint_type == scene::JointType::kPrismatic && link.upper - link.lower <= kLongestSlide;
    // The link behind an arm's last joint may be called a gripper: it carries one.
    return (is_last && slides_little) ||
           HasWord(link.joint_name, {"grip", "jaw", "finger", "claw", "knuckle"}) ||
           HasWord(link.name, {"jaw", "finger", "claw", "knuckle"});
  }

  const robot::RobotModel& model_;
  int shortest_;
  std::vector<std::vector<int>> children_;  // of the base, then of each link
  std::vector<int> depths_;  // joints with motors on the longest way outwards, the link's included
  Structure found_;
};

/// Names the arms: `arm`; `left` and `right`; or `arm1`, `arm2` and so on.
void Name(const robot::RobotModel& model, std::vector<ArmChain>* arms) {
  if (arms->size() == 1) {
    arms->front().name = "arm";
    return;
  }
  const std::vector<double> q = model.q_start;
  const std::vector<RigidTransform> X_BaseL = scene::LinkPoses(model.links, {}, q);
  const auto y_of = [&](const ArmChain& arm) {
    return X_BaseL[arm.joints.front()].translation().y();
  };
  std::ranges::stable_sort(*arms, std::greater(), y_of);
  const bool is_pair =
      arms->size() == 2 && y_of(arms->front()) > kAside && y_of(arms->back()) < -kAside;
  for (std::size_t i = 0; i < arms->size(); ++i) {
    (*arms)[i].name = is_pair ? (i == 0 ? "left" : "right") : "arm" + std::to_string(i + 1);
  }
}

}  // namespace

bool IsCarriedBy(const robot::RobotModel& model, int link, int carrier) {
  while (link > carrier) link = model.links[link].parent;
  return link == carrier;
}

bool HasWord(const std::string& name, std::initializer_list<const char*> words) {
  std::string lower;
  for (unsigned char letter : name) lower += static_cast<char>(std::tolower(letter));
  return std::ranges::any_of(
      words, [&lower](const char* word) { return lower.find(word) != std::string::npos; });
}

Structure StructureOf(const robot::RobotModel& model) {
  Structure structure = ArmFinder(model, 3).Find();
  if (structure.arms.empty()) structure = ArmFinder(model, 2).Find();
  Name(model, &structure.arms);
  return structure;
}

}  // namespace smile::catalog::internal
