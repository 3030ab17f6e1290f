#include "studio/internal_session_requests.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "base/wording.h"

namespace smile::studio {

SessionRequests::SessionRequests(const StateMachine* states, std::vector<RequestRow> rows,
                                 const std::function<void()>& on_request)
    : states_(states), rows_(std::move(rows)) {
  for (const RequestRow& row : rows_) {
    page::RequestTable::RegisteredRequest& registered = table_.requests[row.what];
    registered.is_for_anyone = row.is_for_anyone;
    registered.handle = [&row, on_request](const page::Request& request) {
      on_request();
      // The callback runs twice: the request must see the present view, and may invalidate it.
      Json answer = row.handle(page::RequestFields(request));
      on_request();
      return answer;
    };
    // Requests without rules have no entry in `allowed` of the state message.
    if (row.needs.empty() && !row.refuse) continue;
    registered.refuse = [this, &row](const page::Request& request) {
      return RefusalOf(row, request);
    };
  }
}

Json SessionRequests::Allowed(const page::RequestFields& fields) const {
  // A question may simulate its command on a copy of the world, so their number is bounded.
  constexpr std::size_t kMaxRequests = 16;
  Json allowed = Json::array();
  for (const Json& wanted : fields.List("requests", kMaxRequests)) {
    allowed.push_back(page::AllowedUnless(RefusalOf(wanted)));
  }
  return {{"allowed", std::move(allowed)}};
}

std::optional<texts::UserMessage> SessionRequests::RefusalOf(const RequestRow& row,
                                                             const page::Request& request) const {
  for (const Need need : row.needs) {
    if (auto reason = states_->Unmet(need)) return reason;
  }
  return row.refuse ? row.refuse(page::RequestFields(request)) : std::nullopt;
}

// `try_out` is asked last, as it may simulate the request on a copy of the world.
std::optional<texts::UserMessage> SessionRequests::RefusalOf(const Json& wanted) const {
  page::Request request{.fields = wanted};
  const page::RequestFields fields(request);
  request.what = fields.Text("do");
  const auto row = std::ranges::find_if(
      rows_, [&request](const RequestRow& one) { return one.what == request.what; });
  if (row == rows_.end()) {
    throw page::RequestError("cannot determine whether " + Quoted(request.what) + " is allowed");
  }
  if (auto reason = RefusalOf(*row, request)) return reason;
  return row->try_out ? row->try_out(fields) : std::nullopt;
}

}  // namespace smile::studio
