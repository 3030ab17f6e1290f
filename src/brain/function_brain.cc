#include "brain/function_brain.h"

#include <utility>

#include "brain/brain_messages.h"
#include "brain/internal_robot_files.h"

namespace smile::brain {
namespace {

using Phase = BrainError::Phase;

BrainError Invalid(Phase phase, const std::string& message) {
  return {.phase = phase, .message = "the brain sent an invalid message: " + message};
}

/// Returns the reply that a decoder reads from a frame, or the error that it is or has.
template <class Decode>
BrainAnswer ReplyFrom(const std::vector<std::byte>& frame, Phase phase, Decode decode) {
  const auto decoded = wire::DecodeFrame(frame);
  if (const auto* error = std::get_if<WireError>(&decoded)) return Invalid(phase, error->message);
  const Message& message = std::get<Message>(decoded);
  if (message.type == MessageType::kError) {
    BrainError error = DecodeError(message);
    error.phase = phase;
    return error;
  }
  const bool is_step = phase == Phase::kCallback;
  const bool is_expected =
      is_step ? message.type == MessageType::kMotor || message.type == MessageType::kFinalMotor
              : message.type == MessageType::kInitDone;
  if (!is_expected) return Invalid(phase, "this is not an answer to the request");
  auto reply = decode(message);
  if (const auto* error = std::get_if<WireError>(&reply)) {
    return BrainError{.phase = phase, .message = error->message};
  }
  return std::move(std::get<0>(reply));
}

}  // namespace

BrainAnswer FunctionBrain::Answer(const BrainQuestion& question) {
  const auto* aux = std::get_if<Aux>(&question);
  return aux != nullptr ? Init(*aux) : Step(std::get<Sensor>(question));
}

BrainAnswer FunctionBrain::Init(const Aux& aux) {
  arms_ = aux.arms;
  const std::string robot = WriteRobotFiles(aux.robot_files, files_.path() / "robot");
  return ReplyFrom(function_(EncodeAux(++sequence_, aux, "./", robot)), Phase::kInit,
                   [&](const Message& message) {
                     auto reply = DecodeInitReply(message, aux);
                     if (const auto* init = std::get_if<InitReply>(&reply))
                       cameras_ = init->pictures.cameras;
                     return reply;
                   });
}

BrainAnswer FunctionBrain::Step(const Sensor& sensor) {
  return ReplyFrom(
      function_(EncodeSensor(++sequence_, sensor, PixelOrder::kRows)), Phase::kCallback,
      [this](const Message& message) { return DecodeStepReply(message, arms_, cameras_); });
}

}  // namespace smile::brain
