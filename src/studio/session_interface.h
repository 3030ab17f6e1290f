#pragma once

#include <vector>

#include "base/json.h"
#include "page/requests.h"
#include "page/server.h"
#include "studio/session.h"

namespace smile::studio {

/// Session interface: the part of a session that StudioLoop drives; tests replace it by a simple
/// one.
class SessionInterface {
 public:
  virtual ~SessionInterface() = default;

  // See Session.

  virtual const page::RequestTable& requests() const = 0;
  virtual bool Tick() = 0;
  virtual SessionUpdates TakeUpdates() = 0;
  virtual std::vector<Json> Everything() const = 0;
  virtual double speed_factor() const = 0;
  virtual void SetMeasuredSpeed(double factor) = 0;

  /// Returns the poses that changed since the last call; called 60 times a second.
  virtual page::Poses NextPoses() = 0;
};

}  // namespace smile::studio
