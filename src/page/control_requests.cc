#include "page/control_requests.h"

#include <limits>
#include <memory>
#include <utility>

#include "page/request_fields.h"

namespace smile::page {

void AddControlRequests(RequestTable* table) {
  const auto letters = std::make_shared<std::vector<Letter>>();
  table->entries["keep_control"] = {[letters](const Request& request) {
    const auto from = RequestFields(request).Whole("from", std::numeric_limits<ClientId>::max());
    letters->push_back({.client = static_cast<ClientId>(from),
                        .message = {{"t", "control_kept"}, {"by", request.client}}});
    return Json::object();
  }};
  table->letters.emplace_back([letters] { return std::exchange(*letters, {}); });
}

}  // namespace smile::page
