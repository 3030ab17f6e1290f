#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "page/server.h"
#include "studio/session.h"

namespace smile::studio {

struct StudioOptions {
  SessionOptions session;      ///< `jobs` is the studio's own
  page::ServerOptions server;  ///< `get` is the studio's own
};

/// A session, and the page that shows it in browsers.
class Studio {
 public:
  /// @throws InputError if the scene is wrong, and what Server throws.
  explicit Studio(StudioOptions options);
  ~Studio();
  Studio(const Studio&) = delete;
  Studio& operator=(const Studio&) = delete;

  /// What to open in a browser.
  std::string link() const;
  /// In real time, until it is over.
  void Run(const std::function<bool()>& is_over);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace smile::studio
