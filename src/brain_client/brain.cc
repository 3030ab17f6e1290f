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

#include "brain_client/internal_arms.h"
#include "brain_client/internal_plan.h"
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

/// Adds the values of successive ticks, each of shape `dims`, with time as the last dimension. What
/// is no multiple of that shape is sent as it is: the simulator refuses it by name.
void AddTicks(MessageWriter& writer, std::string_view name, const Eigen::MatrixXd& values,
              std::vector<std::uint32_t> dims) {
  Eigen::Index size = 1;
  for (const std::uint32_t dim : dims) size *= dim;
  if (size == 0 || values.rows() % dims.front() != 0 || values.size() % size != 0) {
    return AddMatrix(writer, name, values);
  }
  const auto ticks = static_cast<std::uint32_t>(values.size() / size);
  if (dims.size() == 1 || ticks != 1) dims.push_back(ticks);
  writer.AddDoubles(name, dims, {values.data(), static_cast<std::size_t>(values.size())});
}

// The protocol accepts commas between names.
std::string InOneLine(const std::vector<std::string>& names) {
  std::string line;
  for (const std::string& name : names) line += (line.empty() ? "" : ",") + name;
  return line;
}

std::string InLines(const std::vector<std::string>& texts) {
  std::string lines;
  for (const std::string& text : texts) lines += text + "\n";
  return lines;
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
    // The same object for all steps: values stay until the brain changes them.
    if (aux_.Has("numLimbs")) {
      limbs_ = static_cast<std::uint32_t>(aux_.Number("numLimbs"));
      joints_ = static_cast<std::uint32_t>(aux_.Number("numJoints"));
      motor_.joint_velocities.setZero(limbs_, joints_);
      motor_.gripper_velocities.setZero(limbs_);
    }
    aux_.arms = ArmsOf(aux_);
    aux_.plan = PlanOf(aux_);
    arms_ = aux_.arms;
    motor_.arms = StillArms(arms_);
    brain_->Init(aux_);
    if (aux_.init_joint_angles) AddMatrix(writer, "initJointAngles", *aux_.init_joint_angles);
    AddInitJoints(writer, arms_, aux_);
    if (!aux_.channels.empty()) writer.AddText("channels", InOneLine(aux_.channels));
    if (!aux_.cameras.empty()) writer.AddText("cameras", InOneLine(aux_.cameras));
    sent_cameras_ = aux_.cameras;
    AddNewImageSeconds(&writer);
    if (aux_.watch) writer.AddLogical("watch", true);
    AddNewMarkers(&writer);
    AddNotes(&writer);
    return writer.Finish();
  }

  std::vector<std::byte> Step(wire::Message message) {
    const std::uint32_t sequence = message.sequence;
    Sensor sensor(std::move(message));
    sensor.arms = SensedArms(sensor, arms_);
    brain_->Step(sensor, motor_, aux_);
    // After the step, since it is the step that sets `exit`.
    MessageWriter writer(aux_.exit ? MessageType::kFinalMotor : MessageType::kMotor, sequence);
    const bool sets_arms = limbs_ == 0 || AreSet(motor_.arms);
    if (sets_arms) AddArms(writer, arms_, motor_.arms);
    // Beside arms that are set, only what the simulator must refuse.
    if (!sets_arms || !motor_.joint_velocities.isZero(0) || motor_.joint_angles) {
      AddTicks(writer, "jointVelocities", motor_.joint_velocities, {limbs_, joints_});
      if (motor_.joint_angles) AddMatrix(writer, "jointAngles", *motor_.joint_angles);
    }
    if (!sets_arms || !motor_.gripper_velocities.isZero(0)) {
      AddTicks(writer, "gripperVelocities", motor_.gripper_velocities, {limbs_});
    }
    if (motor_.head_velocity) writer.AddScalar("headVelocity", *motor_.head_velocity);
    if (motor_.ticks) writer.AddScalar("ticks", *motor_.ticks);
    if (aux_.exit && aux_.claim) writer.AddText("claim", *aux_.claim);
    AddNewImageSeconds(&writer);
    if (aux_.cameras != sent_cameras_) writer.AddText("cameras", InOneLine(aux_.cameras));
    sent_cameras_ = aux_.cameras;
    AddNewMarkers(&writer);
    AddNotes(&writer);
    return writer.Finish();
  }

  void AddNewImageSeconds(MessageWriter* writer) {
    if (aux_.image_seconds && aux_.image_seconds != sent_image_seconds_) {
      writer->AddScalar("imageSeconds", *aux_.image_seconds);
    }
    sent_image_seconds_ = aux_.image_seconds;
  }

  // Markers stay until the brain sends others, so only changes are sent; an empty matrix removes
  // them.
  void AddNewMarkers(MessageWriter* writer) {
    const Eigen::MatrixX3d markers = aux_.draw_markers.value_or(Eigen::MatrixX3d(0, 3));
    if (markers.rows() == sent_markers_.rows() && markers == sent_markers_) return;
    AddMatrix(*writer, "drawMarkers", markers);
    sent_markers_ = markers;
  }

  void AddNotes(MessageWriter* writer) {
    if (aux_.notes.empty()) return;
    writer->AddText("notes", InLines(aux_.notes));
    if (aux_.note_tops.rows() > 0) AddMatrix(*writer, "noteTops", aux_.note_tops);
    if (!aux_.note_cameras.empty()) writer->AddText("noteCameras", InLines(aux_.note_cameras));
    aux_.notes.clear();
    aux_.note_tops.resize(0, 9);
    aux_.note_cameras.clear();
  }

  Brain* brain_;
  SimulatorConnection* connection_;
  Aux aux_;
  Motor motor_;
  std::vector<Arm> arms_;                 ///< as received: `aux_` belongs to the brain
  std::uint32_t limbs_ = 0, joints_ = 0;  ///< of the classic variables; 0: there are none
  std::optional<double> sent_image_seconds_;
  std::vector<std::string> sent_cameras_;
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
