// The file is the truth, as several studios may share a library: it is read again whenever it has
// changed, and before each change.

#include "sharing/share_links.h"

#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <stdexcept>
#include <utility>

#include "base/diagnostic.h"
#include "base/file_state.h"
#include "base/files.h"
#include "base/json.h"
#include "base/json_node.h"
#include "base/wording.h"
#include "library/utc_text.h"
#include "web_server/secret.h"

namespace smile::sharing {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxFileBytes = 1 << 20, kMaxTextBytes = 600;
constexpr std::uint64_t kFormat = 1;

/// Returns a text that no other directory of this machine has, not even a later one of the same
/// name; it survives renaming. Empty if there is no such directory.
std::string IdentityOf(const fs::path& directory) {
  struct statx found {};
  const unsigned wanted = STATX_TYPE | STATX_INO | STATX_BTIME;
  if (statx(AT_FDCWD, directory.c_str(), AT_SYMLINK_NOFOLLOW, wanted, &found) != 0) return "";
  if (!S_ISDIR(found.stx_mode)) return "";
  // The number of a removed directory may be used again; file systems without a time of birth
  // report 0.
  return std::to_string(found.stx_ino) + "," + std::to_string(found.stx_btime.tv_sec) + "," +
         std::to_string(found.stx_btime.tv_nsec);
}

std::string TimeNow() {
  using std::chrono::nanoseconds;
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return library::UtcText(std::chrono::duration_cast<nanoseconds>(now).count());
}

ShareLink ParseLink(const JsonNode& node) {
  node.ExpectMembers(std::array<std::string_view, 4>{"secret", "recording", "directory", "made"});
  ShareLink link{.secret = node.Member("secret").ShortString(kMaxTextBytes),
                 .recording = node.Member("recording").ShortString(kMaxTextBytes),
                 .directory = node.Member("directory").ShortString(kMaxTextBytes),
                 .made = node.Member("made").ShortString(kMaxTextBytes)};
  // A short or empty secret would be no secret.
  if (link.secret.size() != web_server::kSecretDigits) {
    node.Member("secret").Fail("has " + std::to_string(link.secret.size()) + " letters, expected " +
                               std::to_string(web_server::kSecretDigits));
  }
  return link;
}

std::vector<ShareLink> ParseLinks(const std::string& text, const std::string& file) {
  Json json;
  try {
    json = ParseJson(text);
  } catch (const std::invalid_argument& error) {
    throw InputError(Diagnostic{.file = file, .message = error.what()});
  }
  const JsonNode root(json, file, "");
  root.ExpectMembers(std::array<std::string_view, 2>{"format", "links"});
  (void)root.Member("format").Whole(kFormat, kFormat);
  std::vector<ShareLink> links;
  for (const JsonNode& node : root.Member("links").ItemsUpTo(ShareLinks::kMaxLinks)) {
    links.push_back(ParseLink(node));
  }
  return links;
}

}  // namespace

const std::vector<ShareLink>& ShareLinks::Read() const {
  const fs::path path = file();
  std::string stamp = StampOf(path);
  if (stamp == stamp_) return links_;
  stamp_.clear();  // so that a damaged file is reported each time
  links_ = StateOf(path).is_file ? ParseLinks(ReadFile(path, kMaxFileBytes), path.string())
                                 : std::vector<ShareLink>();
  stamp_ = std::move(stamp);
  return links_;
}

void ShareLinks::Write(const std::vector<ShareLink>& links) {
  Json json{{"format", kFormat}, {"links", Json::array()}};
  for (const ShareLink& link : links) {
    json["links"].push_back({{"secret", link.secret},
                             {"recording", link.recording},
                             {"directory", link.directory},
                             {"made", link.made}});
  }
  const fs::path folder = file().parent_path();
  // Made for its owner alone before anything is in it; a folder that exists is not opened to others
  // either.
  constexpr mode_t kOwnerOnly = 0700;
  if (mkdir(folder.c_str(), kOwnerOnly) != 0) {
    std::error_code error;
    fs::permissions(folder, fs::perms::owner_all, error);
    if (error) throw std::runtime_error(folder.string() + ": " + error.message());
  }
  WriteFile(file(), ToText(json, 1) + "\n");
}

bool ShareLinks::IsThere(const ShareLink& link) const {
  try {
    return IdentityOf(library_->DirectoryOf(link.recording)) == link.directory;
  } catch (const library::LibraryError&) {
    return false;
  }
}

ShareLink ShareLinks::Make(const std::string& recording) {
  const fs::path directory = library_->DirectoryOf(recording);
  if (directory.parent_path().filename() == ".bin") {
    throw library::LibraryError(Quoted(recording) + " is in the bin; restore it first");
  }
  ShareLink link{.secret = web_server::RandomSecret(),
                 .recording = recording,
                 .directory = IdentityOf(directory),
                 .made = TimeNow()};
  const std::lock_guard lock(mutex_);
  std::vector<ShareLink> links = Read();
  // Links of recordings that were removed by other means leave with the next change.
  std::erase_if(links, [this](const ShareLink& one) { return !IsThere(one); });
  if (links.size() >= kMaxLinks) {
    throw library::LibraryError(std::to_string(kMaxLinks) +
                                " links exist already, as many as there may be; stop some first");
  }
  links.push_back(link);
  Write(links);
  return link;
}

std::vector<ShareLink> ShareLinks::Of(const std::string& recording) const {
  const std::lock_guard lock(mutex_);
  std::vector<ShareLink> found;
  for (const ShareLink& link : Read()) {
    if (link.recording == recording && IsThere(link)) found.push_back(link);
  }
  return found;
}

void ShareLinks::Stop(const std::string& recording, const std::string& secret) {
  const std::lock_guard lock(mutex_);
  std::vector<ShareLink> links = Read();
  const auto is_meant = [&](const ShareLink& link) {
    return link.recording == recording && web_server::IsSecret(secret, link.secret);
  };
  if (std::erase_if(links, is_meant) == 0) {
    throw library::LibraryError(Quoted(recording) + " has no such link");
  }
  Write(links);
}

void ShareLinks::StopAll(const std::string& recording) {
  const std::lock_guard lock(mutex_);
  std::vector<ShareLink> links = Read();
  if (std::erase_if(links, [&](const auto& link) { return link.recording == recording; }) > 0) {
    Write(links);
  }
}

std::optional<ShareLink> ShareLinks::Find(std::string_view secret) const {
  const std::lock_guard lock(mutex_);
  const ShareLink* found = nullptr;
  for (const ShareLink& link : Read()) {
    if (web_server::IsSecret(secret, link.secret)) found = &link;
  }
  if (found == nullptr || !IsThere(*found)) return std::nullopt;
  return *found;
}

}  // namespace smile::sharing
