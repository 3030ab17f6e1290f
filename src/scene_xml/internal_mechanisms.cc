#include "scene_xml/internal_mechanisms.h"

#include <map>
#include <numeric>
#include <set>
#include <string>
#include <vector>

#include "scene/controls_of.h"

// The last pass over a scene: all ids are known, so references can be resolved and mechanisms
// checked as a whole. What is refused here would make the initial poses of a simulation contradict
// each other.

namespace smile::scene_xml {
namespace {

using scene::Part;

/// Calls `visit` with each part of an object that may be or contain a mechanism, parents first.
template <class Visit>
void ForEachPart(Part* part, const Visit& visit) {
  visit(part);
  if (auto* composite = std::get_if<scene::Composite>(&part->shape)) {
    for (Part& child : composite->parts) ForEachPart(&child, visit);
  }
}

/// Disjoint sets (union-find) of objects that bonds connect. Initial bonds must not form a cycle,
/// since the pose of a guest follows from its host.
class BondedObjects {
 public:
  explicit BondedObjects(std::size_t num_objects) : of_(num_objects) {
    std::iota(of_.begin(), of_.end(), std::size_t{0});
  }

  /// Merges the sets of two objects; returns false if they are connected already.
  [[nodiscard]] bool Connect(std::size_t a, std::size_t b) {
    a = RootOf(a);
    b = RootOf(b);
    of_[a] = b;
    return a != b;
  }

 private:
  std::size_t RootOf(std::size_t object) {
    // Path halving: every object on the way is attached to its grandparent.
    while (of_[object] != object) object = of_[object] = of_[of_[object]];
    return object;
  }

  std::vector<std::size_t> of_;
};

class Connector {
 public:
  Connector(scene::SceneSpec* scene, ReadingContext* reading)
      : scene_(*scene), reading_(*reading), bonds_(scene->objects.size()) {}

  void Connect() {
    // Three passes, as references may point forward: controls and hosts are known before anything
    // refers to them.
    ForEach([this](std::size_t object, Part* part) { Register(object, part); });
    ForEach([this](std::size_t, Part* part) { ConnectControl(part); });
    ForEach([this](std::size_t object, Part* part) { ConnectPoints(object, part); });
  }

 private:
  struct Host {
    scene::HostPoint* point;
    std::size_t object;
  };

  template <class Visit>
  void ForEach(const Visit& visit) {
    for (std::size_t i = 0; i < scene_.objects.size(); ++i) {
      ForEachPart(&scene_.objects[i].whole, [&](Part* part) { visit(i, part); });
    }
  }

  void Register(std::size_t object, Part* part) {
    // Ids of controls and hosts are unique: they were claimed when they were read.
    if (scene::IsControl(part->shape)) num_states_[part->id] = scene::NumStatesOf(*part);
    if (auto* composite = std::get_if<scene::Composite>(&part->shape)) {
      for (scene::HostPoint& host : composite->hosts) hosts_[host.id] = {&host, object};
    }
  }

  void ConnectControl(Part* part) {
    std::visit(
        [&](auto& shape) {
          // Exactly the three kinds of controls have this member.
          if constexpr (requires { shape.downstream; }) {
            for (std::string& ticket : shape.downstream) ticket = Found(ticket);
          }
        },
        part->shape);
  }

  void ConnectPoints(std::size_t object, Part* part) {
    auto* composite = std::get_if<scene::Composite>(&part->shape);
    if (!composite) return;
    for (scene::HostPoint& host : composite->hosts) ConnectHost(&host);
    for (scene::GuestPoint& guest : composite->guests) ConnectGuest(object, &guest);
  }

  /// Resolves the references of a host point and checks that each stage requests a state that the
  /// overridden control has.
  void ConnectHost(scene::HostPoint* host) {
    host->downstream = Found(host->downstream);
    host->downstream_lock = Found(host->downstream_lock);
    const std::string ticket = host->downstream_override;
    host->downstream_override = Found(ticket);
    const auto overridden = num_states_.find(host->downstream_override);
    if (overridden == num_states_.end()) return;
    for (std::size_t i = 0; i < host->stages.size(); ++i) {
      // A stage without a state requests none; 0 exists in every control.
      const int state = host->stages[i].downstream_state.value_or(0);
      if (state < overridden->second) continue;
      const Reference& reference = reading_.references.Of(ticket);
      reading_.findings->Add(reference.place, reference.element,
                             "found downstreamState=\"" + std::to_string(state) +
                                 "\" in tightness " + std::to_string(i + 1) +
                                 ", expected a state of " + overridden->first + ", from 0 to " +
                                 std::to_string(overridden->second - 1));
    }
  }

  /// Resolves the initial host of a guest and checks that the bond is possible: same type, existing
  /// stage, another object, a free host, no cycle.
  void ConnectGuest(std::size_t object, scene::GuestPoint* guest) {
    if (guest->initial_host.empty()) return;
    // A copy, as the ticket is replaced by the id in the next line.
    const Reference reference = reading_.references.Of(guest->initial_host);
    guest->initial_host = Found(guest->initial_host);
    const auto found = hosts_.find(guest->initial_host);
    if (found == hosts_.end()) return;
    const auto& [host, object_of_host] = found->second;
    const std::string name = "hostBondPoint " + host->id;
    const auto refuse = [&](const std::string& what, const std::string& expected) {
      reading_.findings->Add(reference.place, reference.element,
                             "found " + what + ", expected " + expected);
    };
    if (guest->type != host->type) {
      refuse("type=\"" + guest->type + "\"", "\"" + host->type + "\", the type of " + name);
    }
    // A host without stages has a finding of its own.
    if (!host->stages.empty() && guest->initial_tightness > static_cast<int>(host->stages.size())) {
      refuse("initBondTightness=\"" + std::to_string(guest->initial_tightness) + "\"",
             "1 to " + std::to_string(host->stages.size()) + ", the stages of " + name);
    }
    const std::string bond = "initBondHostId=\"" + reference.text + "\"";
    if (object == object_of_host) {
      refuse(bond, "a hostBondPoint of another object");
    } else if (!taken_hosts_.insert(host->id).second) {
      refuse(bond, "a hostBondPoint that holds no other guest");
    } else if (!bonds_.Connect(object, object_of_host)) {
      refuse(bond, "objects that no other bonds connect");
    }
  }

  /// Returns the id for a ticket; empty without a ticket, or with a finding if it cannot be
  /// resolved.
  std::string Found(const std::string& ticket) const {
    if (ticket.empty()) return {};
    return reading_.references.Find(reading_.references.Of(ticket), reading_.findings);
  }

  scene::SceneSpec& scene_;
  ReadingContext& reading_;
  std::map<std::string, int> num_states_;  // of the controls
  std::map<std::string, Host> hosts_;
  std::set<std::string> taken_hosts_;
  BondedObjects bonds_;
};

}  // namespace

void ConnectMechanisms(scene::SceneSpec* scene, ReadingContext* reading) {
  Connector(scene, reading).Connect();
}

}  // namespace smile::scene_xml
