// Pages: the studio's page on a simulator in Python, see python/smile/adapters/page.py.

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <map>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "arrays.h"
#include "bindings.h"
#include "page/control_requests.h"
#include "page/page_protocol.h"
#include "page/server.h"
#include "sim/command_json.h"
#include "sim/drag.h"

namespace smile::python {

namespace py = pybind11;

namespace {

/// Contents that web pages fetch. Thread-safe.
class Contents {
 public:
  void Put(const std::string& path, web_server::HttpResponse content) {
    const std::lock_guard lock(mutex_);
    at_[path] = std::move(content);
  }
  std::optional<web_server::HttpResponse> Find(const std::string& path) const {
    const std::lock_guard lock(mutex_);
    const auto found = at_.find(path);
    return found == at_.end() ? std::nullopt : std::optional(found->second);
  }

 private:
  mutable std::mutex mutex_;
  std::map<std::string, web_server::HttpResponse> at_;
};

/// Returns a message in JSON.
/// @throws std::invalid_argument if pages do not expect it, with the first misfit.
Json MessageFrom(const std::string& text) {
  Json message = Json::parse(text);
  const std::string misfit = page::MisfitOf(message);
  if (!misfit.empty()) throw std::invalid_argument("message: " + misfit);
  return message;
}

/// The studio's page, and the requests and messages of those who have it open. All requests are
/// carried out in update(), by functions of Python.
class PageServer {
 public:
  PageServer(const std::filesystem::path& folder, int port, py::object everything)
      : everything_(std::move(everything)) {
    page::AddControlRequests(&table_);
    const py::gil_scoped_release release;
    server_ = std::make_unique<page::Server>(
        page::ServerOptions{.port = port, .page = folder, .get = [this](const std::string& path) {
                              return contents_.Find(path);
                            }});
  }

  /// Carries out requests of a kind: a function of their fields in JSON returns the answer in JSON,
  /// and raises RuntimeError or ValueError with the reason if it cannot.
  void Handle(const std::string& name, py::object carry_out) {
    const auto form = std::ranges::find(page::RequestForms(), name, &page::RequestForm::name);
    if (form == page::RequestForms().end()) throw std::invalid_argument("no request " + name);
    const auto handle = [carry_out = std::move(carry_out)](const page::Request& request) {
      const std::string misfit = page::MisfitOfRequest(request.fields);
      if (!misfit.empty()) throw page::RequestError(request.what + ": " + misfit);
      return AnswerOf(carry_out, request.fields.dump());
    };
    table_.requests[name] = {.handle = handle, .is_for_anyone = form->is_for_anyone};
  }

  void Put(const std::string& path, const std::string& type, const py::bytes& body) {
    contents_.Put(path, {.type = type, .body = body});
  }

  /// Answers the requests since the last call, and sends everything to those who have come.
  void Update() {
    for (const page::Request& request : server().TakeRequests()) {
      server().Send(request.client,
                    page::Answer(table_, request, server().IsController(request.client)));
    }
    for (const page::DeferredMessage& deferred : TakeDeferred(table_)) {
      server().Send(deferred.client, deferred.message);
    }
    for (const page::ClientId client : server().TakeNewClients()) {
      for (const auto& message : everything_().cast<std::vector<std::string>>()) {
        server().Send(client, MessageFrom(message));
      }
    }
  }

  void Send(const std::string& message) { server().SendToAll(MessageFrom(message)); }

  /// @param poses  seven numbers a frame: x, y, z [units], qx, qy, qz, qw.
  void SendPoses(std::uint32_t scene, std::uint32_t tick, bool is_key,
                 const std::vector<std::uint32_t>& frames, const std::vector<float>& poses) {
    if (poses.size() != 7 * frames.size()) throw std::invalid_argument("poses: expected 7 a frame");
    server().SendPoses({scene, tick, is_key, frames, poses});
  }

  std::string link() const { return server().link(); }
  bool is_closed() const { return server_ == nullptr; }
  void Close() {
    // Functions may hold what holds this.
    table_ = {};
    everything_ = {};
    const py::gil_scoped_release release;
    server_.reset();
  }

 private:
  static Json AnswerOf(const py::object& carry_out, const std::string& fields) {
    try {
      return Json::parse(carry_out(fields).cast<std::string>());
    } catch (py::error_already_set& error) {
      // Refused is a RuntimeError.
      if (!error.matches(PyExc_RuntimeError) && !error.matches(PyExc_ValueError)) throw;
      throw page::RequestError(py::str(error.value()).cast<std::string>());
    }
  }
  page::Server& server() const {
    if (server_ == nullptr) throw std::runtime_error("the page is closed, expected an open one");
    return *server_;
  }

  Contents contents_;
  page::RequestTable table_;
  py::object everything_;
  std::unique_ptr<page::Server> server_;  ///< null once it is closed; destroyed first
};

/// Returns a command of a page in SI units and degrees, in JSON; of a drag (hand, origin,
/// direction, is_level, speed) instead.
py::object ReadCommand(const std::string& text, double meters_per_unit) {
  const Json command = Json::parse(text);
  if (!sim::IsDrag(command)) {
    return py::str(sim::ToJson(sim::ParseCommand(command, meters_per_unit), 1).dump());
  }
  const sim::Drag drag = sim::ParseDrag(command, meters_per_unit);
  return py::make_tuple(std::string(ToString(drag.hand)), ArrayOf(drag.p_WOrigin),
                        ArrayOf(drag.direction_in_world), drag.is_level, drag.speed);
}

}  // namespace

void BindPages(py::module_& m) {
  py::class_<PageServer>(m, "PageServer")
      .def(py::init<const std::filesystem::path&, int, py::object>(), py::arg("folder"),
           py::arg("port"), py::arg("everything"))
      .def("handle", &PageServer::Handle)
      .def("put", &PageServer::Put)
      .def("update", &PageServer::Update)
      .def("send", &PageServer::Send)
      .def("send_poses", &PageServer::SendPoses)
      .def_property_readonly("link", &PageServer::link)
      .def_property_readonly("is_closed", &PageServer::is_closed)
      .def("close", &PageServer::Close);
  m.def("read_command", &ReadCommand);
}

}  // namespace smile::python
