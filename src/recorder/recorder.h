#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "classic/classic_recorder.h"
#include "recording/append_file.h"
#include "recording/progress.h"
#include "recording/recording.h"
#include "recording/trace_writer.h"
#include "sim/eye.h"
#include "sim/per_action.h"
#include "sim/simulation.h"

namespace smile::recorder {

/// Options of a recording.
struct RecorderOptions {
  double frames_per_second = 4;  ///< of the classic view, at most 60
  bool has_symbols = true;       ///< false: the classic view contains pictures only
  std::string title, notes;
  recording::Origin origin = recording::Origin::kRecorded;
  std::optional<recording::Correction> corrects;
};

/// Records a simulation into a new directory (contents: docs/recording-format.md). Everything is
/// written as it happens: if the program ends for any reason, the complete part stays readable.
///
/// Undo and redo also move the recording. Undone actions leave the classic view, but remain in log
/// and trace.
class Recorder : public sim::Listener {
 public:
  /// Begins a recording at the present moment, also while hands hold something. The log begins with
  /// the commands that led there.
  /// @param eye  takes the pictures of the classic view; nullptr for text only. Must outlive this.
  /// @throws InputError if the directory exists and is not empty: a recording is never overwritten.
  /// @throws std::invalid_argument if the rate is not in (0, 60], or the simulation was restored
  ///         from a saved state, so that its past is unknown.
  /// @throws std::runtime_error with path and reason if something cannot be written, as do all
  ///         members.
  Recorder(const std::filesystem::path& directory, const RecorderOptions& options, sim::Eye* eye,
           const sim::Simulation& simulation);

  /// Continues a recording from any point of its history, as a new branch if that is not its end.
  /// The classic view is rebuilt.
  /// @param simulation  fresh, of the recording's scene and robot; is run to the point.
  /// @param progress    of that run, then of the classic view, which is finished in any case.
  /// @throws InputError if there is no such point, the recording has no commands, or they no longer
  ///         lead there. Nothing has changed then.
  /// @throws std::runtime_error if another program is recording into it.
  static std::unique_ptr<Recorder> Continue(const std::filesystem::path& directory,
                                            const recording::HistoryPoint& from, sim::Eye* eye,
                                            sim::Simulation* simulation,
                                            const recording::Progress& progress = {});

  /// Waits until everything recorded so far is written, also the pictures. The destructor does so
  /// too, but cannot report an error.
  void Flush() { classic_->Flush(); }

  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  std::optional<sim::Refusal> Refuse(const sim::Simulation& simulation,
                                     const sim::Command& command) override;
  void OnCommand(const sim::Simulation& simulation, const sim::Command& command) override;
  void OnEvent(const sim::Simulation& simulation, const sim::Event& event) override;
  void OnMove(const sim::Simulation& simulation, sim::ActionId from, sim::ActionId to) override;
  void OnTick(const sim::Simulation& simulation) override;

 private:
  /// Ends of log and trace at a point of the history.
  struct Savepoint {
    recording::HistoryPoint point;
    recording::TracePlace place = 0;
  };
  /// Savepoints of an action that began during the recording.
  struct ActionSavepoints {
    Savepoint before;
    classic::ClassicRecorder::Savepoint classic_before;
    Savepoint at_undo;  ///< valid while the action is undone
  };

  explicit Recorder(const std::filesystem::path& directory) : directory_(directory) {}
  void Begin(const RecorderOptions& options, sim::Eye* eye, const sim::Simulation& simulation);
  void Write(const recording::LogLine& line, double meters_per_unit);
  Savepoint MakeSavepoint() const;
  void Undo(const sim::Simulation& simulation, ActionSavepoints* undone);
  void Redo(const sim::Simulation& simulation, const ActionSavepoints& redone);
  /// Moves log and trace to another point, where the simulation already is.
  void Return(recording::ReturnKind kind, const Savepoint& to, const sim::Simulation& simulation);
  /// Restores a redone action in the classic view.
  void ShowAgain(const ActionSavepoints& redone, const sim::Simulation& simulation);
  /// Rebuilds the classic view from the trace, and the savepoints of its actions.
  void Rebuild(const recording::Recording& recording, sim::Eye* eye,
               const sim::Simulation& simulation, const recording::Progress& progress);

  std::filesystem::path directory_;
  std::optional<recording::AppendFile> log_;
  std::optional<recording::TraceWriter> trace_;
  std::optional<classic::ClassicRecorder> classic_;
  std::size_t num_lines_ = 0;
  std::uint64_t tick_ = 0;  ///< the last recorded tick
  sim::PerAction<ActionSavepoints> action_savepoints_;
};

}  // namespace smile::recorder
