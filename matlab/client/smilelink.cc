// SMILELINK  Carries messages between the SMILE simulator and a brain in Octave or Matlab.
//
//   smilelink('open', socket_path)
//   [type, sequence, values, is_other] = smilelink('receive')   type 0: no message for 100 ms
//   smilelink('send', type, sequence, values)
//
// `values` is a scalar struct of real arrays and text; `is_other` is false if names,
// shapes and texts equal those of the previous message. After the simulator has closed the
// connection, 'receive' returns its goodbye.
//
// A thin wrapper of brain_client::SimulatorConnection. Uses the documented MEX C API only; in
// Matlab:
//   mex -Isrc matlab/client/smilelink.cc -Lbuild/release/src -lsmile_brain_protocol

#include "mex.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <system_error>
#include <type_traits>
#include <vector>

#include "brain_client/message_outline.h"
#include "brain_client/simulator_connection.h"
#include "wire/wire.h"

namespace smile::brain_client {
namespace {

using wire::ArrayView;
using wire::ElementType;

constexpr int kNothing = 0;    ///< the type of no message
constexpr int kSliceMs = 100;  ///< of waiting; between them Ctrl-C is looked for

std::unique_ptr<SimulatorConnection> connection;
MessageOutline outline;

/// What an error of Octave or Matlab carries.
struct MexError : std::runtime_error {
  MexError(const char* error_id, const std::string& message)
      : std::runtime_error(message), id(error_id) {}
  const char* id;
};

// ---- from a message to a struct -----------------------------------------------------------------

mxArray* NumbersOf(const ArrayView& array, mwSize dim_count, mwSize* dims) {
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(array.data.data());
  const std::size_t size = array.data.size();
  mxArray* value = nullptr;
  if (array.type == ElementType::kLogical) {
    value = mxCreateLogicalArray(dim_count, dims);
    std::transform(bytes, bytes + size, mxGetLogicals(value), [](auto byte) { return byte != 0; });
  } else if (array.is_fraction) {
    static const auto fractions = [] {
      std::array<double, 256> all;
      for (int k = 0; k < 256; ++k) all[k] = k / 255.0;
      return all;
    }();
    value = mxCreateUninitNumericArray(dim_count, dims, mxDOUBLE_CLASS, mxREAL);
    std::transform(bytes, bytes + size, mxGetPr(value), [](auto byte) { return fractions[byte]; });
  } else {
    const bool is_double = array.type == ElementType::kDouble;
    value =
        mxCreateNumericArray(dim_count, dims, is_double ? mxDOUBLE_CLASS : mxUINT8_CLASS, mxREAL);
    if (size > 0) std::memcpy(mxGetData(value), bytes, size);
  }
  return value;
}

mxArray* ValueOf(const ArrayView& array) {
  if (array.type == ElementType::kText) {
    return mxCreateString(
        std::string(reinterpret_cast<const char*>(array.data.data()), array.data.size()).c_str());
  }
  if (array.is_row_major) throw ProtocolError("row-major pixels, which were not requested");
  std::array<mwSize, wire::kMaxDimensions> dims = {};
  std::copy(array.dims().begin(), array.dims().end(), dims.begin());
  return NumbersOf(array, static_cast<mwSize>(array.dim_count), dims.data());
}

mxArray* StructOf(const wire::MessageView& message) {
  std::vector<std::string> names;
  std::vector<const char*> fields;
  for (const ArrayView& array : message.arrays) names.emplace_back(array.name);
  for (const std::string& name : names) fields.push_back(name.c_str());
  mxArray* values = mxCreateStructMatrix(1, 1, static_cast<int>(fields.size()), fields.data());
  for (std::size_t k = 0; k < fields.size(); ++k) {
    mxSetFieldByNumber(values, 0, static_cast<int>(k), ValueOf(message.arrays[k]));
  }
  return values;
}

// ---- from a struct to a message -----------------------------------------------------------------

std::vector<std::uint32_t> DimsOf(const mxArray* value) {
  std::vector<std::uint32_t> dims;
  for (mwSize k = 0; k < mxGetNumberOfDimensions(value); ++k) {
    constexpr std::size_t kMost = std::numeric_limits<std::uint32_t>::max();
    dims.push_back(
        static_cast<std::uint32_t>(std::min<std::size_t>(mxGetDimensions(value)[k], kMost)));
  }
  return dims;
}

std::span<std::byte> AddSpace(wire::MessageWriter& writer, const char* name, ElementType type,
                              const mxArray* value) {
  const std::vector<std::uint32_t> dims = DimsOf(value);
  try {
    return writer.AddSpace(name, type, false, dims);
  } catch (const std::invalid_argument&) {
    throw MexError("smile:value", std::string(name) + " is " + wire::ShapeText(dims) +
                                      ", which messages cannot contain");
  }
}

void AddText(wire::MessageWriter& writer, const char* name, const mxArray* value) {
  const auto space = AddSpace(writer, name, ElementType::kText, value);
  const mxChar* letters = mxGetChars(value);
  std::transform(letters, letters + space.size(), space.begin(), [](mxChar letter) {
    const unsigned code = static_cast<std::make_unsigned_t<mxChar>>(letter);
    return std::byte(std::min(code, 255u));
  });
}

void AddLogicals(wire::MessageWriter& writer, const char* name, const mxArray* value) {
  const auto space = AddSpace(writer, name, ElementType::kLogical, value);
  const mxLogical* logicals = mxGetLogicals(value);
  std::transform(logicals, logicals + space.size(), space.begin(),
                 [](mxLogical logical) { return std::byte{logical != 0}; });
}

/// Sparse, single and integer arrays become full doubles on the way.
void AddNumbers(wire::MessageWriter& writer, const char* name, mxArray* value) {
  // Before anything is made of it: it may be sparse and immense.
  const auto space = AddSpace(writer, name, ElementType::kDouble, value);
  mxArray *full = nullptr, *doubles = nullptr;
  if (mxIsSparse(value)) {
    mexCallMATLAB(1, &full, 1, &value, "full");
    value = full;
  }
  if (!mxIsDouble(value)) {
    mexCallMATLAB(1, &doubles, 1, &value, "double");
    value = doubles;
  }
  if (!space.empty()) std::memcpy(space.data(), mxGetPr(value), space.size());
  if (doubles) mxDestroyArray(doubles);
  if (full) mxDestroyArray(full);
}

void AddField(wire::MessageWriter& writer, const mxArray* values, int field) {
  const char* name = mxGetFieldNameByNumber(values, field);
  mxArray* value = mxGetFieldByNumber(values, 0, field);
  if (!value) throw MexError("smile:value", std::string(name) + " is empty");
  if (mxIsChar(value)) {
    AddText(writer, name, value);
  } else if (mxIsLogical(value) && !mxIsSparse(value)) {
    AddLogicals(writer, name, value);
  } else if ((mxIsNumeric(value) || mxIsLogical(value)) && !mxIsComplex(value)) {
    AddNumbers(writer, name, value);
  } else {
    throw MexError("smile:value", std::string(name) + " is a " +
                                      (mxIsNumeric(value) ? "complex " : "") +
                                      mxGetClassName(value) + ", expected real numbers");
  }
}

// ---- commands -----------------------------------------------------------------------------------

void Close() { connection.reset(); }

void Open(const mxArray* path) {
  char* address = mxArrayToString(path);
  if (!address) throw MexError("smile:usage", "expected the path of a socket");
  if (!connection) {
    mexLock();  // "clear all" must not cut the connection
    mexAtExit(&Close);
  }
  try {
    connection = std::make_unique<SimulatorConnection>(address);
  } catch (const std::system_error& error) {
    throw MexError("smile:closed", std::string("cannot connect to ") + error.what());
  }
  mxFree(address);
}

void Receive(int nlhs, mxArray* plhs[]) {
  double type = kNothing, sequence = 0;
  bool is_other = true;
  mxArray* values = nullptr;
  if (connection->HasArrivals(kSliceMs)) {
    type = static_cast<double>(wire::MessageType::kBye);
    if (const auto message = connection->Receive()) {
      type = static_cast<double>(message->type);
      sequence = message->sequence;
      is_other = outline.Changes(*message);
      values = StructOf(*message);
    }
  }
  plhs[0] = mxCreateDoubleScalar(type);
  if (nlhs > 1) plhs[1] = mxCreateDoubleScalar(sequence);
  if (nlhs > 2) plhs[2] = values ? values : mxCreateStructMatrix(1, 1, 0, nullptr);
  if (nlhs > 3) plhs[3] = mxCreateLogicalScalar(is_other);
}

void Send(double type, double sequence, const mxArray* values) {
  if (!mxIsStruct(values) || mxGetNumberOfElements(values) != 1) {
    throw MexError("smile:usage", "expected a scalar struct");
  }
  wire::MessageWriter writer(static_cast<wire::MessageType>(type),
                             static_cast<std::uint32_t>(sequence));
  const int field_count = mxGetNumberOfFields(values);
  for (int field = 0; field < field_count; ++field) AddField(writer, values, field);
  connection->Send(writer.Finish());
}

void Carry(int nlhs, mxArray* plhs[], int nrhs, const mxArray* prhs[]) {
  char command[16] = "";
  if (nrhs > 0) mxGetString(prhs[0], command, sizeof command);
  const std::string_view word = command;
  if (nrhs == 2 && word == "open") return Open(prhs[1]);
  if ((word == "receive" || word == "send") && !connection) {
    throw MexError("smile:usage", "not connected; call 'open' first");
  }
  if (nrhs == 1 && word == "receive") return Receive(nlhs, plhs);
  if (nrhs == 4 && word == "send") {
    return Send(mxGetScalar(prhs[1]), mxGetScalar(prhs[2]), prhs[3]);
  }
  throw MexError("smile:usage", "expected 'open', 'receive' or 'send' and its arguments");
}

/// The identifier of an error, with its words in `message`; null when all is well. An error of
/// Octave leaves by a jump, which must not pass over anything that has a destructor.
const char* Try(int nlhs, mxArray* plhs[], int nrhs, const mxArray* prhs[], char* message,
                std::size_t size) {
  const auto failed = [&](const char* id, const char* words) {
    std::snprintf(message, size, "%s", words);
    return id;
  };
  try {
    Carry(nlhs, plhs, nrhs, prhs);
    return nullptr;
  } catch (const MexError& error) {
    return failed(error.id, error.what());
  } catch (const ProtocolError& error) {
    return failed("smile:protocol", error.what());
  } catch (const SimulatorGone& error) {
    return failed("smile:closed", error.what());
  } catch (const std::bad_alloc&) {
    return failed("smile:memory", "out of memory");
  } catch (const std::exception& error) {
    return failed("smile:value", error.what());
  }
}

}  // namespace
}  // namespace smile::brain_client

extern "C" void mexFunction(int nlhs, mxArray* plhs[], int nrhs, const mxArray* prhs[]) {
  static char message[1024];
  const char* id = smile::brain_client::Try(nlhs, plhs, nrhs, prhs, message, sizeof message);
  if (id) mexErrMsgIdAndTxt(id, "%s", message);
}
