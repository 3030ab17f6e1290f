#include "page/requests.h"

#include <string_view>
#include <utility>

#include "base/wording.h"
#include "texts/message_json.h"
#include "texts/user_message.h"

namespace smile::page {

using texts::Say;
namespace {

Json Failure(const texts::UserMessage& message) {
  return {{"ok", false}, {"error", texts::ToJson(message)}};
}

/// Returns a failure with all diagnostics of an input.
Json Failure(const InputError& error) {
  Json failure = Failure(error.what());
  failure["diagnostics"] = Json::array();
  for (const Diagnostic& finding : error.diagnostics()) {
    failure["diagnostics"].push_back({{"file", finding.file},
                                      {"line", finding.line},
                                      {"element", finding.element},
                                      {"message", finding.message}});
  }
  return failure;
}

/// Returns the failure for a name that is not in the table.
Json Unknown(const RequestTable& table, const std::string& what) {
  std::vector<std::string_view> known;
  for (const auto& [name, registered] : table.requests) known.push_back(name);
  return Failure("there is no request " + Quoted(what) + ", expected " + OneOf(known) +
                 DidYouMean(what, known));
}

/// Returns a reply, which has the sequence number of its request.
Json Reply(const Request& request, const Json& fields) {
  Json answer = {{"t", "reply"}, {"seq", request.seq}};
  // Fields of the answer may not be called `t` or `seq`; the table of forms has no such names.
  answer.update(fields);
  return answer;
}

}  // namespace

// The only JSON value that no handler can return otherwise and that cannot be written as text, so
// it cannot be mistaken for an answer.
Json AnswersLater() { return Json(Json::value_t::discarded); }
bool IsLater(const Json& answer) { return answer.is_discarded(); }

Json Answer(const RequestTable& table, const Request& request, bool is_controller) {
  const auto registered = table.requests.find(request.what);
  if (registered == table.requests.end()) return Reply(request, Unknown(table, request.what));
  // Watchers learn first that they lack control; other reasons matter only to the controller.
  if (!registered->second.is_for_anyone && !is_controller) {
    return Reply(request, Failure(Say("control.isMissing")));
  }
  // The precondition is checked before the handler, and the same one is reported in `allowed`.
  return AnswerWith(request, [&] {
    const Precondition& refuse = registered->second.refuse;
    const auto refusal = refuse ? refuse(request) : std::nullopt;
    if (refusal) throw RequestError(*refusal);
    return registered->second.handle(request);
  });
}

Json AllowedRequests(const RequestTable& table) {
  Json allowed = Json::object();
  for (const auto& [name, registered] : table.requests) {
    // Requests without a precondition are always allowed and are left out, which keeps messages
    // short.
    if (!registered.refuse) continue;
    // Preconditions must accept missing fields here.
    const Request request{.what = name, .fields = Json::object()};
    allowed[name] = AllowedUnless(registered.refuse(request));
  }
  return allowed;
}

Json AllowedUnless(const std::optional<texts::UserMessage>& refusal) {
  return refusal ? texts::ToJson(*refusal) : Json(true);
}

Json AnswerWith(const Request& request, const std::function<Json()>& carry_out) {
  try {
    const Json found = carry_out();
    if (IsLater(found)) return found;
    Json fields = {{"ok", true}};
    fields.update(found);
    return Reply(request, fields);
  } catch (const InputError& error) {
    // The page marks the lines of the findings.
    return Reply(request, Failure(error));
  } catch (const texts::MessageError& error) {
    return Reply(request, Failure(error.message()));
  } catch (const std::exception& error) {
    return Reply(request, Failure(error.what()));
  }
}

std::vector<DeferredMessage> TakeDeferred(const RequestTable& table) {
  std::vector<DeferredMessage> all;
  for (const auto& take : table.deferred) {
    for (DeferredMessage& deferred : take()) all.push_back(std::move(deferred));
  }
  return all;
}

}  // namespace smile::page
