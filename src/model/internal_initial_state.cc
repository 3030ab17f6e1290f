// Builds the start of a scene from its description: guests that are fastened from the start are
// moved to their hosts, together with everything that is joined to them (assemblies, drawers,
// chains). Later guests may move what earlier ones built.

#include "model/internal_initial_state.h"

#include <set>
#include <utility>

namespace smile::model {
namespace {

/// Fastens guests to hosts like world::Bonds, without a physics world.
class Fastener {
 public:
  explicit Fastener(const Model& model) : model_(model) {
    for (ObjectIndex object : model.objects()) {
      state_.X_WB.emplace_back(model.object(object).pose_in_world());
    }
    state_.controls = InitialStates(model.all_controls());
    state_.hosts.resize(model.hosts().size());
    for (const scene::SliderSpec& slider : model.scene().sliders) {
      Tie(slider.first_object, slider.first_object + 1);
    }
    for (const scene::ChainSpec& chain : model.scene().chains) TieChain(chain);
  }

  void Fasten(GuestIndex guest_index, HostIndex host_index, int tightness) {
    const Guest& guest = model_.guest(guest_index);
    const Host& host = model_.host(host_index);
    // The guest comes to the host, never the reverse, in the order of the file.
    Move(guest.object, *state_.X_WB[host.object] * GuestBodyInHostBody(host, guest, tightness));
    Tie(host.object, guest.object);
    HostState& held = state_.hosts[host_index];
    held.guest = guest_index;
    held.tightness = tightness;
    // Controls and hosts downstream follow the tightness.
    if (host.downstream) {
      TakeState(model_.control(*host.downstream), tightness, &state_.controls[*host.downstream]);
    }
    if (host.downstream_override) {
      OverrideState(model_.control(*host.downstream_override), OverrideAt(host, tightness),
                    &state_.controls[*host.downstream_override]);
    }
    if (host.downstream_lock) {
      state_.hosts[*host.downstream_lock].is_locked = LocksDownstreamAt(host, tightness);
    }
  }

  SceneState Take() { return std::move(state_); }

 private:
  void Tie(std::size_t a, std::size_t b) {
    // In both directions, so that the search needs no order.
    ties_.insert({{ObjectIndex(a), ObjectIndex(b)}, {ObjectIndex(b), ObjectIndex(a)}});
  }

  /// Ties a chain from end to end; both ends come first in the scene.
  void TieChain(const scene::ChainSpec& chain) {
    std::size_t previous = chain.first_object;
    for (std::size_t i = 0; i < chain.link_ids.size(); ++i) {
      const std::size_t link = chain.first_object + 2 + i;
      Tie(previous, link);
      previous = link;
    }
    Tie(previous, chain.first_object + 1);
  }

  /// Moves an object and everything tied to it, except through static objects.
  void Move(ObjectIndex object, const RigidTransform& X_WB) {
    // Tied objects move rigidly with this one.
    const RigidTransform X_moved = X_WB * state_.X_WB[object]->inverse();
    std::set<ObjectIndex> found{object};
    std::vector<ObjectIndex> to_visit{object};
    while (!to_visit.empty()) {
      const ObjectIndex from = to_visit.back();
      to_visit.pop_back();
      // A static object ends the search: it does not move, and connects no others.
      if (model_.object(from).is_static()) continue;
      for (auto tie = ties_.lower_bound({from, ObjectIndex(0)});
           tie != ties_.end() && tie->first == from; ++tie) {
        if (found.insert(tie->second).second) to_visit.push_back(tie->second);
      }
    }
    // The moved object gets its exact pose; others move by the same rigid motion.
    for (ObjectIndex member : found) {
      std::optional<RigidTransform>& X_WMember = state_.X_WB[member];
      if (member == object) {
        X_WMember = X_WB;
      } else if (!model_.object(member).is_static()) {
        X_WMember = X_moved * *X_WMember;
      }
    }
  }

  const Model& model_;
  SceneState state_;
  std::set<std::pair<ObjectIndex, ObjectIndex>> ties_;
};

}  // namespace

SceneState InitialStateOf(const Model& model) {
  Fastener fastener(model);
  for (GuestIndex guest : model.guests()) {
    const scene::GuestPoint& point = *model.guest(guest).point;
    const auto host = model.FindHost(point.initial_host);
    if (host && point.initial_tightness >= 1)
      fastener.Fasten(guest, *host, point.initial_tightness);
  }
  return fastener.Take();
}

}  // namespace smile::model
