#pragma once

#include <vector>

#include "base/json.h"
#include "page/requests.h"
#include "page/server.h"
#include "studio/session.h"

namespace smile::studio {

/// What the studio's loop needs of a session, so that tests can have a simple one.
class Workplace {
 public:
  virtual ~Workplace() = default;

  // As Session has them.

  virtual const page::RequestTable& requests() const = 0;
  virtual bool Tick() = 0;
  virtual SessionUpdates TakeUpdates() = 0;
  virtual std::vector<Json> Everything() const = 0;
  virtual double speed_factor() const = 0;
  virtual void SetMeasuredSpeed(double factor) = 0;

  /// What moved since this was last asked; to be asked 60 times a second.
  virtual page::Poses NextPoses() = 0;
};

}  // namespace smile::studio
