#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "study/participants.h"
#include "web_server/web_server_options.h"

namespace smile::study {

struct StudyServerOptions {
  std::filesystem::path page;     ///< folder of the participants' page
  std::filesystem::path program;  ///< `smile`, which runs the sessions
  std::string address = "127.0.0.1";
  int port = 0;  ///< 0: the first free one from 8480 on
  std::optional<web_server::TlsFiles> tls;
  std::string public_origin;  ///< where browsers find the server behind a proxy; empty without one
  int max_sessions = 20;      ///< at a time; further participants wait
  std::uint64_t memory_bytes = std::uint64_t{2} << 30;  ///< of each session
  std::uint64_t disk_bytes = std::uint64_t{1} << 30;    ///< of each participant
};

/// Server of a study: participants' pages, and the sessions of their trials, at one port. Each
/// participant has a link with a secret. Addresses are neither kept nor printed.
class StudyServer {
 public:
  /// @throws std::runtime_error if no port is free or the page is missing.
  StudyServer(StudyData data, StudyServerOptions options);
  ~StudyServer();
  StudyServer(const StudyServer&) = delete;
  StudyServer& operator=(const StudyServer&) = delete;

  /// Returns the link without the secret: `http://127.0.0.1:8480/`.
  std::string link() const;
  /// Serves until `is_over` returns true.
  void Run(const std::function<bool()>& is_over);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

/// Returns a participant's link.
/// @param server  link of the server, with `/` at its end.
std::string LinkOf(const std::string& server, const Participant& participant);

}  // namespace smile::study
