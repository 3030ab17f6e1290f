#pragma once

#include "base/json.h"
#include "library/library.h"
#include "page/request_fields.h"
#include "studio/internal_state_machine.h"
#include "studio/session_options.h"

namespace smile::studio {

/// Requests that show a recording, or continue it from a point of its history.
class PlaybackRequests {
 public:
  /// All must outlive this. `branch` requires background jobs.
  PlaybackRequests(const SessionOptions* options, const library::Library* library,
                   StateMachine* states)
      : options_(options), library_(library), states_(states) {}

  Json Show(const page::RequestFields& fields);
  Json Play(const page::RequestFields& fields);
  Json GoLive(const page::RequestFields& fields);
  Json Branch(const page::RequestFields& fields);
  Json RecordOver(const page::RequestFields& fields);
  Json Correct(const page::RequestFields& fields);

 private:
  Json Restore(const page::RequestFields& fields, Restoring::From from);

  const SessionOptions* options_;
  const library::Library* library_;
  StateMachine* states_;
};

}  // namespace smile::studio
