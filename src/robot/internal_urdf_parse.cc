#include "robot/internal_urdf_parse.h"

#include <console_bridge/console.h>
#include <urdf_parser/urdf_parser.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <mutex>
#include <utility>

#include "base/wording.h"
#include "xml/parse.h"

// Reads URDF with urdfdom, which trusts its input: it follows loops without end, reports errors
// only to a global log, and continues after them. So the text is first parsed and bounded by our
// own XML reader, the tree of joints is checked, and any report of the parser is an error.

namespace smile::robot::internal {
namespace {

constexpr std::ptrdiff_t kMaxLinks = 256;  // and as many joints
constexpr std::size_t kMaxLogBytes = 500;

/// Captures what the parser would print.
class LogCollector : public console_bridge::OutputHandler {
 public:
  LogCollector() { console_bridge::useOutputHandler(this); }
  ~LogCollector() override { console_bridge::restorePreviousOutputHandler(); }
  void log(const std::string& text, console_bridge::LogLevel level, const char*, int) override {
    // Warnings do not make a model wrong.
    if (level < console_bridge::CONSOLE_BRIDGE_LOG_ERROR || text_.size() > kMaxLogBytes) return;
    if (!text_.empty()) text_ += "; ";
    // The log quotes the file, so control characters are replaced.
    for (char letter : text.substr(0, kMaxLogBytes)) {
      text_ += static_cast<unsigned char>(letter) < 0x20 ? ' ' : letter;
    }
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

/// Parses XML with limits on depth, elements and attributes.
/// @throws InputError with the first findings.
xml::Element ParseTree(const std::string& text, const std::string& file) {
  const xml::ParseOptions options{
      .limits = {.max_depth = 32,
                 .max_elements = 50'000,
                 .max_attributes = 32,
                 .max_namespaces = 32},
      .root = "robot",
      .text = xml::TextPolicy::kSkip,
      .strictness = xml::Strictness::kTolerant,
      .key_of = [](std::string_view) { return std::string_view("name"); }};
  xml::Parsed parsed = xml::Parse(text, file, options);
  if (!parsed.root) throw InputError(std::move(parsed.diagnostics));
  return *std::move(parsed.root);
}

/// Returns the link that `<parent>` or `<child>` names inside a joint; empty if it names none.
std::string LinkNamedBy(const xml::Element& joint, std::string_view element) {
  const xml::Element* named = joint.FindChild(element);
  const std::string* link = named ? named->FindAttribute("link") : nullptr;
  return link ? *link : "";
}

}  // namespace

UrdfDocument::UrdfDocument(const std::string& text, std::string file)
    : file_(std::move(file)), root_(ParseTree(text, file_)) {
  CheckTree();
  // The parser's log is global to the process, so one call at a time.
  static std::mutex mutex;
  const std::lock_guard lock(mutex);
  LogCollector log;
  model_ = urdf::parseURDF(text);
  // The parser may report an error, leave out an element and continue; here any report is an error.
  if (!model_ || !log.text().empty()) FailWithParserLog(log.text());
}

void UrdfDocument::Fail(std::string_view element, std::string_view name,
                        const std::string& message) const {
  throw InputError(Diagnostic{.file = file_,
                              .line = LineOf(element, name),
                              .element = std::string(element) + " name=" + Quoted(name),
                              .message = message});
}

/// Checks before parsing that joints form a tree: the parser neither detects a loop nor frees one.
void UrdfDocument::CheckTree() const {
  CheckCount("link");
  CheckCount("joint");
  std::map<std::string, std::string> parents;
  for (const xml::Element& joint : root_.children) {
    if (joint.name != "joint") continue;
    const std::string child = LinkNamedBy(joint, "child");
    // With one parent per link, the joints form trees and loops only.
    if (!parents.emplace(child, LinkNamedBy(joint, "parent")).second) {
      Fail("link", child, "is the child of two joints, expected one at most");
    }
  }
  for (const auto& [child, parent] : parents) {
    // A walk towards the root that takes more steps than there are joints is in a loop.
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
  const auto count = std::ranges::count(root_.children, element, &xml::Element::name);
  if (count <= kMaxLinks) return;
  throw InputError(Diagnostic{.file = file_,
                              .message = "found " + std::to_string(count) + " elements <" +
                                         element + ">, expected " + std::to_string(kMaxLinks) +
                                         " at most"});
}

int UrdfDocument::LineOf(std::string_view element, std::string_view name) const {
  const auto found = std::ranges::find_if(root_.children, [&](const xml::Element& child) {
    const std::string* own_name = child.FindAttribute("name");
    return child.name == element && (own_name ? *own_name : "") == name;
  });
  return found == root_.children.end() ? 0 : found->line;
}

/// Throws the parser's report. Names of links and joints are in brackets in it; the first known one
/// gives the line.
void UrdfDocument::FailWithParserLog(const std::string& log) const {
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
