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

Json Chronicle::SegmentsSince(std::size_t num_before, std::uint64_t start_tick,
                              std::uint64_t now_tick) const {
  Json segments = Json::array();
  const auto end_of = [&](std::size_t action) {
    return action < actions_.size() ? actions_[action].tick : now_tick;
  };
  segments.push_back({{"number", 0},
                      {"deed", nullptr},
                      {"seconds", RoundedSeconds(end_of(num_before) - start_tick)}});
  for (std::size_t i = num_before; i < actions_.size(); ++i) {
    segments.push_back({{"number", i - num_before + 1},
                        {"deed", record::ToJson(actions_[i].deed)},
                        {"seconds", RoundedSeconds(end_of(i + 1) - actions_[i].tick)}});
  }
  return segments;
}

void Chronicle::OnCommand(const sim::Simulation& simulation, const sim::Command& command) {
  undone_.clear();
  if (sim::IsAction(command)) actions_.push_back({.tick = simulation.tick()});
}

void Chronicle::OnEvent(const sim::Simulation& simulation, const sim::Event& event) {
  if (!record::BeginsSegment(event) || actions_.empty()) return;
  const bool lets_go = event.kind == sim::EventKind::kReleased;
  actions_.back().deed =
      record::DeedOf(event, lets_go ? SupportOf(simulation, event.object) : std::nullopt);
}

void Chronicle::OnUndo(const sim::Simulation&) {
  if (actions_.empty()) return;
  undone_.push_back(std::move(actions_.back()));
  actions_.pop_back();
}

void Chronicle::OnRedo(const sim::Simulation&) {
  if (undone_.empty()) return;
  actions_.push_back(std::move(undone_.back()));
  undone_.pop_back();
}

}  // namespace smile::studio
