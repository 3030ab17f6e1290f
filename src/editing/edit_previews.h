#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <vector>

#include "editing/edit.h"
#include "editing/re_simulation.h"

namespace smile::editing {

/// Edits of one recording, in order of application.
struct EditRequest {
  std::filesystem::path recording;  ///< its directory
  std::vector<Edit> edits;

  bool operator==(const EditRequest&) const = default;
};

/// Previews edits and saves them. The newest preview is kept as a recording without pictures, in a
/// temporary directory: saving the same edits draws the pictures without simulation, provided that
/// no file of the edited recording has changed. The result is the same either way.
///
/// May be used from several threads at once.
class EditPreviews {
 public:
  /// Function that makes the eye for a recording's pictures, in the thread that saves it.
  using MakeEye = std::function<std::unique_ptr<sim::Eye>(const sim::EyeSpec& spec)>;

  explicit EditPreviews(MakeEye make_eye);
  ~EditPreviews();
  EditPreviews(const EditPreviews&) = delete;
  EditPreviews& operator=(const EditPreviews&) = delete;

  /// Reports the effect of edits on the recording, which stays as it is.
  /// @throws as EditedByAll() and ReSimulate(); std::runtime_error if `progress` returns false.
  EditReport Preview(const EditRequest& request, const recording::Progress& progress = {});

  /// Makes the new recording, or nothing on failure, and removes the preview that it was made from.
  /// @param directory  new.
  /// @param progress   of the simulation, or of drawing what the preview simulated.
  /// @throws as Preview(); InputError if the directory exists.
  EditReport Save(const EditRequest& request, const std::filesystem::path& directory,
                  const recording::Progress& progress = {});

  /// Removes a kept preview that is at least this old.
  void RemoveOlderThan(std::chrono::steady_clock::duration age);

 private:
  struct Kept;
  std::shared_ptr<const Kept> Find(const EditRequest& request) const;

  MakeEye make_eye_;
  mutable std::mutex mutex_;  ///< of the next member
  /// Shared with a Save() in progress.
  std::shared_ptr<const Kept> kept_;
};

}  // namespace smile::editing
