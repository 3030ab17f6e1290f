#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "base/json.h"
#include "page/requests.h"
#include "sharing/share_links.h"
#include "sharing/shared_recordings.h"
#include "web_server/http.h"

namespace smile::sharing {

/// Prefix of all paths of this room.
inline constexpr const char* kPublicPrefix = "/shared/";

struct SharingOptions {
  std::filesystem::path page;  ///< `index.html` for people who have a link
  /// Returns the pictures of recordings, at `/recordings/ID/…`; may be empty.
  web_server::HttpHandler content;
};

/// Place at which the links work.
struct PublicPlace {
  std::string origin;     ///< `http://127.0.0.1:8470`
  bool is_local = false;  ///< only for programs of this machine
};

/// Sharing: makes links to single recordings, as pages request it, and serves them to anyone who
/// has a link. What is served cannot be changed through it, and contains nothing of other
/// recordings.
class Sharing {
 public:
  /// @param library  must outlive this.
  Sharing(SharingOptions options, const library::Library* library);

  /// Adds the requests about links; a recording that moves to the bin loses its links. `bin` must
  /// be in the table already. This must outlive the table.
  void AddTo(page::RequestTable* table, const PublicPlace& place,
             const page::InBackground& in_background);

  /// Returns what is served at a path; nullopt if there is nothing, and for all paths without a
  /// valid secret. From any thread.
  /// @throws std::runtime_error without details, which are not for strangers.
  std::optional<web_server::HttpResponse> Get(const std::string& path);

 private:
  std::optional<web_server::HttpResponse> GetPage() const;
  /// @param rest  of the path after the secret.
  std::optional<web_server::HttpResponse> GetPart(const ShareLink& link, const std::string& rest);
  std::optional<web_server::HttpResponse> GetMesh(const SharedRecording& shared,
                                                  const std::string& path) const;
  std::optional<web_server::HttpResponse> GetEyePicture(const std::filesystem::path& directory,
                                                        const SharedRecording& shared,
                                                        std::size_t number) const;
  void AddLinkRequests(page::RequestTable* table, const PublicPlace& place,
                       const page::InBackground& in_background);

  SharingOptions options_;
  const library::Library* library_;
  ShareLinks links_;
  SharedRecordings recordings_;
};

}  // namespace smile::sharing
