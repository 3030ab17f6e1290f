// Random access to a trace, which is a stream of differences from tick to tick: bookmarks at equal
// distances hold complete states, from which reading continues. Time is a real number of ticks
// (at_), so that slow playback advances by fractions; the shown tick is the nearest one.

#include "library/playback.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include "base/diagnostic.h"
#include "base/wording.h"
#include "recording/trace_reader.h"
#include "recording/view_sample.h"

namespace smile::library {
namespace {

/// Maximal number of bookmarks of a recording of any length. A spacing of one second reaches 34
/// minutes; beyond, it doubles. A bookmark holds one complete tick.
constexpr std::size_t kMaxBookmarks = 2048;

}  // namespace

class Playback::Impl {
 public:
  Impl(std::string id, const std::filesystem::path& directory)
      : id_(std::move(id)), recording_(recording::OpenRecording(directory)), trace_(recording_) {
    Survey();
    GoTo(0);
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
    GoTo(std::min(at_ + rate_, static_cast<double>(num_ticks_)));
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

  /// Stores the falls among the events of a tick.
  void NoteFalls(std::uint64_t tick, const std::vector<sim::Event>& events) {
    for (const sim::Event& event : events) {
      if (event.kind == sim::EventKind::kFell) falls_.push_back({tick, event.object});
    }
  }

  /// Reads the whole trace once for its length, the falls, and the bookmarks. Their spacing doubles
  /// whenever there are too many, so that memory is bounded and seeking reads at most one spacing.
  void Survey() {
    std::uint64_t spacing = sim::kTicksPerSecond;
    NoteFalls(0, trace_.events_before_start());
    while (const auto moment = trace_.Next()) {
      NoteFalls(moment->tick, moment->events);
      // A recording may begin at any tick of its simulation.
      if (bookmarks_.empty()) first_tick_ = moment->tick;
      num_ticks_ = moment->tick - first_tick_;
      if (num_ticks_ % spacing != 0) continue;
      bookmarks_.push_back(trace_.MakeBookmark());
      if (bookmarks_.size() < kMaxBookmarks) continue;
      // Keeps every other one, which doubles the spacing.
      for (std::size_t i = 1; 2 * i < bookmarks_.size(); ++i) {
        bookmarks_[i] = std::move(bookmarks_[2 * i]);
      }
      bookmarks_.resize((bookmarks_.size() + 1) / 2);
      spacing *= 2;
    }
    if (bookmarks_.empty()) {
      throw InputError(
          {(recording_.directory / "trace.bin").string(), 0, "", "contains no moment"});
    }
  }

  /// @param at  [ticks from the start].
  void GoTo(double at) {
    const std::uint64_t tick = first_tick_ + static_cast<std::uint64_t>(std::llround(at));
    const auto after = std::upper_bound(
        bookmarks_.begin(), bookmarks_.end(), tick,
        [](std::uint64_t wanted, const auto& mark) { return wanted < mark.moment().tick; });
    const recording::TraceReader::Bookmark& before = *std::prev(after);
    // Reading on is cheaper than returning, unless a bookmark lies nearer to the tick.
    const bool can_read_on =
        has_moment_ && moment_.tick <= tick && moment_.tick >= before.moment().tick;
    if (!can_read_on) {
      trace_.ReturnTo(before);
      moment_ = before.moment();
      has_moment_ = true;
    }
    while (moment_.tick < tick) {
      auto next = trace_.Next();
      if (!next) break;
      moment_ = *std::move(next);
    }
    at_ = at;
  }

  std::string id_;
  recording::Recording recording_;
  recording::TraceReader trace_;
  std::vector<recording::TraceReader::Bookmark> bookmarks_;  ///< in order; the first tick's first
  std::vector<Fall> falls_;                                  ///< in order
  std::uint64_t first_tick_ = 0, num_ticks_ = 0;
  recording::TraceTick moment_;
  bool has_moment_ = false;
  double at_ = 0;  ///< [ticks from the start]
  double rate_ = 0;
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
