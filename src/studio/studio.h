#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "datasets/dataset_requests.h"
#include "page/requests.h"
#include "page/server.h"
#include "studio/session.h"

namespace smile::studio {

struct StudioOptions {
  SessionOptions session;  ///< `jobs` is the studio's own
  /// Scenes, brains and whether there is a robot are those of the session.
  datasets::DatasetOptions datasets;
  page::ServerOptions server;  ///< `get` is the studio's own
  /// Returns why a request is refused whatever the state, for clients that may do less; may be
  /// empty.
  page::Precondition refuse;
};

/// Session with a web server and the page for browsers.
class Studio {
 public:
  /// @throws InputError if the scene is invalid, and as Server does.
  explicit Studio(StudioOptions options);
  ~Studio();
  Studio(const Studio&) = delete;
  Studio& operator=(const Studio&) = delete;

  /// Returns the link to open in a browser.
  std::string link() const;
  /// Runs in real time until `is_over` returns true.
  void Run(const std::function<bool()>& is_over);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace smile::studio
