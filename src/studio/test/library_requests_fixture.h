#pragma once

#include <algorithm>
#include <chrono>
#include <iterator>
#include <map>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "page/page_protocol.h"
#include "recorder/test/recording_fixture.h"
#include "studio/library_requests.h"

namespace smile::studio {

/// A library's requests, as a page sends them.
class LibraryRequestsFixture : public recorder::RecordingFixture {
 protected:
  LibraryRequestsFixture() { AddLibraryRequests(&library_, &jobs_, &table_); }

  /// Returns the reply, also a deferred one.
  Json Ask(const char* what, Json fields, bool is_controller = true) {
    const page::Request request{
        .client = 3, .seq = ++seq_, .what = what, .fields = std::move(fields)};
    const Json now = Answer(table_, request, is_controller);
    Json answer = page::IsLater(now) ? AnswerTo(seq_) : now;
    ExpectFitsProtocol(answer, what);
    return answer;
  }
  /// Expects that a message fits the tables of the protocol.
  static void ExpectFitsProtocol(const Json& message, const char* request = "") {
    EXPECT_EQ(page::MisfitOf(message, request), "") << ToText(message);
  }

  /// Waits for a reply; keeps all other messages.
  Json AnswerTo(std::uint32_t seq) {
    while (true) {
      for (page::DeferredMessage& deferred : TakeDeferred(table_)) {
        if (deferred.message["t"] != "reply") ExpectFitsProtocol(deferred.message);
        deferred_.push_back(std::move(deferred));
      }
      for (const page::DeferredMessage& deferred : deferred_) {
        if (deferred.client == 3 && deferred.message["seq"] == seq) return deferred.message;
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }

  /// Names of files that two recordings do not both have, or not the same.
  std::vector<std::string> FilesThatDiffer(const char* one, const char* other) const {
    const auto first = FilesIn(root_ / one), second = FilesIn(root_ / other);
    std::vector<std::pair<std::string, std::string>> different;
    std::ranges::set_symmetric_difference(first, second, std::back_inserter(different));
    std::vector<std::string> names;
    for (const auto& [name, bytes] : different) names.push_back(name);
    return names;
  }

  static std::map<std::string, std::string> FilesIn(const std::filesystem::path& directory) {
    std::map<std::string, std::string> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(directory)) {
      files[entry.path().lexically_relative(directory)] =
          entry.is_directory() ? "" : ReadFile(entry.path(), 1 << 24);
    }
    return files;
  }

  library::Library library_{root_};
  BackgroundJobs jobs_;
  page::RequestTable table_;
  std::uint32_t seq_ = 0;
  std::vector<page::DeferredMessage> deferred_;
};

}  // namespace smile::studio
