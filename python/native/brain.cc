// smile.messages, the compiled half: a thin door to brain_client::SimulatorConnection.
//
// Arrays cross it as plain memory, and numpy itself makes arrays of it: so it serves every version
// of numpy, those that this pybind11 does not know, too.

#include <pybind11/pybind11.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <system_error>
#include <vector>

#include "brain_client/simulator_connection.h"
#include "wire/wire.h"

namespace py = pybind11;

namespace smile::brain_client {
namespace {

using wire::ArrayView;
using wire::ElementType;

constexpr std::size_t kLargeBytes =
    8000;  ///< from here on an array is not kept together with others

py::object Owned(PyObject* made) {
  if (made == nullptr) throw py::error_already_set();
  return py::reinterpret_steal<py::object>(made);
}

/// What we need of numpy; found once, and there until Python ends.
struct Numpy {
  py::module_ module = py::module_::import("numpy");
  py::object array_type = module.attr("ndarray");
  py::object column_major = module.attr("asfortranarray");
  py::object dtype = module.attr("dtype");
  py::object doubles = dtype("<f8"), bytes = dtype("u1"), logicals = dtype("?");
};

const Numpy& TheNumpy() {
  static const Numpy& numpy = *new Numpy;
  return numpy;
}

// ---- from a message to values -------------------------------------------------------------------

py::object NewMemory(std::size_t size) {
  return Owned(PyByteArray_FromStringAndSize(nullptr, static_cast<Py_ssize_t>(size)));
}

std::span<std::byte> BytesOf(const py::object& memory) {
  return {reinterpret_cast<std::byte*>(PyByteArray_AS_STRING(memory.ptr())),
          static_cast<std::size_t>(PyByteArray_GET_SIZE(memory.ptr()))};
}

std::size_t Padded(std::size_t size) { return (size + 7) / 8 * 8; }

bool IsSingle(const ArrayView& array) {
  return array.dim_count == 2 && array.data.size() == wire::ElementBytes(array.type);
}

/// The values of one message, made by and by.
class ValueReader {
 public:
  /// @param body  memory in which a large message may lie, or null.
  ValueReader(const wire::MessageView& message, py::object body) : body_(std::move(body)) {
    std::size_t size = 0;
    for (const ArrayView& array : message.arrays) {
      if (array.data.size() < kLargeBytes) size += Padded(array.data.size());
    }
    small_ = NewMemory(size);
  }

  py::object ValueOf(const ArrayView& array) {
    if (array.type == ElementType::kText) {
      return Owned(PyUnicode_DecodeUTF8(reinterpret_cast<const char*>(array.data.data()),
                                        static_cast<Py_ssize_t>(array.data.size()), "replace"));
    }
    return IsSingle(array) ? NumberOf(array) : ArrayOf(array);
  }

 private:
  static py::object NumberOf(const ArrayView& array) {
    if (array.type == ElementType::kDouble) {
      double number = 0;
      std::memcpy(&number, array.data.data(), sizeof number);
      return py::float_(number);
    }
    const int number = std::to_integer<int>(array.data[0]);
    return array.type == ElementType::kLogical ? py::object(py::bool_(number != 0))
                                               : py::object(py::int_(number));
  }

  py::object ArrayOf(const ArrayView& array) {
    const std::size_t size = array.data.size();
    if (size < kLargeBytes) {
      // Small arrays share one block of memory. Pictures have their own, so that a reference to a
      // small array does not keep a picture alive.
      const std::size_t offset = small_used_;
      small_used_ += Padded(size);
      CopyElements(array, BytesOf(small_).subspan(offset, size));
      return NewArray(array, small_, offset);
    }
    if (LiesInBody(array) && array.is_row_major && array.type != ElementType::kLogical) {
      return NewArray(array, body_,
                      static_cast<std::size_t>(array.data.data() - BytesOf(body_).data()));
    }
    const py::object memory = NewMemory(size);
    CopyElements(array, BytesOf(memory));
    return NewArray(array, memory, 0);
  }

  bool LiesInBody(const ArrayView& array) const {
    if (!body_) return false;
    const std::span<std::byte> body = BytesOf(body_);
    return array.data.data() >= body.data() &&
           array.data.data() + array.data.size() <= body.data() + body.size();
  }

  static void CopyElements(const ArrayView& array, std::span<std::byte> to) {
    if (array.is_row_major) {
      std::ranges::copy(array.data, to.begin());
    } else {
      wire::CopyToRowMajor(array.dims(), wire::ElementBytes(array.type), array.data, to);
    }
    if (array.type != ElementType::kLogical) return;
    for (std::byte& logical : to) logical = std::byte{logical != std::byte{0}};
  }

  static py::object NewArray(const ArrayView& array, const py::object& memory, std::size_t offset) {
    const Numpy& numpy = TheNumpy();
    const py::object& type = array.type == ElementType::kDouble ? numpy.doubles
                             : array.type == ElementType::kByte ? numpy.bytes
                                                                : numpy.logicals;
    py::tuple shape(array.dim_count);
    for (std::size_t k = 0; k < array.dim_count; ++k) shape[k] = array.all_dims[k];
    return Owned(PyObject_CallFunctionObjArgs(numpy.array_type.ptr(), shape.ptr(), type.ptr(),
                                              memory.ptr(), py::int_(offset).ptr(), nullptr));
  }

  py::object body_;
  py::object small_;  ///< of all small arrays
  std::size_t small_used_ = 0;
};

py::tuple TypeSequenceAndValues(const wire::MessageView& message, py::object body) {
  ValueReader reader(message, std::move(body));
  py::dict values;
  for (const ArrayView& array : message.arrays) {
    values[py::str(array.name.data(), array.name.size())] = reader.ValueOf(array);
  }
  return py::make_tuple(static_cast<int>(message.type), message.sequence, std::move(values));
}

py::tuple Decode(const py::bytes& frame) {
  const std::string_view text = frame;
  const auto bytes = std::as_bytes(std::span(text));
  if (bytes.size() < wire::kHeaderBytes) throw ProtocolError("the frame ends inside its header");
  const auto header = wire::DecodeHeader(bytes.first<wire::kHeaderBytes>());
  if (const auto* error = std::get_if<wire::WireError>(&header))
    throw ProtocolError(error->message);
  const auto message =
      wire::DecodeBody(std::get<wire::FrameHeader>(header), bytes.subspan(wire::kHeaderBytes));
  if (const auto* error = std::get_if<wire::WireError>(&message)) {
    throw ProtocolError(error->message);
  }
  return TypeSequenceAndValues(std::get<wire::MessageView>(message), {});
}

// ---- from values to a message -------------------------------------------------------------------

std::string_view TextOf(py::handle text) {
  Py_ssize_t size = 0;
  const char* letters = PyUnicode_AsUTF8AndSize(text.ptr(), &size);
  if (letters == nullptr) throw py::error_already_set();
  return {letters, static_cast<std::size_t>(size)};
}

/// Numbers of any kind and shape, as doubles. A row stays a row, one number is 1x1.
void AddNumbers(wire::MessageWriter& writer, std::string_view name, py::handle value) {
  const Numpy& numpy = TheNumpy();
  const py::object array = Owned(PyObject_CallFunctionObjArgs(numpy.column_major.ptr(), value.ptr(),
                                                              numpy.doubles.ptr(), nullptr));
  Py_buffer buffer;
  if (PyObject_GetBuffer(array.ptr(), &buffer, PyBUF_F_CONTIGUOUS) != 0)
    throw py::error_already_set();
  std::vector<std::uint32_t> dims;
  if (buffer.ndim == 1) dims.push_back(1);
  for (int k = 0; k < buffer.ndim; ++k) {
    constexpr Py_ssize_t kMost = std::numeric_limits<std::uint32_t>::max();
    dims.push_back(static_cast<std::uint32_t>(std::min(buffer.shape[k], kMost)));
  }
  try {
    const auto space = writer.AddSpace(name, ElementType::kDouble, false, dims);
    std::memcpy(space.data(), buffer.buf, space.size());
  } catch (...) {
    PyBuffer_Release(&buffer);
    throw;
  }
  PyBuffer_Release(&buffer);
}

std::vector<std::byte> Frame(int type, std::uint32_t sequence, const py::dict& values) {
  wire::MessageWriter writer(static_cast<wire::MessageType>(type), sequence);
  for (const auto& [key, value] : values) {
    const std::string_view name = TextOf(key);
    if (PyUnicode_Check(value.ptr())) {
      writer.AddText(name, TextOf(value));
    } else {
      AddNumbers(writer, name, value);
    }
  }
  return writer.Finish();
}

py::bytes Encode(int type, std::uint32_t sequence, const py::dict& values) {
  const std::vector<std::byte> frame = Frame(type, sequence, values);
  return {reinterpret_cast<const char*>(frame.data()), frame.size()};
}

// ---- the connection -----------------------------------------------------------------------------

/// Connection whose waits release the lock of the interpreter and handle signals.
class Connection {
 public:
  explicit Connection(const std::string& address) : connection_(address, Options()) {}
  explicit Connection(int connected_socket) : connection_(connected_socket, Options()) {}

  void Greet(const std::string& client, const std::string& language, bool has_guard) {
    const py::gil_scoped_release unlocked;
    connection_.Greet(
        {.client = client, .language = language, .has_guard = has_guard, .takes_rows = true});
  }

  void Send(int type, std::uint32_t sequence, const py::dict& values) {
    const std::vector<std::byte> frame = Frame(type, sequence, values);
    const py::gil_scoped_release unlocked;
    connection_.Send(frame);
  }

  py::tuple Receive() {
    std::optional<wire::MessageView> message;
    {
      const py::gil_scoped_release unlocked;
      message = connection_.Receive();
    }
    if (!message) {
      return py::make_tuple(static_cast<int>(wire::MessageType::kBye), 0, py::dict());
    }
    return TypeSequenceAndValues(*message, std::move(body_));
  }

 private:
  SimulatorConnection::Options Options() {
    return {.make_room = [this](std::size_t size) { return MakeRoom(size); },
            .on_signal = &HandleSignals};
  }

  static void HandleSignals() {
    const py::gil_scoped_acquire locked;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  }

  std::span<std::byte> MakeRoom(std::size_t size) {
    const py::gil_scoped_acquire locked;
    body_ = NewMemory(size);
    return BytesOf(body_);
  }

  SimulatorConnection connection_;
  py::object body_;  ///< of a large message; kept while a signal interrupts its arrival
};

std::unique_ptr<Connection> Connected(const std::string& address) {
  try {
    return std::make_unique<Connection>(address);
  } catch (const std::system_error& error) {
    errno = error.code().value();
    PyErr_SetFromErrnoWithFilename(PyExc_OSError, address.c_str());
    throw py::error_already_set();
  }
}

void BindBrain(py::module_& m) {
  m.doc() = "Compiled part of smile.messages.";
  py::register_exception<ProtocolError>(m, "ProtocolError", PyExc_ValueError);
  py::register_exception<SimulatorGone>(m, "SimulatorGone", PyExc_BrokenPipeError);

  using wire::MessageType;
  constexpr std::pair<const char*, MessageType> kTypes[] = {
      {"HELLO", MessageType::kHello},        {"INIT", MessageType::kInit},
      {"INIT_DONE", MessageType::kInitDone}, {"STEP", MessageType::kStep},
      {"MOTOR", MessageType::kMotor},        {"FINAL_MOTOR", MessageType::kFinalMotor},
      {"ERROR", MessageType::kError},        {"BYE", MessageType::kBye}};
  for (const auto& [name, type] : kTypes) m.attr(name) = static_cast<int>(type);

  m.def("encode", &Encode, py::arg("kind"), py::arg("sequence"), py::arg("values"),
        R"(Returns a message as bytes.

values: dict from names to str, numbers or arrays of numbers; numbers are sent as doubles.)");
  m.def("decode", &Decode, py::arg("frame"),
        R"(Returns type, sequence and values of a message given as bytes.

Text becomes str, 1x1 a number, everything else an array in numpy's order.)");
  py::class_<Connection>(m, "Connection", "The socket to the simulator.")
      .def(py::init(&Connected), py::arg("address"))
      .def_static(
          "of_socket", [](int fd) { return std::make_unique<Connection>(fd); }, py::arg("fd"),
          "Takes the descriptor of a connected, blocking socket, and closes it in the end.")
      .def("greet", &Connection::Greet, py::arg("client"), py::arg("language"), py::arg("guard"),
           "Sends HELLO. guard: SIGUSR2 interrupts a brain that takes too long.")
      .def("send", &Connection::Send, py::arg("kind"), py::arg("sequence"), py::arg("values"),
           "Sends a message; values as for encode().")
      .def("receive", &Connection::Receive,
           "Returns type, sequence and values of the next message; BYE when the simulator has "
           "closed the connection.");
}

}  // namespace
}  // namespace smile::brain_client

PYBIND11_MODULE(smile_brain_native, m) { smile::brain_client::BindBrain(m); }
