#include "page/control_requests.h"

#include <limits>
#include <memory>
#include <utility>

#include "page/request_fields.h"

namespace smile::page {

void AddControlRequests(RequestTable* table) {
  // Shared by the handler and the source of deferred messages. Both run in the session's thread, so
  // no lock is needed.
  // A handler answers only its own client; a message to another one is deferred.
  const auto deferred = std::make_shared<std::vector<DeferredMessage>>();
  table->requests["keep_control"] = {[deferred](const Request& request) {
    const auto from = RequestFields(request).Whole("from", std::numeric_limits<ClientId>::max());
    deferred->push_back({.client = static_cast<ClientId>(from),
                         .message = {{"t", "control_kept"}, {"by", request.client}}});
    return Json::object();
  }};
  table->deferred.emplace_back([deferred] { return std::exchange(*deferred, {}); });
}

}  // namespace smile::page
