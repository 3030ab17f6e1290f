#pragma once

#include <string>
#include <vector>

#include "base/json.h"
#include "base/json_shape.h"

// What pages and the studio say to each other, as tables: docs/studio-protocol.md and the page's
// types are made from them, and tests hold against them what is really said.

namespace smile::page {

/// One kind of request.
struct RequestForm {
  std::string name;                ///< its `do`
  std::vector<JsonMember> fields;  ///< beside `do` and `seq`
  std::vector<JsonMember> answer;  ///< beside `t`, `seq` and `ok`
  std::string remark;              ///< for people who write a page
  bool is_for_anyone = false;      ///< else for the controller alone
};
const std::vector<RequestForm>& RequestForms();

/// One kind of message that nobody asked for.
struct NewsForm {
  std::string name;  ///< its `t`
  JsonShape shape;
  std::string remark;
};
const std::vector<NewsForm>& NewsForms();

/// What is wrong with a message that is sent to a page, and where; empty: nothing.
/// @param request  `do` of the request that it answers, if it is a reply.
std::string MisfitOf(const Json& message, const std::string& request = "");
/// The same of the fields of a request.
std::string MisfitOfRequest(const Json& request);

}  // namespace smile::page
