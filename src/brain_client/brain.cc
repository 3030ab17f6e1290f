// Loop of a brain in C++: reads a message, calls the brain, sends the answer. Everything about
// bytes and sockets is in SimulatorConnection, which the clients for Python and Octave share.

#include "brain_client/brain.h"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "brain_client/simulator_connection.h"

namespace smile::brain_client {
namespace {

using wire::MessageType;
using wire::MessageWriter;

void AddMatrix(MessageWriter& writer, std::string_view name, const Eigen::MatrixXd& matrix) {
  const std::array dims{static_cast<std::uint32_t>(matrix.rows()),
                        static_cast<std::uint32_t>(matrix.cols())};
  writer.AddDoubles(name, dims, {matrix.data(), static_cast<std::size_t>(matrix.size())});
}

// The protocol accepts commas between names.
std::string InOneLine(const std::vector<std::string>& names) {
  std::string line;
  for (const std::string& name : names) line += (line.empty() ? "" : ",") + name;
  return line;
}

std::vector<std::byte> ErrorFrame(std::uint32_t sequence, std::string_view message) {
  MessageWriter writer(MessageType::kError, sequence);
  writer.AddText("message", message);
  return writer.Finish();
}

/// Answers the messages of one simulator for one brain.
class ProtocolSession {
 public:
  ProtocolSession(Brain* brain, SimulatorConnection* connection)
      : brain_(brain), connection_(connection) {}

  void Run() {
    connection_->Greet({.client = "c++", .language = {}, .takes_rows = true});
    while (const auto message = connection_->Receive()) {
      if (message->type == MessageType::kBye) return;
      connection_->Send(AnswerTo(Copied(*message)));
    }
  }

 private:
  std::vector<std::byte> AnswerTo(wire::Message message) {
    const std::uint32_t sequence = message.sequence;
    try {
      // The simulator sends only INIT and STEP here; BYE ended the loop before.
      return message.type == MessageType::kInit ? Init(std::move(message))
                                                : Step(std::move(message));
    } catch (const std::exception& error) {
      // The brain's exceptions travel to the simulator, which shows them and ends this process.
      return ErrorFrame(sequence, error.what());
    } catch (...) {
      return ErrorFrame(sequence, "unknown exception, not a std::exception");
    }
  }

  std::vector<std::byte> Init(wire::Message message) {
    MessageWriter writer(MessageType::kInitDone, message.sequence);
    aux_ = Aux(std::move(message));
    // Outputs have their full size and are zero from the start, so that a brain may set single
    // elements.
    const auto limbs = static_cast<Eigen::Index>(aux_.Number("numLimbs"));
    const auto joints = static_cast<Eigen::Index>(aux_.Number("numJoints"));
    motor_.joint_velocities.setZero(limbs, joints);
    // The same object for all steps: values stay until the brain changes them.
    motor_.gripper_velocities.setZero(limbs);
    brain_->Init(aux_);
    if (aux_.init_joint_angles) AddMatrix(writer, "initJointAngles", *aux_.init_joint_angles);
    if (!aux_.channels.empty()) writer.AddText("channels", InOneLine(aux_.channels));
    if (!aux_.cameras.empty()) writer.AddText("cameras", InOneLine(aux_.cameras));
    if (aux_.image_seconds) writer.AddScalar("imageSeconds", *aux_.image_seconds);
    if (aux_.watch) writer.AddLogical("watch", true);
    AddNewMarkers(&writer);
    return writer.Finish();
  }

  std::vector<std::byte> Step(wire::Message message) {
    const std::uint32_t sequence = message.sequence;
    brain_->Step(Sensor(std::move(message)), motor_, aux_);
    // After the step, since it is the step that sets `exit`.
    MessageWriter writer(aux_.exit ? MessageType::kFinalMotor : MessageType::kMotor, sequence);
    AddMatrix(writer, "jointVelocities", motor_.joint_velocities);
    AddMatrix(writer, "gripperVelocities", motor_.gripper_velocities);
    if (motor_.joint_angles) AddMatrix(writer, "jointAngles", *motor_.joint_angles);
    if (motor_.head_velocity) writer.AddScalar("headVelocity", *motor_.head_velocity);
    AddNewMarkers(&writer);
    return writer.Finish();
  }

  // Markers stay until the brain sends others, so only changes are sent; an empty matrix removes
  // them.
  void AddNewMarkers(MessageWriter* writer) {
    const Eigen::MatrixX3d markers = aux_.draw_markers.value_or(Eigen::MatrixX3d(0, 3));
    if (markers.rows() == sent_markers_.rows() && markers == sent_markers_) return;
    AddMatrix(*writer, "drawMarkers", markers);
    sent_markers_ = markers;
  }

  Brain* brain_;
  SimulatorConnection* connection_;
  Aux aux_;
  Motor motor_;
  Eigen::MatrixX3d sent_markers_ = Eigen::MatrixX3d(0, 3);
};

}  // namespace

int Run(Brain& brain) {
  // A pipe would be fully buffered: lines appear when they are printed.
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  try {
    // Executables get a socket by default; this client has no pipes.
    const char* address = std::getenv("SMILE_BRAIN_ADDRESS");
    if (address == nullptr) {
      throw std::runtime_error(
          "a brain is started by the simulator: smile run SCENE --brain PROGRAM");
    }
    SimulatorConnection connection(address);
    ProtocolSession(&brain, &connection).Run();
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}

}  // namespace smile::brain_client
