#pragma once

#include "page/server.h"
#include "studio/internal_pacer.h"
#include "studio/internal_view_press.h"
#include "studio/workplace.h"

namespace smile::studio {

/// Lets a workplace live: 60 times a second what clients ask for is carried out, time goes on, and
/// all is told. Belongs to the thread of the workplace.
class StudioLoop {
 public:
  /// Both must outlive this.
  StudioLoop(Workplace* workplace, page::Server* server);

  void Beat();
  /// When the next is due.
  Pacer::Time next_beat() const { return pacer_.next_beat(); }

 private:
  void CarryOutRequests();
  /// As many as there is time for.
  void DoTicks(int count);
  void SendUpdates(const page::Poses& poses);
  void TellNewClients();

  Workplace* workplace_;
  page::Server* server_;
  Pacer pacer_;
  ViewPress press_;
};

}  // namespace smile::studio
