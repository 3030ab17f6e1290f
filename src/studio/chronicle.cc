#include "studio/chronicle.h"

#include <algorithm>
#include <cmath>

namespace smile::studio {
namespace {

/// To a tenth: what pages show changes no more often than they can.
double RoundedSeconds(std::uint64_t ticks) { return std::round(10 * sim::SecondsOf(ticks)) / 10; }

std::optional<record::Support> SupportOf(const sim::Simulation& simulation, const std::string& id) {
  const auto& objects = simulation.scene().objects;
  const auto object = std::ranges::find(objects, id, &scene::ObjectSpec::id);
  return record::SupportOf(simulation.scene(), record::Observe(simulation).objects,
                           static_cast<std::size_t>(object - objects.begin()));
}

}  // namespace

Json Chronicle::SegmentsSince(sim::ActionId before, std::uint64_t start_tick,
                              const sim::Simulation& simulation) const {
  Json segments = Json::array();
  const auto actions = simulation.history().done();
  std::uint64_t begin = start_tick;
  for (std::size_t i = 0; i < actions.size(); ++i) {
    if (actions[i].id < before) continue;
    const bool is_last = i + 1 == actions.size();
    const std::uint64_t end = is_last ? simulation.tick() : actions[i + 1].tick;
    const record::Deed* deed = segments.empty() ? nullptr : deeds_.Find(actions[i].id);
    segments.push_back({{"number", segments.size()},
                        {"deed", deed != nullptr ? record::ToJson(*deed) : Json()},
                        {"seconds", RoundedSeconds(end - begin)}});
    begin = end;
  }
  return segments;
}

void Chronicle::OnEvent(const sim::Simulation& simulation, const sim::Event& event) {
  if (!record::BeginsSegment(event)) return;
  const bool lets_go = event.kind == sim::EventKind::kReleased;
  deeds_.Begin(
      simulation.history(),
      *record::DeedOf(event, lets_go ? SupportOf(simulation, event.object) : std::nullopt));
}

}  // namespace smile::studio
