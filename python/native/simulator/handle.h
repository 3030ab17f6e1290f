#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "picture/rendered_eye.h"
#include "recorder/recording_controller.h"
#include "sim/command_json.h"
#include "sim/per_action.h"
#include "sim/simulation.h"
#include "studio/watched_simulation.h"
#include "task/episode.h"
#include "thread_renderer.h"
#include "values.h"

namespace smile::python {

/// Keeps the events of a simulation. Those of undone actions are left out until they are redone.
class EventList : public sim::Listener {
 public:
  void OnEvent(const sim::Simulation& simulation, const sim::Event& event) override {
    events_[simulation.history().done().back().id].push_back({simulation.tick(), event});
  }
  std::vector<DatedEvent> EventsOf(const sim::Simulation& simulation) const {
    std::vector<DatedEvent> all;
    for (const auto& action : simulation.history().done()) {
      if (const auto* events = events_.Find(action.id)) {
        all.insert(all.end(), events->begin(), events->end());
      }
    }
    return all;
  }
  void Clear() { events_ = {}; }

 private:
  sim::PerAction<std::vector<DatedEvent>> events_;
};

/// State of a simulation and of the episodes that are observed in it.
struct SavedState {
  sim::SimulationState simulation;
  /// Contacts of each episode so far, by its number; nullopt if it cannot be continued.
  std::vector<std::optional<std::vector<task::ContactEvent>>> episodes;
};

/// A simulation as Python holds it: it can be closed, and refuses to be used by two threads at a
/// time, since the interpreter's lock is released while it works.
class Handle {
 public:
  explicit Handle(std::shared_ptr<const model::Model> model)
      : simulation_(std::make_unique<sim::Simulation>(std::move(model))) {
    simulation_->AddListener(&events_);
  }
  ~Handle() { Destroy(); }

  /// Exclusive use of the simulation, for as long as it lives.
  class Use {
   public:
    explicit Use(Handle* handle) : handle_(*handle) {
      if (handle_.is_in_use_.exchange(true)) {
        throw std::runtime_error(
            "the simulation is in use by another thread, expected one thread at a time");
      }
      if (handle_.simulation_ == nullptr) {
        handle_.is_in_use_ = false;
        throw std::runtime_error("the simulation is closed, expected an open one");
      }
      watched_ = handle_.watched_;
      if (watched_) lock_ = watched_->Lock();
    }
    ~Use() {
      if (lock_) lock_.unlock();
      handle_.is_in_use_ = false;
    }
    Use(const Use&) = delete;
    Use& operator=(const Use&) = delete;

    sim::Simulation& operator*() const { return *handle_.simulation_; }
    sim::Simulation* operator->() const { return handle_.simulation_.get(); }

   private:
    Handle& handle_;
    /// Of the handle when the use began: it may end within the use.
    std::shared_ptr<studio::WatchedSimulation> watched_;
    std::unique_lock<std::recursive_mutex> lock_;
  };

  /// Ends a recording, then the simulation. Does nothing if it is closed.
  void Close() {
    if (simulation_ == nullptr) return;
    const Use use(this);  // to the end: no other thread may begin while it is destroyed
    if (recording_) recording_->Flush();
    Destroy();
  }
  bool is_closed() const { return simulation_ == nullptr; }

  std::vector<DatedEvent> Events() {
    const Use use(this);
    return events_.EventsOf(*use);
  }
  SavedState Save() {
    const Use use(this);
    SavedState saved{.simulation = use->Save(), .episodes = {}};
    for (const Observation& one : observations_) {
      auto& contacts = saved.episodes.emplace_back();
      if (!one.is_broken) contacts = one.observer->episode().contacts;
    }
    return saved;
  }
  /// Continues from a state, with the episodes that were observed then. Those that began later
  /// cannot be continued.
  void Restore(const SavedState& saved) {
    const Use use(this);
    if (recording_ && recording_->is_recording()) {
      throw std::runtime_error(
          "a recording is in progress: a state cannot be restored, expected finish() first");
    }
    use->Restore(saved.simulation);
    events_.Clear();
    for (std::size_t i = 0; i < observations_.size(); ++i) {
      Observation& one = observations_[i];
      one.is_broken = i >= saved.episodes.size() || !saved.episodes[i];
      if (!one.is_broken) one.observer->Continue(*saved.episodes[i]);
    }
  }

  /// Begins to observe an episode, up to the end of the simulation.
  /// @returns its number, for EpisodeOf().
  std::size_t Observe() {
    const Use use(this);
    observations_.push_back({.observer = std::make_unique<task::EpisodeObserver>(&*use)});
    return observations_.size() - 1;
  }
  /// Returns an episode up to now. Requires the use of the simulation.
  /// @throws std::runtime_error if a state from before its begin was restored.
  task::Episode EpisodeOf(std::size_t number) const {
    if (observations_[number].is_broken) {
      throw std::runtime_error(
          "the restored state was saved before this task began, or in a simulation without it; "
          "expected a task that is made after restore()");
    }
    return observations_[number].observer->episode();
  }

  /// Returns the connection by which viewers watch the simulation, up to its end.
  std::shared_ptr<studio::WatchedSimulation> Watch() {
    const Use use(this);
    if (!watched_) watched_ = std::make_shared<studio::WatchedSimulation>(&*use);
    return watched_;
  }

  /// Starts a recording in a new directory.
  /// @param eye  nullopt for a recording without pictures.
  void Record(const std::filesystem::path& directory, const recorder::RecorderOptions& options,
              const std::optional<sim::EyeSpec>& eye) {
    const Use use(this);
    if (recording_ && recording_->is_recording()) {
      throw std::runtime_error("a recording is in progress, expected finish() first");
    }
    recording_.reset();
    eye_.reset();
    if (eye) {
      sim::EyeView(*use, *eye);  // throws if there is no such camera
      eye_.emplace(*eye, &RendererOfThread);
    }
    recording_.emplace(&*use, recorder::RecordingController::Options{
                                  .recording = options, .eye = eye_ ? &*eye_ : nullptr});
    try {
      recording_->StartIn(directory, *use);
    } catch (...) {
      EndRecording();
      throw;
    }
  }
  /// Ends the recording.
  /// @returns its directory.
  std::filesystem::path Finish() {
    const Use use(this);
    if (!recording_)
      throw std::runtime_error("no recording is in progress, expected record() first");
    if (recording_->failure()) throw std::runtime_error(*recording_->failure());
    const std::filesystem::path directory = recording_->directories().back();
    const auto refusal = use->Apply(sim::FinishRecording{});
    EndRecording();
    if (refusal) throw std::runtime_error(*refusal);
    return directory;
  }

 private:
  struct Observation {
    std::unique_ptr<task::EpisodeObserver> observer;
    bool is_broken = false;  ///< a state from before its begin was restored
  };

  void EndRecording() {
    if (simulation_ != nullptr && recording_) {
      simulation_->RemoveListener(&*recording_);
      simulation_->SetRecordingControl(nullptr);
    }
    recording_.reset();
    eye_.reset();
  }
  void Destroy() {
    EndRecording();
    observations_.clear();
    if (watched_) watched_->Detach();
    watched_.reset();
    simulation_.reset();
  }

  std::atomic<bool> is_in_use_ = false;
  EventList events_;
  std::unique_ptr<sim::Simulation> simulation_;  ///< null once it is closed
  std::vector<Observation> observations_;
  std::shared_ptr<studio::WatchedSimulation> watched_;  ///< null unless it is watched
  std::optional<picture::RenderedEye> eye_;             ///< of the recording
  std::optional<recorder::RecordingController> recording_;
};

}  // namespace smile::python
