#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostic.h"
#include "base/json.h"
#include "texts/message_error.h"

namespace smile::page {

/// Numbers clients from 1 on, in order of arrival.
using ClientId = int;

/// Refusal of a request: its message is the answer.
class RequestError : public texts::MessageError {
 public:
  using MessageError::MessageError;
};

/// Request of a client, see docs/studio-protocol.md.
struct Request {
  ClientId client = 0;
  std::uint32_t seq = 0;
  std::string what;  ///< its `do`
  Json fields;       ///< all of it
};

/// Executes a request. The returned JSON is added to the answer, unless it is AnswersLater(); a
/// thrown RequestError, InputError or std::invalid_argument becomes the answer.
using RequestHandler = std::function<Json(const Request&)>;

/// Returns the reason why a request cannot be executed in the present state; nullopt if it can. May
/// throw as a RequestHandler does.
using Precondition = std::function<std::optional<texts::UserMessage>(const Request&)>;

/// Returned for slow requests, which are answered by a DeferredMessage.
Json AnswersLater();
bool IsLater(const Json& answer);

/// Deferred message: a late reply to one client, or an update that a request caused.
struct DeferredMessage {
  ClientId client = 0;  ///< 0: all clients
  Json message;
};

/// Answers a request in the background by what `work` returns; the caller does not wait.
using InBackground = std::function<void(const Request& request, std::function<Json()> work)>;

/// Request table: the handlers of all requests. Each part of the program adds its own.
struct RequestTable {
  struct RegisteredRequest {
    RequestHandler handle;
    bool is_for_anyone = false;  ///< otherwise only for the controller
    Precondition refuse = {};    ///< empty if only its fields matter
  };
  std::map<std::string, RegisteredRequest, std::less<>> requests;
  /// Sources of deferred messages: each returns those since its last call; called 60 times a
  /// second.
  std::vector<std::function<std::vector<DeferredMessage>()>> deferred;
};

/// Returns `{"t":"reply",…}` in any case, or IsLater(). The answer to an unknown `do` lists the
/// known ones.
Json Answer(const RequestTable& table, const Request& request, bool is_controller);

/// Returns for each request with a precondition, by name, if it may be sent now without its
/// optional fields: the value of AllowedUnless().
Json AllowedRequests(const RequestTable& table);
/// Returns true, or the reason why not.
Json AllowedUnless(const std::optional<texts::UserMessage>& refusal);

/// Returns the reply to a request that `carry_out` executes, in any thread.
Json AnswerWith(const Request& request, const std::function<Json()>& carry_out);

/// Returns the deferred messages of all sources, in order.
std::vector<DeferredMessage> TakeDeferred(const RequestTable& table);

}  // namespace smile::page
