#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/json.h"
#include "library/brain_choices.h"
#include "library/library.h"
#include "page/request_fields.h"
#include "recording/recording.h"
#include "studio/internal_scene_requests.h"
#include "studio/internal_scene_source.h"
#include "studio/internal_state_machine.h"
#include "studio/session_options.h"

namespace smile::studio {

/// Requests that list, start and stop brains.
class BrainRequests {
 public:
  /// All must outlive this.
  BrainRequests(const SessionOptions* options, const library::Library* library,
                const SceneSource* source, SceneRequests* scenes, StateMachine* states)
      : options_(options), library_(library), source_(source), scenes_(scenes), states_(states) {}

  Json Describe(const page::RequestFields& fields);
  Json Start(const page::RequestFields& fields);
  std::optional<texts::UserMessage> RefuseStart(const page::RequestFields& fields) const;
  Json Stop(const page::RequestFields& fields);
  Json Imitate(const page::RequestFields& fields);

 private:
  std::vector<library::BrainChoice> Choices() const;
  /// Returns the program of this name.
  /// @throws page::RequestError if there is no such program.
  library::BrainChoice Find(const std::string& name) const;
  void Run(const library::BrainChoice& choice, const std::filesystem::path& demonstration);
  /// Returns the scene that is open if it has this name, or else one that ships.
  scene::SceneSpec SceneNamed(const std::string& name) const;
  /// Starts the recording of the imitation. Returns its directory.
  std::filesystem::path RecordImitation(const recording::Recording& demonstration);

  const SessionOptions* options_;
  const library::Library* library_;
  const SceneSource* source_;
  SceneRequests* scenes_;
  StateMachine* states_;
};

}  // namespace smile::studio
