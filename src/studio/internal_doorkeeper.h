#pragma once

#include <string>

#include "studio/internal_http.h"

namespace smile::studio {

/// Who may come in. Pages of other sites may not, though the user's own browser brings them: what
/// it was asked for (`Host`) must be this machine, so that no other name leads here, and who asks
/// (`Origin`) must be our own page. Where others than programs of this machine may come, the token
/// of the printed link must be known as well.
class Doorkeeper {
 public:
  /// @param address  where the server listens.
  Doorkeeper(std::string address, int port, bool is_loopback);

  /// `http://127.0.0.1:8470/`, with the token where one is needed.
  std::string link() const;
  /// @throws HttpError if the request may not be answered.
  void Check(const HttpRequest& request) const;
  /// What makes a browser remember the token of this request; empty if it has none in its link.
  std::string CookieFor(const HttpRequest& request) const;

 private:
  bool IsOurs(std::string_view host) const;
  bool IsToken(std::string_view text) const;
  std::string cookie_name() const { return "smile_studio_" + std::to_string(port_); }

  std::string address_, machine_;
  int port_;
  bool is_loopback_;
  std::string token_;  ///< empty: none is needed
};

}  // namespace smile::studio
