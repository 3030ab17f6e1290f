#pragma once

#include <string>
#include <vector>

#include "base/json.h"
#include "base/json_shape.h"

// Protocol between pages and the studio as tables: docs/studio-protocol.md and the page's types are
// generated from them, and tests compare all messages with them.

namespace smile::page {

/// Kind of request.
struct RequestForm {
  std::string name;                ///< its `do`
  std::vector<JsonMember> fields;  ///< beside `do` and `seq`
  std::vector<JsonMember> answer;  ///< beside `t`, `seq` and `ok`
  std::string remark;              ///< for people who write a page
  bool is_for_anyone = false;      ///< otherwise only for the controller
};
const std::vector<RequestForm>& RequestForms();

/// Kind of update: a message that is not a reply.
struct UpdateForm {
  std::string name;  ///< its `t`
  JsonShape shape;
  std::string remark;
};
const std::vector<UpdateForm>& UpdateForms();

/// Returns the first mismatch of a message to a page, with its place; empty if there is none.
/// @param request  `do` of the request that it answers, if it is a reply.
std::string MisfitOf(const Json& message, const std::string& request = "");
/// Returns the first mismatch of a request's fields.
std::string MisfitOfRequest(const Json& request);

}  // namespace smile::page
