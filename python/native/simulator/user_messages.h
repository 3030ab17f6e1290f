#pragma once

#include <pybind11/pybind11.h>

#include <string>

#include "texts/user_message.h"

namespace pybind11::detail {

/// In Python, a message of the program is a `str`: its English text.
template <>
struct type_caster<smile::texts::UserMessage> {
  PYBIND11_TYPE_CASTER(smile::texts::UserMessage, const_name("str"));

  bool load(handle source, bool converts) {
    make_caster<std::string> text;
    if (!text.load(source, converts)) return false;
    value = cast_op<std::string>(std::move(text));
    return true;
  }
  static handle cast(const std::string& message, return_value_policy policy, handle parent) {
    return make_caster<std::string>::cast(message, policy, parent);
  }
};

}  // namespace pybind11::detail
