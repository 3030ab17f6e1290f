// Life of a brain's process: start, connection, hello, init, steps, end. Impl talks to the program
// through a MessageChannel; the process itself, its output and the place where both meet are
// objects of their own. Each wait has a limit, so that no misbehavior blocks the simulation, and
// every path to an error ends in EndWith(), after which nothing of the program is left.

#include "brain/brain_process.h"

#include <signal.h>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "brain/brain_messages.h"
#include "brain/internal_brain_program.h"
#include "brain/internal_message_channel.h"
#include "brain/internal_output_drain.h"
#include "brain/internal_rendezvous.h"
#include "brain/internal_robot_files.h"
#include "process/child_process.h"

namespace smile::brain {
namespace {

// A connection ends a slice early; its length is how late a cancellation may be noticed.
constexpr int kMeetSliceMs = 20;
constexpr double kForeverSeconds = 1e6;    ///< the longest value of process::WaitLimit
constexpr double kGoodbyeSeconds = 1.0;    ///< from BYE to SIGKILL
constexpr double kGuardSeconds = 0.5;      ///< from SIGUSR2 to SIGINT
constexpr double kInterruptSeconds = 0.3;  ///< from SIGINT to SIGKILL
constexpr double kSilenceSeconds = 2.0;    ///< before a hello, while another connection waits

using Phase = BrainError::Phase;

std::string Name(Phase phase) {
  switch (phase) {
    case Phase::kStart:
      return "the start";
    case Phase::kInit:
      return "init";
    case Phase::kCallback:
      return "the callback";
  }
  return {};
}

std::string SecondsText(double seconds) {
  std::ostringstream text;
  text << seconds << " s";
  return text.str();
}

/// Returns the reason for the author of the program.
std::string WhyNotRun(const process::CannotRun& refusal) {
  const std::string found = "the brain cannot be run: ";
  // The two errors that authors of scripts meet: a `#!` line that names a missing interpreter, and
  // a file that is executable but in no known format.
  switch (refusal.error_number()) {
    case ENOENT:
      return found +
             "its interpreter does not exist, expected one in the first line of the script, like "
             "#!/usr/bin/python3";
    case ENOEXEC:
      return found +
             "it is not a program, expected one for this machine, or a script with a first line "
             "like #!/usr/bin/python3";
    default:
      return found + std::strerror(refusal.error_number());
  }
}

/// True if a field exists and is a nonzero logical or number.
bool IsTrue(const Message& message, std::string_view name) {
  const NamedArray* array = message.Find(name);
  const auto numbers = array ? array->Numbers() : std::nullopt;
  return numbers && numbers->size() == 1 && numbers->front() != 0;
}

}  // namespace

/// Run of one brain. Members are destroyed in reverse order: channel, output, child, folder.
class BrainProcess::Impl {
 public:
  Impl(const std::filesystem::path& brain, BrainOptions options)
      : options_(std::move(options)), program_(FindBrainProgram(brain, options_.transport)) {}
  ~Impl() { Stop(); }

  OrError<InitReply> Init(const Aux& aux);
  OrError<StepReply> Step(const Sensor& sensor);
  void Stop();
  bool is_running() const { return state_ == State::kRunning; }

 private:
  enum class State { kNew, kStarting, kRunning, kEnded };

  std::optional<BrainError> Start();
  process::ChildCommand CommandWithAddress() const;
  bool HasChildEnded() const { return child_ && child_->HasEnded(); }
  std::optional<BrainError> Meet(const process::WaitLimit& limit);
  /// Connects to the program that serves the brain.
  std::optional<BrainError> Connect(const process::WaitLimit& limit);
  /// Waits for a connection that says hello. Under a debugger, all other connections are rejected:
  /// their errors are not the brain's.
  std::optional<BrainError> Greet(const process::WaitLimit& limit);
  /// Returns the limit for the hello: under a debugger, a silent connection must not block the next
  /// one.
  process::WaitLimit LimitOfHello(const process::WaitLimit& limit) const;
  bool TakeHello(const Message& hello);
  /// Sends a question and waits for its answer, which is of type `expected` (or kFinalMotor).
  OrError<Message> Exchange(const std::vector<std::byte>& question, MessageType expected,
                            Phase phase, const process::WaitLimit& limit, double limit_seconds);
  process::WaitLimit LimitOf(double seconds) const;

  BrainError ExplainFault(const ChannelFault& fault, Phase phase, double limit_seconds);
  BrainError ExplainTimeout(Phase phase, double limit_seconds);
  BrainError ExplainReport(const Message& report, Phase phase) const;
  /// Ends the process for this reason, and adds the last output.
  BrainError EndWith(BrainError error);
  void EndProcess();
  /// Returns an error about the script of this phase.
  BrainError ErrorIn(Phase phase, std::string message) const;
  std::string ScriptOf(Phase phase) const;
  std::string Displayed(const std::string& file) const;

  BrainOptions options_;
  BrainProgram program_;
  State state_ = State::kNew;
  std::uint32_t sequence_ = 0;
  bool has_guard_ = false;  ///< SIGUSR2 raises an error within the program
  PixelOrder pixel_order_ = PixelOrder::kColumns;
  std::vector<ArmDescription> arms_;       ///< as sent
  std::vector<std::string> cameras_;       ///< as requested
  std::string init_file_, callback_file_;  ///< as named by the brain; empty if unknown

  std::optional<Rendezvous> rendezvous_;
  std::optional<process::ChildProcess> child_;
  std::optional<OutputDrain> drain_;
  std::optional<MessageChannel> channel_;
};

OrError<InitReply> BrainProcess::Impl::Init(const Aux& aux) {
  if (state_ != State::kNew) throw std::logic_error("BrainProcess::Init: it was already started");
  // One limit covers the whole start, from fork to the end of init: which part of it is slow (the
  // interpreter, imports, the init script) is not known from outside.
  state_ = State::kStarting;
  if (auto error = Start()) return EndWith(std::move(*error));
  const process::WaitLimit limit = LimitOf(options_.start_seconds);
  if (auto error = Greet(limit)) return EndWith(std::move(*error));

  // The rendezvous removes its folder with all contents, so these files need no cleanup of their
  // own.
  const std::string robot = WriteRobotFiles(aux.robot_files, rendezvous_->folder() / "robot");
  auto answer = Exchange(EncodeAux(++sequence_, aux, program_.folder_name, robot),
                         MessageType::kInitDone, Phase::kInit, limit, options_.start_seconds);
  if (auto* error = std::get_if<BrainError>(&answer)) return EndWith(std::move(*error));
  const Message& message = std::get<Message>(answer);
  // Names of the scripts from now on appear in messages about errors that happen within them.
  init_file_ = message.TextOf("initFile");
  callback_file_ = message.TextOf("callbackFile");
  auto reply = DecodeInitReply(message, aux);
  arms_ = aux.arms;
  if (const auto* error = std::get_if<WireError>(&reply)) {
    return EndWith(ErrorIn(Phase::kInit, error->message));
  }
  state_ = State::kRunning;
  cameras_ = std::get<InitReply>(reply).pictures.cameras;
  return std::move(std::get<InitReply>(reply));
}

OrError<StepReply> BrainProcess::Impl::Step(const Sensor& sensor) {
  if (!is_running()) throw std::logic_error("BrainProcess::Step: the brain is not running");
  auto answer =
      Exchange(EncodeSensor(++sequence_, sensor, pixel_order_), MessageType::kMotor,
               Phase::kCallback, LimitOf(options_.callback_seconds), options_.callback_seconds);
  if (auto* error = std::get_if<BrainError>(&answer)) return EndWith(std::move(*error));
  auto reply = DecodeStepReply(std::get<Message>(answer), arms_, cameras_);
  if (const auto* error = std::get_if<WireError>(&reply)) {
    return EndWith(ErrorIn(Phase::kCallback, error->message));
  }
  // A brain that says it is done still gets its second to end by itself, for example to save files.
  if (std::get<StepReply>(reply).exit) Stop();
  return std::get<StepReply>(reply);
}

// A polite end first. It may fail at any point (never started, already dead, blocked): EndProcess()
// then does all that is left to do.
void BrainProcess::Impl::Stop() {
  if (channel_) {
    const process::WaitLimit limit(kGoodbyeSeconds);
    const auto fault =
        channel_->Send(MessageWriter(MessageType::kBye, ++sequence_).Finish(), limit);
    channel_.reset();  // a program that does not know kBye sees the end of file
    if (!fault && child_) child_->WaitForEnd(limit);
  }
  EndProcess();
}

std::optional<BrainError> BrainProcess::Impl::Start() {
  // The meeting place exists before the program starts, so a fast program never misses it.
  rendezvous_.emplace(program_.rendezvous);
  if (program_.server) return std::nullopt;
  if (options_.is_attached) {
    if (options_.on_waiting) options_.on_waiting(HowToAttach(program_, CommandWithAddress()));
    return std::nullopt;
  }
  const process::ChildCommand command = CommandWithAddress();
  try {
    child_.emplace(command);
  } catch (const process::CannotRun& refusal) {
    // A missing interpreter is a fault of the installation; a program that cannot run is a fault of
    // the brain.
    if (command.arguments.front() != program_.main_file) throw;
    return ErrorIn(Phase::kStart, WhyNotRun(refusal));
  }
  // From the first moment: an interpreter that prints more than a pipe holds would block before its
  // hello.
  drain_.emplace(child_->TakeOutput(), options_.on_output);
  return std::nullopt;
}

process::ChildCommand BrainProcess::Impl::CommandWithAddress() const {
  process::ChildCommand command = program_.command;
  const bool is_socket = program_.rendezvous == Rendezvous::Kind::kSocket;
  // Variables instead of arguments: the command line of an interpreter belongs to the brain's
  // author.
  command.environment.insert(command.environment.end(),
                             {{"SMILE_BRAIN_TRANSPORT", is_socket ? "socket" : "pipes"},
                              {"SMILE_BRAIN_ADDRESS", rendezvous_->address()},
                              {"SMILE_BRAIN_SCRATCH", rendezvous_->folder()},
                              {"SMILE_BRAIN_FOLDER", program_.folder}});
  return command;
}

std::optional<BrainError> BrainProcess::Impl::Meet(const process::WaitLimit& limit) {
  // The limit also counts as canceled when the child has ended, so that a program that dies before
  // it connects is reported at once, not after the whole timeout.
  while (!(channel_ = rendezvous_->Meet(kMeetSliceMs))) {
    if (limit.HasPassed()) return ExplainTimeout(Phase::kStart, options_.start_seconds);
    if (limit.IsCancelled()) {
      return ExplainFault({ChannelFault::Kind::kCancelled, {}}, Phase::kStart, 0);
    }
  }
  return std::nullopt;
}

std::optional<BrainError> BrainProcess::Impl::Connect(const process::WaitLimit& limit) {
  auto connected = ConnectTo(*program_.server, limit);
  if (auto* channel = std::get_if<MessageChannel>(&connected)) {
    channel_.emplace(std::move(*channel));
    return std::nullopt;
  }
  const ChannelFault& fault = std::get<ChannelFault>(connected);
  if (fault.kind != ChannelFault::Kind::kClosed) {
    return ExplainFault(fault, Phase::kStart, options_.start_seconds);
  }
  return ErrorIn(Phase::kStart, "cannot connect to the brain: " + fault.message +
                                    ", expected a program that serves one there");
}

std::optional<BrainError> BrainProcess::Impl::Greet(const process::WaitLimit& limit) {
  // More than one round only under a debugger; without one, the first connection decides.
  while (true) {
    if (auto error = program_.server ? Connect(limit) : Meet(limit)) return error;
    auto received = channel_->Receive(LimitOfHello(limit));
    const Message* hello = std::get_if<Message>(&received);
    if (hello && hello->type == MessageType::kError) return ExplainReport(*hello, Phase::kStart);
    if (hello && TakeHello(*hello)) return std::nullopt;

    const auto* fault = std::get_if<ChannelFault>(&received);
    BrainError error = fault ? ExplainFault(*fault, Phase::kStart, options_.start_seconds)
                             : ErrorIn(Phase::kStart, "the brain does not speak version " +
                                                          std::to_string(wire::kProtocolVersion) +
                                                          " of the protocol");
    if (!options_.is_attached || program_.server || limit.IsCancelled()) return error;
    // The only other reason to cancel a hello is LimitOfHello(): a visitor waits behind a silent
    // client.
    if (fault && fault->kind == ChannelFault::Kind::kCancelled) {
      error = ErrorIn(Phase::kStart, "it sent nothing, and another client has connected");
    }
    channel_.reset();
    if (options_.on_waiting) options_.on_waiting("rejected a client: " + error.message);
  }
}

// Under a debugger people take their time, so a hello has no timeout of its own. But the listener
// accepts one client at a time: a stray connection that never speaks must give way to the next.
process::WaitLimit BrainProcess::Impl::LimitOfHello(const process::WaitLimit& limit) const {
  if (!options_.is_attached || program_.server) return limit;
  return process::WaitLimit(
      kForeverSeconds, [this, limit, silence = process::WaitLimit(kSilenceSeconds)] {
        return limit.IsCancelled() || (silence.HasPassed() && rendezvous_->HasVisitor());
      });
}

bool BrainProcess::Impl::TakeHello(const Message& hello) {
  const NamedArray* version = hello.Find("version");
  const auto numbers = version ? version->Numbers() : std::nullopt;
  if (hello.type != MessageType::kHello || !numbers || numbers->size() != 1 ||
      numbers->front() != wire::kProtocolVersion) {
    return false;
  }
  // Capabilities are optional fields, so that the protocol gains features without a new version.
  has_guard_ = IsTrue(hello, "guard");
  if (IsTrue(hello, "rows")) pixel_order_ = PixelOrder::kRows;
  return true;
}

OrError<Message> BrainProcess::Impl::Exchange(const std::vector<std::byte>& question,
                                              MessageType expected, Phase phase,
                                              const process::WaitLimit& limit,
                                              double limit_seconds) {
  // Question and answer share one limit: a brain that does not read is as late as one that
  // computes.
  if (const auto fault = channel_->Send(question, limit)) {
    return ExplainFault(*fault, phase, limit_seconds);
  }
  auto received = channel_->Receive(limit);
  if (const auto* fault = std::get_if<ChannelFault>(&received)) {
    return ExplainFault(*fault, phase, limit_seconds);
  }
  Message& answer = std::get<Message>(received);
  if (answer.type == MessageType::kError) return ExplainReport(answer, phase);
  const bool is_expected = answer.type == expected || (expected == MessageType::kMotor &&
                                                       answer.type == MessageType::kFinalMotor);
  // The sequence number rejects answers to earlier questions.
  if (!is_expected || answer.sequence != sequence_) {
    return ExplainFault({ChannelFault::Kind::kNonsense, "this is not an answer to the request"},
                        phase, limit_seconds);
  }
  return std::move(answer);
}

/// Returns the limit for an answer. Waiting ends when the child has ended; under a debugger there
/// is no timeout.
process::WaitLimit BrainProcess::Impl::LimitOf(double seconds) const {
  return process::WaitLimit(options_.is_attached ? kForeverSeconds : seconds, [this] {
    return HasChildEnded() || (options_.is_cancelled && options_.is_cancelled());
  });
}

BrainError BrainProcess::Impl::ExplainFault(const ChannelFault& fault, Phase phase,
                                            double limit_seconds) {
  if (fault.kind == ChannelFault::Kind::kTimedOut) return ExplainTimeout(phase, limit_seconds);
  const std::string during = " during " + Name(phase);
  if (fault.kind == ChannelFault::Kind::kNonsense) {
    return ErrorIn(phase, "the brain sent an invalid message" + during + ": " + fault.message);
  }
  // A closed connection is usually the end of the process, which follows within moments and
  // explains more.
  const bool is_closed = fault.kind == ChannelFault::Kind::kClosed;
  if (is_closed && program_.server) {
    return ErrorIn(phase, "the connection to the brain was lost" + during + ": " + fault.message);
  }
  if (child_ && child_->WaitForEnd(process::WaitLimit(is_closed ? kGoodbyeSeconds : 0))) {
    return ErrorIn(phase, "the brain ended" + during + ": " + child_->End());
  }
  return ErrorIn(phase, is_closed ? "the brain closed its connection" + during
                                  : "the brain was stopped" + during);
}

/// Stops a program that exceeded its timeout. First raises an error inside it, which knows its
/// line; then interrupts; EndProcess() kills the rest.
BrainError BrainProcess::Impl::ExplainTimeout(Phase phase, double limit_seconds) {
  BrainError error =
      ErrorIn(phase, Name(phase) + " took longer than " + SecondsText(limit_seconds) + " and was " +
                         (program_.server ? "disconnected" : "stopped"));
  if (!child_) return error;
  if (has_guard_ && channel_) {
    child_->SignalGroup(SIGUSR2);  // also ends a child that it waits for
    auto received = channel_->Receive(LimitOf(kGuardSeconds));
    const Message* report = std::get_if<Message>(&received);
    if (report && report->type == MessageType::kError) {
      const BrainError found = ExplainReport(*report, phase);
      error.file = found.file;
      error.line = found.line;
      return error;
    }
  }
  child_->SignalGroup(SIGINT);
  child_->WaitForEnd(process::WaitLimit(kInterruptSeconds));
  return error;
}

BrainError BrainProcess::Impl::ExplainReport(const Message& report, Phase phase) const {
  BrainError error = DecodeError(report);
  error.phase = phase;
  error.file = Displayed(error.file.empty() ? ScriptOf(phase) : error.file);
  return error;
}

BrainError BrainProcess::Impl::ErrorIn(Phase phase, std::string message) const {
  return {.phase = phase, .message = std::move(message), .file = Displayed(ScriptOf(phase))};
}

// The output is complete only after the process has ended and the drain has read the rest.
BrainError BrainProcess::Impl::EndWith(BrainError error) {
  EndProcess();
  if (drain_) error.output = drain_->LastLines();
  return error;
}

void BrainProcess::Impl::EndProcess() {
  // The order matters: the output is drained after its last writer has died, and the folder goes
  // last, since the program uses files in it.
  if (state_ != State::kNew) state_ = State::kEnded;
  channel_.reset();
  if (child_) child_->End();
  if (drain_) drain_->Finish();
  rendezvous_.reset();
}

std::string BrainProcess::Impl::ScriptOf(Phase phase) const {
  if (phase == Phase::kInit && !init_file_.empty()) return init_file_;
  if (phase == Phase::kCallback && !callback_file_.empty()) return callback_file_;
  return program_.main_file;
}

/// Returns a path for people, relative to the working directory if possible: `wave/waveInit.m`.
std::string BrainProcess::Impl::Displayed(const std::string& file) const {
  // The added empty part gives the path a trailing slash, so that `/a/b` is no prefix of `/a/bc`.
  const std::string prefix = (program_.working_directory / "").string();
  return PrintableText(file.starts_with(prefix) ? file.substr(prefix.size()) : file, 1000);
}

BrainProcess::BrainProcess(const std::filesystem::path& brain, BrainOptions options)
    : impl_(std::make_unique<Impl>(brain, std::move(options))) {}
BrainProcess::BrainProcess(BrainProcess&&) noexcept = default;
BrainProcess& BrainProcess::operator=(BrainProcess&&) noexcept = default;
BrainProcess::~BrainProcess() = default;

OrError<InitReply> BrainProcess::Init(const Aux& aux) { return impl_->Init(aux); }
OrError<StepReply> BrainProcess::Step(const Sensor& sensor) { return impl_->Step(sensor); }
BrainAnswer BrainProcess::Answer(const BrainQuestion& question) {
  // Both replies are alternatives of the wider BrainAnswer, and so is the error in either.
  const auto widened = [](auto reply) {
    return std::visit([](auto& either) { return BrainAnswer(std::move(either)); }, reply);
  };
  if (const auto* aux = std::get_if<Aux>(&question)) return widened(Init(*aux));
  return widened(Step(std::get<Sensor>(question)));
}
void BrainProcess::Stop() { impl_->Stop(); }
bool BrainProcess::is_running() const { return impl_->is_running(); }

}  // namespace smile::brain
