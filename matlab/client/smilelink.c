/* SMILELINK  Carries messages between the SMILE simulator and a robot program in Octave or Matlab.
 *
 *   smilelink('open', socket_path)
 *   [type, sequence, values, is_other] = smilelink('receive')   type 0: nothing came for 100 ms
 *   smilelink('send', type, sequence, values)
 *
 * `values` is a scalar struct of real arrays and text; `is_other` unless all but its numbers is as in the
 * message before: names, shapes, texts. When the simulator has gone, 'receive' gives
 * its goodbye. docs/brain-protocol.md describes the bytes. Uses the documented MEX C API only: build
 * with `mkoctfile --mex smilelink.c` or `mex smilelink.c`.
 */
#include <errno.h>
#include <poll.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include "mex.h"

enum { MAGIC = 0x31424d53, HEADER_BYTES = 16, MAX_BODY_BYTES = 64 << 20, MAX_DIMENSIONS = 8 };
enum { USUAL_BYTES = 64 << 10 }; /* header and body of all but pictures come at once */
enum { MAX_ARRAYS = 64, MAX_NAME_LETTERS = 63, SLICE_MS = 100 };
enum { MESSAGE_NOTHING = 0, MESSAGE_BYE = 8 };
enum { TYPE_DOUBLE = 0, TYPE_BYTE = 1, TYPE_LOGICAL = 2, TYPE_TEXT = 3 };
enum { FLAG_FRACTION = 1 };

static int connection = -1;

/* One buffer serves every message and is kept: an error may leave any function by a jump. */
static uint8_t *buffer;
static size_t buffer_capacity;

static void reserve(size_t size) {
  if (size <= buffer_capacity) return;
  uint8_t *larger = realloc(buffer, size);
  if (!larger) mexErrMsgIdAndTxt("smile:memory", "out of memory");
  buffer = larger;
  buffer_capacity = size;
}

static void close_everything(void) {
  if (connection >= 0) close(connection);
  connection = -1;
  free(buffer);
  buffer = NULL;
  buffer_capacity = 0;
}

static size_t padded(size_t size) { return (size + 7) & ~(size_t)7; }

/* ---- bytes ------------------------------------------------------------------------------------ */

/* Reads into `buffer` until it holds `size` bytes, `filled` so far: at first as many as come at once.
 * False when the simulator has gone. */
static int fill(size_t *filled, size_t size) {
  while (*filled < size) {
    ssize_t count = read(connection, buffer + *filled, buffer_capacity - *filled);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return 0;
    *filled += (size_t)count;
  }
  return 1;
}

static void write_all(const void *bytes, size_t size) {
  const char *next = bytes;
  while (size > 0) {
    ssize_t count = send(connection, next, size, MSG_NOSIGNAL);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) mexErrMsgIdAndTxt("smile:closed", "the simulator has gone");
    next += count;
    size -= (size_t)count;
  }
}

/* ---- from bytes to a struct ------------------------------------------------------------------- */

/* Reads the message in `buffer` from front to back, never past its end. */
struct reader {
  size_t at, end;
};

static const uint8_t *take(struct reader *reader, size_t size) {
  if (size > reader->end - reader->at) {
    mexErrMsgIdAndTxt("smile:protocol", "a message ends too early");
  }
  const uint8_t *bytes = buffer + reader->at;
  reader->at += size;
  return bytes;
}

static uint32_t take_u32(struct reader *reader) {
  uint32_t value;
  memcpy(&value, take(reader, sizeof value), sizeof value);
  return value;
}

static void skip_padding(struct reader *reader) {
  take(reader, padded(reader->at) - reader->at);
}

static mxArray *make_fractions(mwSize dim_count, const mwSize *dims, const uint8_t *data,
                               size_t count) {
  static double fraction[256];
  if (fraction[255] == 0) {
    for (int k = 0; k < 256; ++k) fraction[k] = k / 255.0;
  }
  mxArray *array = mxCreateUninitNumericArray(dim_count, (mwSize *)dims, mxDOUBLE_CLASS, mxREAL);
  double *out = mxGetPr(array);
  for (size_t k = 0; k < count; ++k) out[k] = fraction[data[k]];
  return array;
}

static mxArray *make_logicals(mwSize dim_count, const mwSize *dims, const uint8_t *data,
                              size_t count) {
  mxArray *array = mxCreateLogicalArray(dim_count, dims);
  mxLogical *out = mxGetLogicals(array);
  for (size_t k = 0; k < count; ++k) out[k] = data[k] != 0;
  return array;
}

static mxArray *make_text(const uint8_t *data, size_t count) {
  char *text = mxCalloc(count + 1, 1);
  memcpy(text, data, count);
  mxArray *array = mxCreateString(text);
  mxFree(text);
  return array;
}

static mxArray *make_array(int type, int flags, mwSize dim_count, const mwSize *dims,
                           const uint8_t *data, size_t count) {
  mxArray *array = NULL;
  switch (type) {
    case TYPE_DOUBLE:
      array = mxCreateNumericArray(dim_count, dims, mxDOUBLE_CLASS, mxREAL);
      if (count > 0) memcpy(mxGetPr(array), data, count * sizeof(double));
      return array;
    case TYPE_BYTE:
      if (flags & FLAG_FRACTION) return make_fractions(dim_count, dims, data, count);
      array = mxCreateNumericArray(dim_count, dims, mxUINT8_CLASS, mxREAL);
      if (count > 0) memcpy(mxGetData(array), data, count);
      return array;
    case TYPE_LOGICAL:
      return make_logicals(dim_count, dims, data, count);
    case TYPE_TEXT:
      return make_text(data, count);
  }
  mexErrMsgIdAndTxt("smile:protocol", "an array of unknown type %d", type);
  return NULL;
}

/* All but the numbers of the message read last, and whether it is other than before. */
static uint8_t outline[16 << 10];
static size_t outline_size;
static int is_other;

/* Appends at `at`, as long as there is room: a message with more is always another one. */
static void add_to_outline(size_t *at, const void *bytes, size_t size) {
  if (size > sizeof outline - *at) {
    is_other = 1;
    return;
  }
  if (*at + size > outline_size || memcmp(outline + *at, bytes, size) != 0) is_other = 1;
  memcpy(outline + *at, bytes, size);
  *at += size;
}

static mxArray *read_array(struct reader *reader, char *name, size_t *outline_at) {
  const uint8_t *head = take(reader, 4);
  const size_t letters = head[0], dim_count = head[2];
  const int type = head[1], flags = head[3];
  if (letters == 0 || letters > MAX_NAME_LETTERS || dim_count < 2 || dim_count > MAX_DIMENSIONS) {
    mexErrMsgIdAndTxt("smile:protocol", "a message has an impossible array");
  }
  mwSize dims[MAX_DIMENSIONS];
  size_t count = 1;
  for (size_t k = 0; k < dim_count; ++k) {
    dims[k] = take_u32(reader);
    if (dims[k] > 0 && count > MAX_BODY_BYTES / dims[k]) {
      mexErrMsgIdAndTxt("smile:protocol", "a message has too large an array");
    }
    count *= dims[k];
  }
  memcpy(name, take(reader, letters), letters);
  name[letters] = '\0';
  skip_padding(reader);
  add_to_outline(outline_at, head, (size_t)(buffer + reader->at - head));
  const uint8_t *data = take(reader, type == TYPE_DOUBLE ? count * sizeof(double) : count);
  skip_padding(reader);

  if (type == TYPE_TEXT) add_to_outline(outline_at, data, count);
  return make_array(type, flags, dim_count, dims, data, count);
}

static mxArray *read_body(size_t size) {
  struct reader reader = {HEADER_BYTES, HEADER_BYTES + size};
  const uint32_t count = take_u32(&reader);
  take_u32(&reader);
  if (count > MAX_ARRAYS) mexErrMsgIdAndTxt("smile:protocol", "a message has too many arrays");
  is_other = 0;
  size_t outline_at = 0;
  char names[MAX_ARRAYS][MAX_NAME_LETTERS + 1];
  mxArray *arrays[MAX_ARRAYS];
  const char *fields[MAX_ARRAYS];
  for (uint32_t k = 0; k < count; ++k) {
    arrays[k] = read_array(&reader, names[k], &outline_at);
    fields[k] = names[k];
  }
  if (outline_at != outline_size) is_other = 1;
  outline_size = outline_at;
  mxArray *values = mxCreateStructMatrix(1, 1, (int)count, fields);
  for (uint32_t k = 0; k < count; ++k) mxSetFieldByNumber(values, 0, (int)k, arrays[k]);
  return values;
}

/* ---- from a struct to bytes ------------------------------------------------------------------- */

/* Appends to `buffer`; positions count from the start of the header, which is a multiple of 8. */
static void put(size_t *at, const void *bytes, size_t size) {
  if (size > MAX_BODY_BYTES - *at) mexErrMsgIdAndTxt("smile:value", "too much for one message");
  if (*at + size > buffer_capacity) reserve(2 * (*at + size));
  if (size > 0) memcpy(buffer + *at, bytes, size);
  *at += size;
}

static void put_padding(size_t *at) {
  static const uint8_t zeros[8];
  put(at, zeros, padded(*at) - *at);
}

static void put_head(size_t *at, const char *name, int type, const mxArray *value) {
  const size_t letters = strlen(name);
  const mwSize dim_count = mxGetNumberOfDimensions(value);
  const mwSize *dims = mxGetDimensions(value);
  if (letters > MAX_NAME_LETTERS || dim_count > MAX_DIMENSIONS) {
    mexErrMsgIdAndTxt("smile:value", "%s has too long a name or too many dimensions", name);
  }
  const uint8_t head[4] = {(uint8_t)letters, (uint8_t)type, (uint8_t)dim_count, 0};
  put(at, head, sizeof head);
  for (mwSize k = 0; k < dim_count; ++k) {
    const uint32_t dim = dims[k] > MAX_BODY_BYTES ? MAX_BODY_BYTES : (uint32_t)dims[k];
    put(at, &dim, sizeof dim);
  }
  put(at, name, letters);
  put_padding(at);
}

static void put_text(size_t *at, const char *name, const mxArray *value) {
  put_head(at, name, TYPE_TEXT, value);
  char *text = mxArrayToString(value);
  put(at, text, text ? mxGetNumberOfElements(value) : 0);
  if (text) mxFree(text);
  put_padding(at);
}

static void put_logicals(size_t *at, const char *name, const mxArray *value) {
  put_head(at, name, TYPE_LOGICAL, value);
  const mxLogical *logicals = mxGetLogicals(value);
  const size_t count = mxGetNumberOfElements(value);
  for (size_t k = 0; k < count; ++k) {
    const uint8_t byte = logicals[k] != 0;
    put(at, &byte, 1);
  }
  put_padding(at);
}

/* Sparse, single and integer arrays become full doubles on the way. */
static void put_numbers(size_t *at, const char *name, mxArray *value) {
  mxArray *full = NULL, *doubles = NULL;
  if (mxIsSparse(value)) {
    mexCallMATLAB(1, &full, 1, &value, "full");
    value = full;
  }
  if (!mxIsDouble(value)) {
    mexCallMATLAB(1, &doubles, 1, &value, "double");
    value = doubles;
  }
  put_head(at, name, TYPE_DOUBLE, value);
  put(at, mxGetPr(value), mxGetNumberOfElements(value) * sizeof(double));
  if (doubles) mxDestroyArray(doubles);
  if (full) mxDestroyArray(full);
}

static void put_field(size_t *at, const mxArray *values, int field) {
  const char *name = mxGetFieldNameByNumber(values, field);
  mxArray *value = mxGetFieldByNumber(values, 0, field);
  if (!value) mexErrMsgIdAndTxt("smile:value", "%s is empty", name);
  if (mxIsChar(value)) {
    put_text(at, name, value);
  } else if (mxIsLogical(value) && !mxIsSparse(value)) {
    put_logicals(at, name, value);
  } else if ((mxIsNumeric(value) || mxIsLogical(value)) && !mxIsComplex(value)) {
    put_numbers(at, name, value);
  } else {
    mexErrMsgIdAndTxt("smile:value", "%s is a %s%s, expected real numbers", name,
                      mxIsNumeric(value) ? "complex " : "", mxGetClassName(value));
  }
}

/* ---- commands --------------------------------------------------------------------------------- */

static void open_connection(const mxArray *path) {
  struct sockaddr_un address;
  memset(&address, 0, sizeof address);
  address.sun_family = AF_UNIX;
  if (mxGetString(path, address.sun_path, sizeof address.sun_path) != 0) {
    mexErrMsgIdAndTxt("smile:usage", "the path of the socket is too long");
  }
  if (connection < 0) {
    mexLock(); /* "clear all" must not cut the connection */
    mexAtExit(close_everything);
  } else {
    close(connection);
  }
  connection = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (connection < 0 || connect(connection, (struct sockaddr *)&address, sizeof address) != 0) {
    mexErrMsgIdAndTxt("smile:closed", "cannot connect to %s: %s", address.sun_path,
                      strerror(errno));
  }
}

static void receive(int nlhs, mxArray *plhs[]) {
  uint32_t header[4] = {MAGIC, MESSAGE_NOTHING, 0, 0};
  mxArray *values = NULL;
  struct pollfd watched = {connection, POLLIN, 0};
  if (poll(&watched, 1, SLICE_MS) > 0) {
    size_t filled = 0;
    reserve(USUAL_BYTES);
    header[1] = MESSAGE_BYE;
    if (fill(&filled, HEADER_BYTES)) {
      memcpy(header, buffer, sizeof header);
      if (header[0] != MAGIC || header[3] > MAX_BODY_BYTES || filled > HEADER_BYTES + header[3]) {
        mexErrMsgIdAndTxt("smile:protocol", "what arrived is not a message");
      }
      reserve(HEADER_BYTES + header[3]);
      if (fill(&filled, HEADER_BYTES + header[3])) {
        values = read_body(header[3]);
      } else {
        header[1] = MESSAGE_BYE;
      }
    }
  }
  plhs[0] = mxCreateDoubleScalar(header[1]);
  if (nlhs > 1) plhs[1] = mxCreateDoubleScalar(header[2]);
  if (nlhs > 2) plhs[2] = values ? values : mxCreateStructMatrix(1, 1, 0, NULL);
  if (nlhs > 3) plhs[3] = mxCreateLogicalScalar(is_other);
}

static void send_message(double type, double sequence, const mxArray *values) {
  if (!mxIsStruct(values) || mxGetNumberOfElements(values) != 1) {
    mexErrMsgIdAndTxt("smile:usage", "expected a scalar struct");
  }
  const int field_count = mxGetNumberOfFields(values);
  uint32_t header[6] = {MAGIC, (uint32_t)type, (uint32_t)sequence, 0, (uint32_t)field_count, 0};
  size_t size = 0;
  put(&size, header, sizeof header);
  for (int field = 0; field < field_count; ++field) put_field(&size, values, field);
  header[3] = (uint32_t)(size - HEADER_BYTES);
  memcpy(buffer, header, sizeof header);
  write_all(buffer, size);
}

void mexFunction(int nlhs, mxArray *plhs[], int nrhs, const mxArray *prhs[]) {
  char command[16] = "";
  if (nrhs > 0) mxGetString(prhs[0], command, sizeof command);
  if (nrhs == 2 && strcmp(command, "open") == 0) {
    open_connection(prhs[1]);
  } else if (nrhs == 1 && strcmp(command, "receive") == 0) {
    receive(nlhs, plhs);
  } else if (nrhs == 4 && strcmp(command, "send") == 0) {
    send_message(mxGetScalar(prhs[1]), mxGetScalar(prhs[2]), prhs[3]);
  } else {
    mexErrMsgIdAndTxt("smile:usage", "expected 'open', 'receive' or 'send' and its arguments");
  }
}
