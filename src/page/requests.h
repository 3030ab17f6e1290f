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

/// Numbers clients from 1 on, in the order in which they came.
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

/// What takes its time is answered by a Letter.
Json AnswersLater();
bool IsLater(const Json& answer);

/// What a client is told without being asked just now.
struct Letter {
  ClientId client = 0;  ///< 0: everyone
  Json message;
};

/// Who carries out what. The rooms' parts put in what they can do.
struct RequestTable {
  struct Entry {
    RequestHandler handle;
    bool is_for_anyone = false;  ///< else for the controller alone
    Precondition refuse = {};    ///< empty if nothing but its fields matters
  };
  std::map<std::string, Entry, std::less<>> entries;
  /// What there is to be told since they were last asked; to be asked 60 times a second.
  std::vector<std::function<std::vector<Letter>()>> letters;
};

/// `{"t":"reply",…}`, whatever happens; or IsLater(). An unknown `do` is answered with what there
/// is.
Json Answer(const RequestTable& table, const Request& request, bool is_controller);

/// Of each request with a precondition: may it be sent as things are now, without any field that
/// may be left out? As AllowedUnless() has it, by name.
Json AllowedRequests(const RequestTable& table);
/// True, or the reason why not.
Json AllowedUnless(const std::optional<std::string>& refusal);

/// Answer() to a request that somebody carries out, in whatever thread.
Json AnswerWith(const Request& request, const std::function<Json()>& carry_out);

/// From all who have something to tell, in order.
std::vector<Letter> TakeLetters(const RequestTable& table);

}  // namespace smile::page
