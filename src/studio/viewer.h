#pragma once

#include <memory>
#include <string>

#include "page/server.h"
#include "studio/watched_simulation.h"

namespace smile::studio {

/// Viewer: serves the studio's page, which shows a simulation that another thread of this process
/// advances. Any number of pages may watch it; none can change it, and other pages may frame it.
class Viewer {
 public:
  /// Starts to serve, in a thread of its own.
  /// @param options  `get` and `may_be_framed` are the viewer's own.
  /// @throws as page::Server does.
  Viewer(page::ServerOptions options, std::shared_ptr<WatchedSimulation> simulation);
  ~Viewer();
  Viewer(const Viewer&) = delete;
  Viewer& operator=(const Viewer&) = delete;

  /// Returns the link to open in a browser.
  std::string link() const;
  /// Shows another simulation.
  void Show(std::shared_ptr<WatchedSimulation> simulation);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace smile::studio
