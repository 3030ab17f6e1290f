// The web server's threads answer GETs from DoorList, find the port of a session there, and put
// messages of pages into the Mailbox. One thread, Run(), does everything else.

#include "study/study_server.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
#include <utility>

#include "base/diagnostic.h"
#include "base/files.h"
#include "study/internal_mailbox.h"
#include "study/step_message.h"
#include "study/visit.h"
#include "web_server/web_server.h"

namespace smile::study {
namespace {

constexpr std::chrono::milliseconds kTurn{10};
constexpr std::chrono::seconds kBetweenReading{1};
constexpr int kFirstPort = 8480;
constexpr std::size_t kMaxMessageBytes = 256 << 10, kMaxPublicFileBytes = 256 << 20;
constexpr std::string_view kPrefix = "/p/";

/// Path `/p/TOKEN/rest` in parts.
struct DoorPath {
  std::string token, rest;
};

std::optional<DoorPath> Parse(const std::string& path) {
  if (!path.starts_with(kPrefix)) return std::nullopt;
  const std::size_t end = std::min(path.find('/', kPrefix.size()), path.size());
  return DoorPath{path.substr(kPrefix.size(), end - kPrefix.size()),
                  path.substr(std::min(end + 1, path.size()))};
}

/// Returns the page of participants, with its texts in a language; the file is English.
/// @throws std::runtime_error if the file cannot be read, or does not say so.
std::string PageIn(const std::string& language, const std::filesystem::path& file) {
  constexpr std::string_view kEnglish = R"(lang="en" data-language="en")";
  std::string html = ReadFile(file, kMaxMessageBytes);
  if (language == "en") return html;
  const std::size_t found = html.find(kEnglish);
  if (found == std::string::npos) {
    throw std::runtime_error(file.string() + " has no " + std::string(kEnglish));
  }
  const std::string tag = '"' + language + '"';
  return html.replace(found, kEnglish.size(), "lang=" + tag + " data-language=" + tag);
}

std::string MediaTypeOf(const std::string& file) {
  return file.ends_with(".mp4") ? "video/mp4" : "image/png";
}

}  // namespace

/// Tokens, and the ports of their sessions; for all threads.
class DoorList {
 public:
  void Set(const StudyData& data) {
    const std::lock_guard lock(mutex_);
    tokens_.clear();
    for (const Participant& participant : data.participants()) tokens_.insert(participant.token);
  }
  void SetPort(const std::string& token, std::optional<int> port) {
    const std::lock_guard lock(mutex_);
    if (port) {
      ports_[token] = *port;
    } else {
      ports_.erase(token);
    }
  }
  bool Has(const std::string& token) {
    const std::lock_guard lock(mutex_);
    return tokens_.contains(token);
  }
  std::optional<int> PortOf(const std::string& token) {
    const std::lock_guard lock(mutex_);
    const auto port = ports_.find(token);
    return port == ports_.end() ? std::nullopt : std::optional<int>(port->second);
  }

 private:
  std::mutex mutex_;
  std::set<std::string> tokens_;
  std::map<std::string, int> ports_;
};

class StudyServer::Impl {
 public:
  Impl(StudyData data, StudyServerOptions options)
      : data_(std::move(data)),
        study_(data_.study()),
        options_(std::move(options)),
        files_(PublicFilesOf(study_)),
        page_html_(PageIn(study_.language, options_.page / "index.html")),
        web_(WebOptions(), &mailbox_) {
    doors_.Set(data_);
    services_ = {.send = [this](PageId page, const Json& message) { Send(page, message); },
                 .set_port = [this](const std::string& token,
                                    std::optional<int> port) { doors_.SetPort(token, port); },
                 .has_room = [this] { return NumSessions() < options_.max_sessions; },
                 .program = options_.program,
                 .memory_bytes = options_.memory_bytes,
                 .disk_bytes = options_.disk_bytes};
  }

  std::string link() const { return web_.link(); }

  void Run(const std::function<bool()>& is_over) {
    while (!is_over()) {
      for (const PageMessage& message : mailbox_.Take()) Deliver(message);
      for (auto& [token, visit] : visits_) visit->Update();
      web_.Resume();
      std::this_thread::sleep_for(kTurn);
    }
  }

 private:
  web_server::WebServerOptions WebOptions() {
    return {.address = options_.address,
            .port = options_.port,
            .first_port = kFirstPort,
            .cookie = "smile_study",
            .files = options_.page,
            .get = [this](const std::string& path) { return Get(path); },
            .relay = [this](const std::string& path) { return FindSession(path); },
            .needs_token = false,
            .public_origin = options_.public_origin,
            .tls = options_.tls,
            .limits = {.message_bytes = kMaxMessageBytes,
                       .messages_per_second = 50,
                       .connections = 1024}};
  }

  /// Answers a GET, in a thread of the web server.
  std::optional<web_server::HttpResponse> Get(const std::string& path) {
    constexpr std::string_view kFile = "file/";
    const auto door = Parse(path);
    if (!door || !doors_.Has(door->token)) return std::nullopt;
    if (door->rest.empty()) {
      return web_server::HttpResponse{"text/html; charset=utf-8", page_html_, ""};
    }
    if (!door->rest.starts_with(kFile)) return std::nullopt;
    const std::string file = door->rest.substr(kFile.size());
    if (std::ranges::find(files_, file) == files_.end()) return std::nullopt;
    return web_server::HttpResponse{MediaTypeOf(file),
                                    ReadFile(study_.folder / file, kMaxPublicFileBytes), ""};
  }

  std::optional<web_server::RelayTarget> FindSession(const std::string& path) {
    constexpr std::string_view kSession = "session/";
    const auto door = Parse(path);
    if (!door || !door->rest.starts_with(kSession)) return std::nullopt;
    const auto port = doors_.PortOf(door->token);
    if (!port) return std::nullopt;
    return web_server::RelayTarget{*port, "/" + door->rest.substr(kSession.size())};
  }

  void Send(PageId page, const Json& message) { mailbox_.Send(page, message); }

  void Deliver(const PageMessage& message) {
    const auto of_page = pages_.find(message.page);
    try {
      if (message.content.is_null()) {
        if (of_page != pages_.end()) visits_.at(of_page->second)->Leave(message.page);
        pages_.erase(message.page);
      } else if (of_page == pages_.end()) {
        Welcome(message);
      } else {
        visits_.at(of_page->second)->Receive(message.content);
      }
    } catch (const std::exception& error) {
      Send(message.page, {{"t", "error"}, {"error", error.what()}});
    }
  }

  /// Takes the first message of a page, which has the token.
  void Welcome(const PageMessage& message) {
    const Json& hello = message.content;
    const std::string token = hello.value("do", "") == "hello" ? hello.value("token", "") : "";
    const Participant* participant = Find(token);
    if (participant == nullptr) {
      Send(message.page, {{"t", "unknown"}});
      return mailbox_.CloseAfterAll(message.page, "there is no such link");
    }
    if (!visits_.contains(token)) {
      visits_[token] = std::make_unique<Visit>(&study_, *participant, &services_);
    }
    pages_[message.page] = token;
    visits_[token]->Enter(message.page);
  }

  /// Returns the participant, also one that was added since the start; nullptr if there is none.
  const Participant* Find(const std::string& token) {
    const Participant* found = data_.FindByToken(token);
    const auto now = std::chrono::steady_clock::now();
    if (found != nullptr || now - read_ < kBetweenReading) return found;
    read_ = now;
    data_ = StudyData(data_.folder());
    doors_.Set(data_);
    return data_.FindByToken(token);
  }

  int NumSessions() const {
    return static_cast<int>(std::ranges::count_if(
        visits_, [](const auto& visit) { return visit.second->is_in_session(); }));
  }

  StudyData data_;
  const Definition study_;
  const StudyServerOptions options_;
  const std::vector<std::string> files_;
  const std::string page_html_;
  DoorList doors_;
  Mailbox mailbox_;
  VisitServices services_;
  std::map<PageId, std::string> pages_;  ///< tokens
  std::map<std::string, std::unique_ptr<Visit>> visits_;
  std::chrono::steady_clock::time_point read_;
  // Destroyed first, as its threads use the members above.
  web_server::WebServer web_;
};

StudyServer::StudyServer(StudyData data, StudyServerOptions options)
    : impl_(std::make_unique<Impl>(std::move(data), std::move(options))) {}
StudyServer::~StudyServer() = default;

std::string StudyServer::link() const { return impl_->link(); }
void StudyServer::Run(const std::function<bool()>& is_over) { impl_->Run(is_over); }

std::string LinkOf(const std::string& server, const Participant& participant) {
  return server + std::string(kPrefix.substr(1)) + participant.token;
}

}  // namespace smile::study
