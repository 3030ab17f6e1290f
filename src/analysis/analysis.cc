// What matters in a demonstration, found by trying. The order of two subtasks is tested only if it
// does not already follow from others, and only with those subtasks moved that have to move along.
// Therefore pairs are tested by their distance: whatever lies between two subtasks has been tested
// against both before.

#include "analysis/analysis.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "analysis/internal_trials.h"
#include "base/diagnostic.h"
#include "base/hash_text.h"
#include "base/state_hash.h"
#include "math/color.h"
#include "scene/solid.h"
#include "scene_xml/scene_writer.h"
#include "sim/command_json.h"

namespace smile::analysis {
namespace {

using Pair = std::pair<std::size_t, std::size_t>;

SubtaskOrder DemonstratedOrder(std::size_t num_subtasks) {
  SubtaskOrder order(num_subtasks);
  std::iota(order.begin(), order.end(), std::size_t{0});
  return order;
}

SubtaskOrder Without(std::size_t dropped, SubtaskOrder order) {
  std::erase(order, dropped);
  return order;
}

/// Returns the demonstrated order with `later` right before `earlier`, preceded by those subtasks
/// between them that must come before `later`. None of these must come after `earlier`, or the
/// order of the two would follow from others.
SubtaskOrder Exchanged(std::size_t earlier, std::size_t later, const Analysis& analysis) {
  SubtaskOrder order = DemonstratedOrder(analysis.subtasks.size());
  const auto begin = order.begin() + static_cast<std::ptrdiff_t>(earlier);
  std::stable_partition(
      begin, order.begin() + static_cast<std::ptrdiff_t>(later) + 1, [&](std::size_t subtask) {
        return subtask == later || (subtask != earlier && analysis.MustPrecede(subtask, later));
      });
  return order;
}

void RequireThatItStands(const recording::Recording& recording, Trials* trials) {
  const auto harm =
      trials->HarmsOf(std::vector<SubtaskOrder>{DemonstratedOrder(trials->subtasks().size())})
          .front();
  if (!harm) return;
  throw InputError({recording.directory.string(), 0, "",
                    "does not keep what it achieved for 2 s after its end (" + *harm +
                        "), expected a demonstration whose result stands"});
}

/// Tries the demonstration without each of these subtasks.
std::vector<Harm> HarmsWithoutEach(const SubtaskOrder& order, Trials* trials) {
  std::vector<SubtaskOrder> orders;
  orders.reserve(order.size());
  for (const std::size_t subtask : order) orders.push_back(Without(subtask, order));
  return trials->HarmsOf(orders);
}

/// Returns the last one that does no harm; nullopt if all do.
std::optional<std::ptrdiff_t> LastRedundant(const std::vector<Harm>& harms) {
  const auto last = std::find(harms.rbegin(), harms.rend(), std::nullopt);
  if (last == harms.rend()) return std::nullopt;
  return harms.rend() - last - 1;
}

/// Finds out which subtasks the demonstration needs as it is. Then leaves out one after the other,
/// the last first, as long as one of the remaining is redundant: two that undo each other are so
/// only together.
void FindNecessarySubtasks(Trials* trials, Analysis* analysis) {
  SubtaskOrder kept = DemonstratedOrder(trials->subtasks().size());
  auto harms = HarmsWithoutEach(kept, trials);
  for (const std::size_t subtask : kept)
    analysis->subtasks.push_back({trials->subtasks()[subtask], harms[subtask]});
  while (const auto last = LastRedundant(harms)) {
    kept.erase(kept.begin() + *last);
    harms = HarmsWithoutEach(kept, trials);
  }
  analysis->sufficient = std::move(kept);
}

/// Tries all pairs of subtasks of one distance whose order does not follow from others.
void FindPrecedences(std::size_t distance, Trials* trials, Analysis* analysis) {
  std::vector<Pair> pairs;
  std::vector<SubtaskOrder> orders;
  for (std::size_t later = distance; later < analysis->subtasks.size(); ++later) {
    const std::size_t earlier = later - distance;
    if (analysis->MustPrecede(earlier, later)) continue;
    pairs.emplace_back(earlier, later);
    orders.push_back(Exchanged(earlier, later, *analysis));
  }
  const auto harms = trials->HarmsOf(orders);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (harms[i]) analysis->precedences.push_back({pairs[i].first, pairs[i].second, *harms[i]});
  }
}

/// Returns a color that no object of a scene has.
Color OtherColor(const scene::SceneSpec& scene) {
  for (const std::string_view name : ColorNames()) {
    const Color color = ParseColor(name).value();
    const bool is_taken = std::ranges::any_of(
        scene.objects, [&](const auto& object) { return object.whole.color == color; });
    if (!is_taken) return color;
  }
  return {0.3, 0.5, 0.7};  // all names are taken
}

bool HasOneColor(const scene::ObjectSpec& object) {
  return std::ranges::all_of(scene::SolidsOf(object.whole), [&](const scene::Solid& solid) {
    return solid.color == object.whole.color;
  });
}

/// Repaints each movable object of one color.
void TryColors(const recording::Recording& recording, Trials* trials, Analysis* analysis) {
  using Property = PropertyFinding::Property;
  const Color color = OtherColor(recording.start_scene());
  const SubtaskOrder order = DemonstratedOrder(trials->subtasks().size());
  std::vector<Trial> tried;
  std::vector<std::size_t> places;
  for (const scene::ObjectSpec& object : trials->structure().objects) {
    const std::string& id = object.id();
    const auto attended = trials->structure().AttendedOf(id);
    const bool was_there =
        std::ranges::count(recording.start_scene().objects, id, &scene::ObjectSpec::id) > 0;
    if (std::ranges::find(attended, "color") != attended.end()) {
      analysis->properties.push_back(
          {Property::kColor, id, {}, texts::Say("analysis.wasAttended")});
    } else if (!object.is_static() && was_there && HasOneColor(object)) {
      places.push_back(analysis->properties.size());
      analysis->properties.push_back(
          {Property::kColor, id,
           texts::Say("analysis.otherColor",
                      {{"color", ToString(color)}, {"before", ToString(object.whole.color)}}),
           std::nullopt});
      tried.push_back({.order = order, .repaint = Repaint{id, color}});
    }
  }
  const std::vector<Harm> harms = trials->HarmsOf(tried);
  for (std::size_t i = 0; i < tried.size(); ++i) analysis->properties[places[i]].harm = harms[i];
}

/// Displaces everything that is not fixed, hands included.
void TryPlaces(const recording::Recording& recording, Trials* trials, Analysis* analysis) {
  analysis->why_not_moved = WhyNotShifted(recording);
  if (!analysis->why_not_moved.empty()) return;
  constexpr int kShift = 100;  // [mm], the side of the usual block
  const std::array<std::pair<std::array<int, 2>, texts::UserMessage>, 4> shifts{
      {{{kShift, 0}, texts::Say("analysis.right")},
       {{-kShift, 0}, texts::Say("analysis.left")},
       {{0, kShift}, texts::Say("analysis.away")},
       {{0, -kShift}, texts::Say("analysis.towards")}}};
  std::vector<Trial> tried;
  for (const auto& [shift, words] : shifts) {
    tried.push_back({.order = DemonstratedOrder(trials->subtasks().size()), .shift_mm = shift});
  }
  const std::vector<Harm> harms = trials->HarmsOf(tried);
  for (std::size_t i = 0; i < tried.size(); ++i) {
    analysis->properties.push_back(
        {PropertyFinding::Property::kPlace, "", shifts[i].second, harms[i]});
  }
}

}  // namespace

bool Analysis::MustPrecede(std::size_t before, std::size_t after) const {
  // Chains lead from earlier to later subtasks only, so the search ends.
  return std::ranges::any_of(precedences, [&](const Precedence& one) {
    return one.after == after &&
           (one.before == before || (one.before > before && MustPrecede(before, one.before)));
  });
}

std::vector<std::size_t> Analysis::Levels() const {
  std::vector<std::size_t> levels(subtasks.size(), 0);
  // They are sorted by `after`, so the level of `before` is complete.
  for (const Precedence& one : precedences) {
    levels[one.after] = std::max(levels[one.after], levels[one.before] + 1);
  }
  return levels;
}

std::string NumbersOf(const std::vector<std::size_t>& subtasks) {
  std::string numbers;
  for (std::size_t i = 0; i < subtasks.size(); ++i) {
    if (i > 0) numbers += i + 1 < subtasks.size() ? ", " : " and ";
    numbers += std::to_string(subtasks[i] + 1);
  }
  return numbers;
}

std::string ContentOf(const recording::Recording& recording) {
  StateHash hash;
  hash.Add(scene_xml::WriteScene(recording.start_scene()));
  hash.Add(recording.info.start.tick);
  for (const recording::LoggedCommand& one : recording.commands) {
    hash.Add(one.tick);
    hash.Add(ToText(sim::ToJson(one.command, recording.start_scene().meters_per_unit)));
  }
  return HashText(hash.value());
}

Analysis Analyze(const recording::Recording& recording, const AnalysisOptions& options) {
  Trials trials(recording, options);
  Analysis analysis;
  analysis.demonstration = ContentOf(recording);
  analysis.goals = trials.goals();
  RequireThatItStands(recording, &trials);
  FindNecessarySubtasks(&trials, &analysis);
  for (std::size_t distance = 1; distance < analysis.subtasks.size(); ++distance) {
    FindPrecedences(distance, &trials, &analysis);
  }
  std::ranges::sort(analysis.precedences, {},
                    [](const Precedence& one) { return std::pair(one.after, one.before); });
  TryColors(recording, &trials, &analysis);
  TryPlaces(recording, &trials, &analysis);
  analysis.num_simulations = trials.num_done();
  trials.Finish();
  return analysis;
}

}  // namespace smile::analysis
