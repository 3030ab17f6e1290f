// An outline is a string of all that decides the structure of a message: two are equal exactly if
// the clients may keep their arrays and only overwrite numbers. Strings compare fast and reuse
// memory.

#include "brain_client/message_outline.h"

namespace smile::brain_client {
namespace {

template <class Value>
void Append(std::string* bytes, const Value& value) {
  bytes->append(reinterpret_cast<const char*>(&value), sizeof value);
}

}  // namespace

bool MessageOutline::Changes(const wire::MessageView& message) {
  outline_.clear();
  Append(&outline_, message.type);
  for (const wire::ArrayView& array : message.arrays) {
    // Lengths precede what varies, so that no two different messages have equal outlines.
    Append(&outline_, array.name.size());
    outline_ += array.name;
    Append(&outline_, array.type);
    Append(&outline_, array.is_fraction);
    Append(&outline_, array.is_row_major);
    Append(&outline_, array.dim_count);
    for (const std::uint32_t dim : array.dims()) Append(&outline_, dim);
    if (array.type == wire::ElementType::kText) {
      outline_.append(reinterpret_cast<const char*>(array.data.data()), array.data.size());
    }
  }
  // After the swap `outline_` holds the former outline, and its memory serves the next call.
  outline_.swap(last_);
  return outline_ != last_;
}

}  // namespace smile::brain_client
