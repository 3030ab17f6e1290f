#include "studio/live_brain.h"

#include <unistd.h>

#include <algorithm>
#include <map>
#include <system_error>

namespace smile::studio {
namespace {

namespace fs = std::filesystem;

/// A person waits for it.
constexpr double kPatience = 5, kStartPatience = 30;  // [s], wall clock

std::string KindOf(const fs::path& path) {
  std::error_code error;
  if (fs::is_regular_file(path / "agentBehavior.m", error)) return "octave";
  if (!fs::is_regular_file(path, error)) return "";
  if (path.extension() == ".py") return "python";
  return ::access(path.c_str(), X_OK) == 0 ? "program" : "";
}

}  // namespace

std::vector<BrainChoice> BrainsIn(const std::vector<fs::path>& folders) {
  std::vector<BrainChoice> choices;
  for (const fs::path& folder : folders) {
    std::error_code error;
    std::map<std::string, BrainChoice> found;
    for (const auto& entry : fs::directory_iterator(folder, error)) {
      const std::string name = entry.path().filename().string();
      const std::string kind = KindOf(entry.path());
      if (!kind.empty()) found[name] = {.name = name, .kind = kind, .path = entry.path()};
    }
    for (auto& [name, choice] : found) {
      const bool is_new = std::ranges::find(choices, name, &BrainChoice::name) == choices.end();
      if (is_new) choices.push_back(std::move(choice));
    }
  }
  return choices;
}

void LiveBrain::Start(const BrainChoice& choice, const brain::BrainDriverOptions& options,
                      sim::Simulation* simulation) {
  Leave();
  name_ = choice.name;
  process_.emplace(
      choice.path,
      brain::BrainOptions{.start_seconds = kStartPatience,
                          .callback_seconds = kPatience,
                          .on_output = [this](std::string_view line) { console_.Write(line); },
                          .is_cancelled = is_ending_});
  driver_.emplace(&*process_, options);
  try {
    driver_->Start(simulation);
  } catch (...) {
    Leave();
    throw;
  }
  NoteError();
}

void LiveBrain::Drive(sim::Simulation* simulation) {
  if (!is_running()) return;
  driver_->Drive(simulation);
  NoteError();
}

void LiveBrain::NoteError() {
  if (driver_->error()) console_.Write(ToString(*driver_->error()));
}

void LiveBrain::Stop(sim::Simulation* simulation) {
  if (!is_running()) return;
  Leave();
  was_stopped_ = true;
  sim::JointVelocities still{.grippers = {{0, 0}}};
  const robot::RobotBody& robot = *simulation->robot();
  still.left = std::vector<double>(robot.ArmAngles(0).size());
  still.right = std::vector<double>(robot.ArmAngles(1).size());
  if (robot.model().head) still.head = 0;
  (void)simulation->Apply(still);
  (void)simulation->Apply(sim::Face{});
  (void)simulation->Apply(sim::Markers{});
}

void LiveBrain::Leave() {
  driver_.reset();
  process_.reset();
  was_stopped_ = false;
}

Json LiveBrain::Describe() const {
  Json described = {
      {"name", name_}, {"status", "none"}, {"message", ""}, {"file", ""}, {"line", 0}};
  if (was_stopped_) described["status"] = "stopped";
  if (!driver_) return described;
  described["status"] = ToString(driver_->status());
  if (const auto& error = driver_->error()) {
    described["message"] = error->message;
    described["file"] = error->file;
    described["line"] = error->line;
  }
  return described;
}

}  // namespace smile::studio
