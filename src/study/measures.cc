#include "study/measures.h"

#include <algorithm>
#include <optional>
#include <set>
#include <sstream>
#include <variant>

#include "base/diagnostic.h"
#include "base/files.h"
#include "base/json.h"
#include "recording/recording.h"
#include "recording/trace_reader.h"
#include "sim/simulation.h"
#include "task/episode.h"

namespace smile::study {
namespace {

constexpr std::size_t kMaxReadInputBytes = 64 << 20;
constexpr double kRestMs = 500;  ///< of the camera, between two moves

void CountReturns(const recording::Recording& recording, Measures* measures) {
  for (const recording::LogLine& line : recording.log.lines()) {
    const auto* back = std::get_if<recording::Return>(&line.what);
    if (back == nullptr) continue;
    measures->undos += back->kind == recording::ReturnKind::kUndo ? 1 : 0;
    measures->redos += back->kind == recording::ReturnKind::kRedo ? 1 : 0;
  }
}

/// Objects in hands, by their ids.
void Follow(const std::vector<sim::Event>& events, std::set<std::string>* held,
            Measures* measures) {
  for (const sim::Event& event : events) {
    if (event.kind == sim::EventKind::kGrasped) {
      held->insert(event.object);
      measures->grasps += 1;
    }
    if (event.kind == sim::EventKind::kReleased || event.kind == sim::EventKind::kDestroyed) {
      held->erase(event.object);
    }
    measures->falls += event.kind == sim::EventKind::kFell ? 1 : 0;
  }
}

/// Returns how far the held objects moved between two ticks [m].
double PathBetween(const recording::TraceTick& from, const recording::TraceTick& to,
                   const std::vector<std::string>& names, const std::set<std::string>& held) {
  double length = 0;
  for (std::size_t k = 0; k < names.size(); ++k) {
    const bool is_there = from.objects[k].is_present && to.objects[k].is_present;
    if (!is_there || !held.contains(names[k])) continue;
    length += (to.objects[k].position - from.objects[k].position).norm();
  }
  return length;
}

bool HoldsAll(const std::vector<model::Relation>& relations,
              const std::vector<model::Relation>& goal) {
  return std::ranges::all_of(goal, [&](const model::Relation& wanted) {
    return std::ranges::find(relations, wanted) != relations.end();
  });
}

}  // namespace

Measures MeasuresOf(const std::filesystem::path& directory,
                    const std::vector<model::Relation>& goal) {
  const recording::Recording recording = recording::OpenRecording(directory);
  Measures measures;
  CountReturns(recording, &measures);
  recording::TraceReader reader(recording);
  std::set<std::string> held;
  std::optional<recording::TraceTick> last;
  std::uint64_t first_tick = 0;
  while (auto now = reader.Next()) {
    if (last) {
      measures.path_meters += PathBetween(*last, *now, reader.object_names(), held);
    } else {
      first_tick = now->tick;
    }
    Follow(now->events, &held, &measures);
    last = std::move(now);
  }
  if (!last) return measures;
  measures.seconds = static_cast<double>(last->tick - first_tick) / sim::kTicksPerSecond;
  measures.is_success = HoldsAll(
      model::RelationsOf(recording.scene(), task::ObjectsAt(recording.scene(), *last)), goal);
  return measures;
}

InputMeasures InputMeasuresOf(const std::filesystem::path& file) {
  InputMeasures measures;
  if (!std::filesystem::exists(file)) return measures;
  const std::string text = ReadFile(file, kMaxReadInputBytes);
  double last_camera_ms = -kRestMs;
  std::size_t begin = 0;
  int line = 0;
  for (std::size_t end = 0; (end = text.find('\n', begin)) != std::string::npos; begin = end + 1) {
    ++line;
    try {
      const Json event = ParseJson(text.substr(begin, end - begin));
      const std::string kind = event.value("kind", "");
      const double at_ms = event.value("ms", 0.0);
      measures.focus_losses += kind == "blur" ? 1 : 0;
      if (kind != "camera") continue;
      measures.camera_moves += at_ms - last_camera_ms >= kRestMs ? 1 : 0;
      last_camera_ms = at_ms;
    } catch (const std::exception& error) {
      throw InputError(Diagnostic{.file = file.string(), .line = line, .message = error.what()});
    }
  }
  return measures;
}

}  // namespace smile::study
