#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/json.h"
#include "page/request_fields.h"
#include "page/requests.h"
#include "studio/internal_state_machine.h"

namespace smile::studio {

/// Returns why a request is refused, by its fields; nullopt if it is not.
using RequestRefuser = std::function<std::optional<texts::UserMessage>(const page::RequestFields&)>;

/// A request of a session, with the rules for it.
struct RequestRow {
  const char* what;  ///< its `do`
  std::function<Json(const page::RequestFields&)> handle;
  std::vector<Need> needs = {};
  bool is_for_anyone = false;
  RequestRefuser refuse = nullptr;  ///< called if all needs are met
  /// Called by `allowed` only, after `refuse`: returns the reason for which `handle` would refuse.
  RequestRefuser try_out = nullptr;
};

/// Requests of a session. The same rules refuse requests that are executed and requests that are
/// only asked about.
class SessionRequests {
 public:
  /// @param on_request  called before and after a request is executed.
  SessionRequests(const StateMachine* states, std::vector<RequestRow> rows,
                  const std::function<void()>& on_request);
  SessionRequests(const SessionRequests&) = delete;
  SessionRequests& operator=(const SessionRequests&) = delete;

  page::RequestTable& table() { return table_; }
  const page::RequestTable& table() const { return table_; }
  /// Answers the request `allowed`.
  Json Allowed(const page::RequestFields& fields) const;

 private:
  std::optional<texts::UserMessage> RefusalOf(const RequestRow& row,
                                              const page::Request& request) const;
  /// Returns the reason why a request, given as JSON, would be refused.
  std::optional<texts::UserMessage> RefusalOf(const Json& wanted) const;

  const StateMachine* states_;
  const std::vector<RequestRow> rows_;
  page::RequestTable table_;
};

}  // namespace smile::studio
