#include "brain_input.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <span>

#include "brain/brain_messages.h"

namespace smile::fuzz {
namespace {

std::variant<wire::Message, wire::WireError> Decode(std::string_view bytes) {
  return wire::DecodeFrame(std::as_bytes(std::span(bytes)));
}

std::vector<std::byte> Encode(const wire::Message& message) {
  wire::MessageWriter writer(message.type, message.sequence);
  for (const wire::NamedArray& array : message.arrays) writer.AddArray(array);
  return writer.Finish();
}

bool IsPrintable(const std::string& text) {
  return text.find_first_of(std::string("\0\a\b\n\r\x1b\x7f", 7)) == std::string::npos;
}

bool IsFinite(const std::vector<double>& numbers) {
  return std::ranges::all_of(numbers, [](double number) { return std::isfinite(number); });
}

bool IsFinite(const brain::Motor& motor) {
  return std::ranges::all_of(motor.arms,
                             [](const brain::ArmMotor& arm) {
                               return IsFinite(arm.velocities) &&
                                      std::isfinite(arm.gripper_velocity) &&
                                      (!arm.joints || IsFinite(*arm.joints));
                             }) &&
         (!motor.head_velocity || std::isfinite(*motor.head_velocity));
}

/// Returns arms of `joints` joints each, the last one without a gripper.
std::vector<brain::ArmDescription> Arms(std::initializer_list<std::size_t> joints) {
  std::vector<brain::ArmDescription> arms;
  for (const std::size_t count : joints) {
    arms.push_back({.name = "arm",
                    .joint_names = std::vector<std::string>(count, "joint"),
                    .gripper = Eigen::Vector2d(0, 1)});
  }
  if (arms.size() != brain::kLimbCount) arms.back().gripper.reset();
  return arms;
}

/// Whatever kind of answer it says it is: a program lies.
std::string FaultWithAnswer(const wire::Message& message,
                            const std::vector<brain::ArmDescription>& arms) {
  const auto init =
      brain::DecodeInitReply(message, {.arms = arms, .camera_names = {"eye", "overhead"}});
  if (const auto* error = std::get_if<wire::WireError>(&init)) {
    if (error->message.empty()) return "an init is refused without a reason";
  } else {
    const auto& reply = std::get<brain::InitReply>(init);
    for (const auto& joints : reply.init_joints) {
      if (joints && !IsFinite(*joints)) return "angles: no number";
    }
    if (!reply.draw_markers.allFinite()) return "a marker is no number";
  }
  const auto step = brain::DecodeStepReply(message, arms);
  if (const auto* error = std::get_if<wire::WireError>(&step)) {
    if (error->message.empty()) return "a motor is refused without a reason";
  } else {
    const auto& reply = std::get<brain::StepReply>(step);
    if (reply.ticks < 1 || reply.ticks > brain::kMaxChunkTicks || reply.motors.empty() ||
        reply.motors.size() > static_cast<std::size_t>(reply.ticks)) {
      return "a chunk is too short or too long";
    }
    for (const brain::Motor& motor : reply.motors) {
      if (motor.arms.size() != arms.size()) return "a motor command has too few arms";
      if (!IsFinite(motor)) return "a motor command contains a number that is not finite";
    }
  }
  const brain::BrainError error = brain::DecodeError(message);
  if (error.message.empty()) return "an error has no words";
  if (!IsPrintable(error.message + error.file)) return "an error would move the cursor";
  return error.line < 0 ? "an error is at a negative line" : "";
}

}  // namespace

std::string ReasonAgainstBrainMessage(std::string_view bytes) {
  const auto decoded = Decode(bytes);
  const auto* error = std::get_if<wire::WireError>(&decoded);
  return error ? error->message : "";
}

std::string FaultWithBrainMessage(std::string_view bytes) {
  const auto decoded = Decode(bytes);
  if (const auto* error = std::get_if<wire::WireError>(&decoded)) {
    return error->message.empty() ? "refused without a reason" : "";
  }
  const auto& message = std::get<wire::Message>(decoded);
  const auto again = wire::DecodeFrame(Encode(message));
  const auto* same = std::get_if<wire::Message>(&again);
  if (same == nullptr || *same != message) return "a message comes back differently";
  const std::string fault = FaultWithAnswer(message, Arms({7, 7}));
  return fault.empty() ? FaultWithAnswer(message, Arms({1, 3, 2})) : fault;
}

}  // namespace smile::fuzz
