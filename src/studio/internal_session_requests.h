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
using RequestRefuser = std::function<std::optional<std::string>(const page::RequestFields&)>;

/// A request of a session, with the rules for it.
struct RequestRow {
  const char* what;  ///< its `do`
  std::function<Json(const page::RequestFields&)> handle;
  std::vector<Need> needs = {};
  bool is_for_anyone = false;
  RequestRefuser refuse = nullptr;  ///< asked when all needs are met
  /// Asked by `allowed` alone, after `refuse`: the reasons that `handle` would come upon.
  RequestRefuser try_out = nullptr;
};

/// The requests of a session: those that are carried out, and those that are only asked about, are
/// refused by the same rules.
class SessionRequests {
 public:
  /// @param on_request  called before and after a request is carried out.
  SessionRequests(const StateMachine* states, std::vector<RequestRow> rows,
                  const std::function<void()>& on_request);
  SessionRequests(const SessionRequests&) = delete;
  SessionRequests& operator=(const SessionRequests&) = delete;

  page::RequestTable& table() { return table_; }
  const page::RequestTable& table() const { return table_; }
  /// The answer to the request `allowed`.
  Json Allowed(const page::RequestFields& fields) const;

 private:
  std::optional<std::string> RefusalOf(const RequestRow& row, const page::Request& request) const;
  /// The same of a request that is not carried out.
  std::optional<std::string> RefusalOf(const Json& wanted) const;

  const StateMachine* states_;
  const std::vector<RequestRow> rows_;
  page::RequestTable table_;
};

}  // namespace smile::studio
