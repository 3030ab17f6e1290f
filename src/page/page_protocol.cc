#include "page/page_protocol.h"

#include <algorithm>

#include "page/internal_request_forms.h"
#include "page/internal_shapes.h"
#include "page/internal_update_forms.h"

// The forms of all messages, and the checks of messages against them. Only tests check: the session
// itself reads fields one by one and reports faults in words for people (RequestFields).

namespace smile::page {
namespace {

/// Returns the form of a request; null if it is unknown.
const RequestForm* FindRequest(const std::string& name) {
  const auto found = std::ranges::find(RequestForms(), name, &RequestForm::name);
  return found != RequestForms().end() ? &*found : nullptr;
}

/// Returns the first mismatch of a reply; the fields of `answer` are present only after success.
std::string MisfitOfReply(const Json& reply, const std::string& request) {
  std::vector<JsonMember> members = {
      KindMember("reply"), {"seq", NumberShape()}, {"ok", FlagShape()}};
  const RequestForm* form = FindRequest(request);
  if (reply.value("ok", false)) {
    if (form == nullptr) return "there is no request " + request;
    members.insert(members.end(), form->answer.begin(), form->answer.end());
  } else {
    members.push_back({"error", MessageShape()});
    // Present only for faulty inputs with lines, such as scenes.
    members.push_back({"diagnostics", JsonShape::List(DiagnosticShape()), kOptional});
  }
  std::string misfit;
  ObjectShape(members).Fits(reply, &misfit);
  return misfit;
}

}  // namespace

const std::vector<RequestForm>& RequestForms() {
  // Built at first use: the forms depend on tables in other files, whose order of initialization is
  // unspecified.
  static const std::vector<RequestForm> kForms = MakeRequestForms();
  return kForms;
}

const std::vector<UpdateForm>& UpdateForms() {
  static const std::vector<UpdateForm> kForms = MakeUpdateForms();
  return kForms;
}

std::string MisfitOf(const Json& message, const std::string& request) {
  const std::string kind = message.value("t", "");
  if (kind == "reply") return MisfitOfReply(message, request);
  const auto form = std::ranges::find(UpdateForms(), kind, &UpdateForm::name);
  if (form == UpdateForms().end()) return "there is no message \"" + kind + "\"";
  std::string misfit;
  form->shape.Fits(message, &misfit);
  return misfit;
}

std::string MisfitOfRequest(const Json& request) {
  const RequestForm* form = FindRequest(request.value("do", ""));
  if (form == nullptr) return "unknown request";
  std::vector<JsonMember> members = {{"do", TextShape()}, {"seq", NumberShape(), kOptional}};
  members.insert(members.end(), form->fields.begin(), form->fields.end());
  std::string misfit;
  ObjectShape(members).Fits(request, &misfit);
  return misfit;
}

}  // namespace smile::page
