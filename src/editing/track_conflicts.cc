#include "editing/track_conflicts.h"

#include <algorithm>

#include "editing/re_simulation.h"
#include "sim/action_summary.h"

namespace smile::editing {

using texts::UserMessage;

namespace {

/// Returns the hand that holds an object, other than the one that takes it.
std::optional<sim::HandName> OtherHolder(const sim::Grasp& grasp,
                                         const sim::Simulation& simulation) {
  for (const sim::HandName name : demonstrator::kHandNames) {
    const demonstrator::Hand& hand = simulation.demonstrator().hand(name);
    if (name == grasp.hand || !hand.is_holding()) continue;
    if (simulation.tabletop().Find(hand.held)->id() == grasp.object) return name;
  }
  return std::nullopt;
}

}  // namespace

std::optional<UserMessage> TrackConflicts::ReasonOf(const recording::LoggedCommand& logged,
                                                    const sim::Simulation& simulation) const {
  const auto* grasp = std::get_if<sim::Grasp>(&logged.command);
  if (grasp == nullptr) return std::nullopt;
  if (const auto holder = OtherHolder(*grasp, simulation)) {
    return texts::Say("conflicts.heldByOther",
                      {{"object", grasp->object}, {"hand", ToString(*holder)}});
  }
  const auto recorded = grasped_.find(logged.line);
  const auto object = simulation.model().FindObject(grasp->object);
  if (recorded == grasped_.end() || !object) return std::nullopt;
  const recording::PoseGap gap =
      recording::GapBetween(recorded->second, recording::Observe(simulation).objects[*object]);
  if (!gap.IsBeyond(kSamePlace)) return std::nullopt;
  return texts::Say(
      "conflicts.notWhereTaken",
      {{"object", grasp->object}, {"distance", gap.millimeters()}, {"angle", gap.degrees()}});
}

void TrackConflicts::Before(const recording::LoggedCommand& logged,
                            const sim::Simulation& simulation) {
  if (sim::IsAction(logged.command)) in_conflict_.erase(sim::HandOf(logged.command));
  found_before_ = ReasonOf(logged, simulation);
}

void TrackConflicts::After(const recording::LoggedCommand& logged,
                           const std::optional<sim::Refusal>& refusal) {
  const std::optional<UserMessage> reason =
      refusal ? std::optional<UserMessage>(*refusal) : found_before_;
  const auto hand = sim::HandOf(logged.command);
  if (!reason || !in_conflict_.insert(hand).second) return;
  const auto last = std::find_if(found_.rbegin(), found_.rend(),
                                 [&](const OfCommand& one) { return one.conflict.hand == hand; });
  // The release of what a hand does not hold follows from its moves, too.
  if (last != found_.rend() && last->conflict.reason == *reason) return;
  found_.push_back(
      {logged.line,
       {.hand = hand, .seconds = sim::SecondsOf(logged.tick - start_tick_), .reason = *reason}});
}

void TrackConflicts::ForgetFrom(std::size_t line) {
  std::erase_if(found_, [=](const OfCommand& one) { return one.line >= line; });
  in_conflict_.clear();
}

std::vector<recording::Conflict> TrackConflicts::conflicts() const {
  std::vector<recording::Conflict> conflicts;
  for (const OfCommand& one : found_) conflicts.push_back(one.conflict);
  return conflicts;
}

}  // namespace smile::editing
