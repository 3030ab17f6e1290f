// Time is a real number of ticks (at_), so that slow playback advances by fractions; the shown tick
// is the nearest one.

#include "library/playback.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "base/diagnostic.h"
#include "base/wording.h"
#include "recording/trace_reader.h"
#include "recording/view_sample.h"

namespace smile::library {
class Playback::Impl {
 public:
  Impl(std::string id, const std::filesystem::path& directory)
      : id_(std::move(id)), recording_(recording::OpenRecording(directory)), trace_(recording_) {
    auto first = trace_.Next();
    if (!first) {
      throw InputError(
          {(recording_.directory / "trace.bin").string(), 0, "", "contains no moment"});
    }
    moment_ = *std::move(first);
    // A recording may begin at any tick of its simulation.
    first_tick_ = moment_.tick;
    num_ticks_ = trace_.LastTick().value_or(first_tick_) - first_tick_;
    for (const sim::Event& event : trace_.events_before_start()) NoteFall(0, event);
    for (const recording::TracedEvent& traced : trace_.Events()) {
      NoteFall(traced.tick, traced.event);
    }
  }

  const std::string& id() const { return id_; }
  const recording::Recording& recording() const { return recording_; }
  const model::Model& model() const { return *recording_.model; }
  const recording::TraceTick& moment() const { return moment_; }

  std::vector<std::string> fallen() const {
    std::vector<std::string> ids;
    for (const Fall& fall : falls_) {
      if (fall.tick <= moment_.tick) ids.push_back(fall.object);
    }
    return ids;
  }

  double seconds() const { return at_ / sim::kTicksPerSecond; }
  double length() const { return sim::SecondsOf(num_ticks_); }
  double rate() const { return rate_; }

  void SetRate(double rate) {
    if (!(rate >= 0 && rate <= kMaxRate)) {
      throw std::invalid_argument("rate is " + NumberText(rate) + ", expected 0 to " +
                                  NumberText(kMaxRate));
    }
    if (rate > 0 && failure_) throw std::runtime_error(*std::exchange(failure_, std::nullopt));
    // Playing at the end begins again.
    if (rate > 0 && is_at_end()) GoTo(0);
    rate_ = rate;
  }

  void Seek(double seconds) {
    if (std::isnan(seconds)) throw std::invalid_argument("seconds is NaN, expected a time");
    // Infinity is allowed and means an end; NaN is not, as clamp() would pass it on.
    GoTo(std::clamp(seconds, 0.0, length()) * sim::kTicksPerSecond);
  }

  // Called 60 times per second of wall-clock time, so the rate is the number of ticks per call.
  void Tick() {
    if (rate_ == 0) return;
    try {
      GoTo(std::min(at_ + rate_, static_cast<double>(num_ticks_)));
    } catch (const std::exception& error) {
      // The trace is read as it is played: it may be damaged here, or be cut meanwhile.
      failure_ = error.what();
      rate_ = 0;
    }
    if (is_at_end()) rate_ = 0;
  }

  DisplayedState view() const {
    return {.model = &model().visual_model(),
            .state = recording::VisualStateAt(moment_, model()),
            .tick = moment_.tick};
  }

 private:
  bool is_at_end() const { return at_ >= static_cast<double>(num_ticks_); }

  /// Fall of an object to the floor; tick 0 for objects that lay there at the start.
  struct Fall {
    std::uint64_t tick = 0;
    std::string object;
  };

  void NoteFall(std::uint64_t tick, const sim::Event& event) {
    if (event.kind == sim::EventKind::kFell) falls_.push_back({tick, event.object});
  }

  /// @param at  [ticks from the start].
  void GoTo(double at) {
    const std::uint64_t tick = first_tick_ + static_cast<std::uint64_t>(std::llround(at));
    if (auto moment = trace_.At(tick)) moment_ = *std::move(moment);
    at_ = at;
  }

  std::string id_;
  recording::Recording recording_;
  recording::TraceReader trace_;
  std::vector<Fall> falls_;  ///< in order
  std::uint64_t first_tick_ = 0, num_ticks_ = 0;
  recording::TraceTick moment_;
  double at_ = 0;  ///< [ticks from the start]
  double rate_ = 0;
  std::optional<std::string> failure_;  ///< why playing ended, until it is reported
};

Playback::Playback(std::string id, const std::filesystem::path& directory)
    : impl_(std::make_unique<Impl>(std::move(id), directory)) {}
Playback::~Playback() = default;

const std::string& Playback::id() const { return impl_->id(); }
const recording::Recording& Playback::recording() const { return impl_->recording(); }
const model::Model& Playback::model() const { return impl_->model(); }
double Playback::seconds() const { return impl_->seconds(); }
double Playback::length() const { return impl_->length(); }
double Playback::rate() const { return impl_->rate(); }
void Playback::SetRate(double rate) { impl_->SetRate(rate); }
void Playback::Seek(double seconds) { impl_->Seek(seconds); }
void Playback::Tick() { impl_->Tick(); }
const recording::TraceTick& Playback::moment() const { return impl_->moment(); }
std::vector<std::string> Playback::fallen() const { return impl_->fallen(); }
DisplayedState Playback::view() const { return impl_->view(); }

}  // namespace smile::library
