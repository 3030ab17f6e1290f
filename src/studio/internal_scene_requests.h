#pragma once

#include "base/json.h"
#include "page/request_fields.h"
#include "studio/internal_scene_source.h"
#include "studio/internal_state_machine.h"

namespace smile::studio {

/// Requests that load or check a scene.
class SceneRequests {
 public:
  /// Both must outlive this.
  SceneRequests(const SceneSource* source, StateMachine* states)
      : source_(source), states_(states) {}

  Json Load(const page::RequestFields& fields);
  /// Loads the start scene of the world again.
  Json Reload(const page::RequestFields& fields);
  Json Check(const page::RequestFields& fields);

  /// @throws page::RequestError if it is refused.
  void LoadScene(scene::SceneSpec scene);

 private:
  const SceneSource* source_;
  StateMachine* states_;
};

}  // namespace smile::studio
