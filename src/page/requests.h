#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/diagnostic.h"
#include "base/json.h"

namespace smile::page {

/// Numbers clients from 1 on, in order of arrival.
using ClientId = int;

/// A request that cannot be carried out: its message is the answer.
class RequestError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// One request of a client; docs/studio-protocol.md describes them.
struct Request {
  ClientId client = 0;
  std::uint32_t seq = 0;
  std::string what;  ///< its `do`
  Json fields;       ///< all of it
};

/// Carries out a request. What it returns is added to the answer, unless it is AnswersLater(); what
/// it throws, a RequestError, InputError or std::invalid_argument, is the answer.
using RequestHandler = std::function<Json(const Request&)>;

/// Says why a request cannot be carried out as things are now; nullopt if it can. May throw as a
/// RequestHandler does.
using Precondition = std::function<std::optional<std::string>(const Request&)>;

/// Returned for slow requests, which are answered by a DeferredMessage.
Json AnswersLater();
bool IsLater(const Json& answer);

/// Deferred message: a late reply to one client, or an update that a request caused.
struct DeferredMessage {
  ClientId client = 0;  ///< 0: all clients
  Json message;
};

/// Request table: the handlers of all requests. Each part of the program adds its own.
struct RequestTable {
  struct Entry {
    RequestHandler handle;
    bool is_for_anyone = false;  ///< else only for the controller
    Precondition refuse = {};    ///< empty if nothing but its fields matters
  };
  std::map<std::string, Entry, std::less<>> entries;
  /// Sources of deferred messages: each returns those since its last call; called 60 times a
  /// second.
  std::vector<std::function<std::vector<DeferredMessage>()>> deferred;
};

/// `{"t":"reply",…}`, whatever happens; or IsLater(). An unknown `do` is answered with what there
/// is.
Json Answer(const RequestTable& table, const Request& request, bool is_controller);

/// Of each request with a precondition: may it be sent as things are now, without any field that
/// may be left out? As AllowedUnless() has it, by name.
Json AllowedRequests(const RequestTable& table);
/// True, or the reason why not.
Json AllowedUnless(const std::optional<std::string>& refusal);

/// Returns the reply to a request that `carry_out` carries out, in any thread.
Json AnswerWith(const Request& request, const std::function<Json()>& carry_out);

/// Returns the deferred messages of all sources, in order.
std::vector<DeferredMessage> TakeDeferred(const RequestTable& table);

}  // namespace smile::page
