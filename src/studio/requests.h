#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/diagnostic.h"
#include "base/json.h"

namespace smile::studio {

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

/// Carries out a request. What it returns is added to the answer; what it throws, a RequestError,
/// InputError or std::invalid_argument, is the answer.
using RequestHandler = std::function<Json(const Request&)>;

/// Who carries out what. The rooms' parts put in what they can do.
struct RequestTable {
  struct Entry {
    RequestHandler handle;
    bool is_for_anyone = false;  ///< else for the controller alone
  };
  std::map<std::string, Entry, std::less<>> entries;
};

/// `{"t":"reply",…}`, whatever happens. An unknown `do` is answered with what there is.
Json Answer(const RequestTable& table, const Request& request, bool is_controller);

}  // namespace smile::studio
