#include "base/wording.h"
#include "interchange/internal_usd_writer.h"

namespace smile::interchange {
namespace {

/// Returns numbers in parentheses.
std::string TupleOf(std::initializer_list<double> numbers) {
  std::string text;
  // Adding 0 makes -0 a plain 0.
  for (const double number : numbers) text += (text.empty() ? "" : ", ") + NumberText(number + 0.0);
  return "(" + text + ")";
}

bool IsLetter(char letter) {
  return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') || letter == '_';
}
bool IsDigit(char letter) { return letter >= '0' && letter <= '9'; }

}  // namespace

std::string UsdString(std::string_view text) {
  std::string quoted = "\"";
  for (const char letter : Printable(text)) {
    if (letter == '"' || letter == '\\') quoted += '\\';
    quoted += letter;
  }
  return quoted + "\"";
}

std::string UsdName(std::string_view name) {
  std::string allowed;
  for (const char letter : name) allowed += IsLetter(letter) || IsDigit(letter) ? letter : '_';
  if (allowed.empty() || IsDigit(allowed.front())) allowed = "_" + allowed;
  return allowed;
}

std::string UsdTuple(const Vector3& v) { return TupleOf({v.x(), v.y(), v.z()}); }
std::string UsdTuple(const Quaternion& q) { return TupleOf({q.w(), q.x(), q.y(), q.z()}); }

UsdWriter::UsdWriter(const std::vector<std::string>& metadata) {
  text_ = "#usda 1.0\n(\n";
  for (const std::string& line : metadata) text_ += "    " + line + "\n";
  text_ += ")\n";
}

void UsdWriter::Line(std::string_view text) {
  text_.append(4 * depth_, ' ');
  text_ += text;
  text_ += '\n';
}

void UsdWriter::Open(std::string_view type, std::string_view name,
                     const std::vector<std::string_view>& schemas) {
  const std::string head = "def " + std::string(type) + " " + UsdString(name);
  if (schemas.empty()) {
    Line(head);
  } else {
    std::string list;
    for (const std::string_view schema : schemas) {
      list += (list.empty() ? "" : ", ") + UsdString(schema);
    }
    // In three lines, as OpenUSD writes them: the reader of three.js 0.187 skips prims with one.
    Line(head + " (");
    Line("    prepend apiSchemas = [" + list + "]");
    Line(")");
  }
  Line("{");
  ++depth_;
}

void UsdWriter::Close() {
  --depth_;
  Line("}");
}

void UsdWriter::Set(std::string_view property, std::string_view value) {
  Line(std::string(property) + " = " + std::string(value));
}

void UsdWriter::Set(std::string_view property, double value) { Set(property, NumberText(value)); }

void UsdWriter::SetPose(const RigidTransform& X, const Vector3& scale) {
  Set("double3 xformOp:translate", UsdTuple(X.translation()));
  Set("quatd xformOp:orient", UsdTuple(X.quaternion()));
  if (scale == Vector3::Ones()) {
    Set("uniform token[] xformOpOrder", R"(["xformOp:translate", "xformOp:orient"])");
  } else {
    Set("double3 xformOp:scale", UsdTuple(scale));
    Set("uniform token[] xformOpOrder",
        R"(["xformOp:translate", "xformOp:orient", "xformOp:scale"])");
  }
}

void UsdWriter::SetPoses(const MovingFrame& frame, const std::vector<double>& codes) {
  if (frame.moments.size() == 1) {
    SetPose(frame.X_WF.front());
    return;
  }
  const std::vector<Quaternion> rotations = frame.Rotations();
  std::string places = "{", turns = "{";
  for (std::size_t i = 0; i < frame.moments.size(); ++i) {
    const std::string code = " " + NumberText(codes[frame.moments[i]]) + ": ";
    places += code + UsdTuple(frame.X_WF[i].translation()) + ",";
    turns += code + UsdTuple(rotations[i]) + ",";
  }
  Set("double3 xformOp:translate.timeSamples", places + " }");
  Set("quatd xformOp:orient.timeSamples", turns + " }");
  Set("uniform token[] xformOpOrder", R"(["xformOp:translate", "xformOp:orient"])");
}

void UsdWriter::SetVisibility(const MovingVisuals& visuals, const std::vector<double>& codes) {
  std::string samples = "{";
  for (const auto& [moment, is_shown] : visuals.shown) {
    samples +=
        " " + NumberText(codes[moment]) + ": " + (is_shown ? "\"inherited\"," : "\"invisible\",");
  }
  Set("token visibility.timeSamples", samples + " }");
}

}  // namespace smile::interchange
