#include "studio/internal_viewer_session.h"

#include <cmath>
#include <utility>

#include "page/control_requests.h"
#include "page/page_protocol.h"
#include "page/request_fields.h"
#include "studio/live_brain.h"
#include "texts/message_json.h"

namespace smile::studio {
namespace {

constexpr std::uint64_t kTicksPerWatchedState = 3;  // at most 20 a second
constexpr std::uint64_t kTicksPerSpeed = 60;        // a measurement of the speed each second

texts::UserMessage OnlyWatched() { return texts::Say("session.isOnlyWatched"); }

/// Returns the requests of a page that only watches: its lists are empty, and all else is refused.
page::RequestTable RequestsOfAWatcher() {
  page::RequestTable table;
  for (const page::RequestForm& form : page::RequestForms()) {
    // For anyone: control would not help.
    table.requests[form.name] = {
        .handle = [](const page::Request&) -> Json { throw page::RequestError(OnlyWatched()); },
        .is_for_anyone = true,
        .refuse = [](const page::Request&) { return std::optional(OnlyWatched()); }};
  }
  table.requests["library"] = {.handle =
                                   [](const page::Request&) {
                                     return Json{{"recordings", Json::array()}};
                                   },
                               .is_for_anyone = true};
  table.requests["brains"] = {.handle =
                                  [](const page::Request&) {
                                    return Json{{"brains", Json::array()}};
                                  },
                              .is_for_anyone = true};
  table.requests["allowed"] = {
      .handle =
          [](const page::Request& request) {
            constexpr std::size_t kMaxRequests = 16;
            const Json& asked = page::RequestFields(request).List("requests", kMaxRequests);
            return Json{{"allowed", std::vector<Json>(asked.size(), texts::ToJson(OnlyWatched()))}};
          },
      .is_for_anyone = true};
  page::AddControlRequests(&table);
  return table;
}

}  // namespace

ViewerSession::ViewerSession(std::shared_ptr<WatchedSimulation> simulation)
    : table_(RequestsOfAWatcher()), wanted_(std::move(simulation)) {
  Tick();
}

void ViewerSession::Show(std::shared_ptr<WatchedSimulation> simulation) {
  const std::lock_guard lock(mutex_);
  wanted_ = std::move(simulation);
}

bool ViewerSession::Tick() {
  {
    const std::lock_guard lock(mutex_);
    simulation_ = wanted_;
  }
  const auto before = std::exchange(moment_, simulation_->Latest());
  // Pages need a scene before its poses and state.
  if (!before || before->model != moment_->model) {
    state_announcer_.Reset();
    messages_.push_back(scene_announcer_.Announce(*moment_->model, moment_->state.variants));
  } else if (auto variants = scene_announcer_.UpdateVariants(moment_->state.variants)) {
    messages_.push_back(*std::move(variants));
  }
  for (Json& event : simulation_->TakeEvents()) messages_.push_back(std::move(event));
  if (num_ticks_ % kTicksPerSpeed == 0) {
    // A restored state may be an earlier one.
    const std::uint64_t passed =
        moment_->tick > tick_before_ ? moment_->tick - tick_before_ : std::uint64_t{0};
    speed_ = static_cast<double>(passed) / kTicksPerSpeed;
    tick_before_ = moment_->tick;
  }
  if (num_ticks_++ % kTicksPerWatchedState == 0) {
    if (auto state = state_announcer_.Update(DescribeState())) {
      messages_.push_back(*std::move(state));
    }
  }
  return true;
}

SessionUpdates ViewerSession::TakeUpdates() {
  return {.messages = std::exchange(messages_, {}), .view = std::nullopt};
}

std::vector<Json> ViewerSession::Everything() const {
  const std::vector<int>& variants = moment_->state.variants;
  return {scene_announcer_.Describe(*moment_->model, variants), LooksMessage(variants),
          DescribeState()};
}

page::Poses ViewerSession::NextPoses() {
  return poses_.Next({.model = &moment_->model->visual_model(),
                      .state = moment_->state,
                      .tick = moment_->tick,
                      .scene = scene_announcer_.number(),
                      .meters_per_unit = moment_->meters_per_unit});
}

Json ViewerSession::DescribeState() const {
  Json commands = Json::object();
  for (const char* name : {"start", "finish", "undo", "redo"})
    commands[name] = texts::ToJson(OnlyWatched());
  Json state_message = {
      {"t", "state"},
      {"mode", "watched"},
      {"allowed", {{"requests", page::AllowedRequests(table_)}, {"commands", commands}}},
      {"paused", false},
      {"speed", std::round(100 * speed_) / 100},
      {"recording", nullptr},
      {"failure", nullptr},
      {"playback", nullptr},
      {"restoring", nullptr},
      {"brain", LiveBrain().Describe()},
      {"snap", Json::array()},
      {"eye", nullptr},
      {"markers", Json::array()}};
  state_message.update(moment_->description);
  return state_message;
}

}  // namespace smile::studio
