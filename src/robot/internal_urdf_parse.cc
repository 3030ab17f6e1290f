#include "robot/internal_urdf_parse.h"

#include <console_bridge/console.h>
#include <urdf_parser/urdf_parser.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <mutex>

#include "base/wording.h"

namespace smile::robot::internal {
namespace {

constexpr std::ptrdiff_t kMaxLinks = 256;  // and as many joints
constexpr std::size_t kMaxLogBytes = 500;

/// Keeps what the parser would print.
class LogCollector : public console_bridge::OutputHandler {
 public:
  LogCollector() { console_bridge::useOutputHandler(this); }
  ~LogCollector() override { console_bridge::restorePreviousOutputHandler(); }
  void log(const std::string& text, console_bridge::LogLevel level, const char*, int) override {
    if (level < console_bridge::CONSOLE_BRIDGE_LOG_ERROR || text_.size() > kMaxLogBytes) return;
    if (!text_.empty()) text_ += "; ";
    // It quotes the file, which may hold anything.
    for (char letter : text.substr(0, kMaxLogBytes)) {
      text_ += static_cast<unsigned char>(letter) < 0x20 ? ' ' : letter;
    }
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

/// The link that `<parent>` or `<child>` names inside the joint at `tags[joint]`.
std::string LinkNamedBy(const std::vector<XmlTag>& tags, std::size_t joint,
                        std::string_view element) {
  for (std::size_t i = joint + 1; i < tags.size() && tags[i].depth > tags[joint].depth; ++i) {
    if (tags[i].element == element && tags[i].depth == tags[joint].depth + 1) {
      return std::string(tags[i].Attribute("link"));
    }
  }
  return {};
}

}  // namespace

UrdfDocument::UrdfDocument(const std::string& text, std::string file)
    : file_(std::move(file)), tags_(ScanTags(text, file_)) {
  CheckTree();
  // The parser's log is one for the whole process, so one call at a time.
  static std::mutex mutex;
  const std::lock_guard lock(mutex);
  LogCollector log;
  model_ = urdf::parseURDF(text);
  // It may complain about a piece, leave it out and go on; we do not.
  if (!model_ || !log.text().empty()) FailLikeParser(log.text());
}

void UrdfDocument::Fail(std::string_view element, std::string_view name,
                        const std::string& message) const {
  throw InputError(Diagnostic{.file = file_,
                              .line = LineOf(element, name),
                              .element = std::string(element) + " name=" + Quoted(name),
                              .message = message});
}

/// Sees to it before parsing: the parser neither notices a loop nor frees one.
void UrdfDocument::CheckTree() const {
  CheckCount("link");
  CheckCount("joint");
  std::map<std::string, std::string> parents;
  for (std::size_t i = 0; i < tags_.size(); ++i) {
    if (tags_[i].depth != 1 || tags_[i].element != "joint") continue;
    const std::string child = LinkNamedBy(tags_, i, "child");
    if (!parents.emplace(child, LinkNamedBy(tags_, i, "parent")).second) {
      Fail("link", child, "is the child of two joints, expected one at most");
    }
  }
  for (const auto& [child, parent] : parents) {
    std::size_t steps = 0;
    for (auto joint = parents.find(child); joint != parents.end();
         joint = parents.find(joint->second)) {
      if (++steps > parents.size()) {
        Fail("link", child, "hangs in a loop of joints, expected a tree");
      }
    }
  }
}

void UrdfDocument::CheckCount(const std::string& element) const {
  const auto count = std::ranges::count_if(
      tags_, [&](const XmlTag& tag) { return tag.depth == 1 && tag.element == element; });
  if (count <= kMaxLinks) return;
  throw InputError(Diagnostic{.file = file_,
                              .message = "found " + std::to_string(count) + " elements <" +
                                         element + ">, expected " + std::to_string(kMaxLinks) +
                                         " at most"});
}

int UrdfDocument::LineOf(std::string_view element, std::string_view name) const {
  const auto found = std::ranges::find_if(tags_, [&](const XmlTag& tag) {
    return tag.element == element && tag.Attribute("name") == name;
  });
  return found == tags_.end() ? 0 : found->line;
}

/// The parser puts the names of links and joints in brackets; the first known one gives the line.
void UrdfDocument::FailLikeParser(const std::string& log) const {
  Diagnostic diagnostic{.file = file_, .message = log.empty() ? "not a URDF" : log};
  for (auto open = log.find('['); open != std::string::npos && diagnostic.line == 0;
       open = log.find('[', open + 1)) {
    const std::string name = log.substr(open + 1, log.find(']', open) - open - 1);
    for (const char* element : {"link", "joint"}) {
      if (diagnostic.line == 0) diagnostic.line = LineOf(element, name);
    }
  }
  throw InputError(std::move(diagnostic));
}

}  // namespace smile::robot::internal
