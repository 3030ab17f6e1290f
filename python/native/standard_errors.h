#pragma once

#include <pybind11/pybind11.h>

#include <exception>
#include <new>
#include <stdexcept>
#include <string_view>

// Exceptions of C++ in Python. Paths and names in their messages may be of any bytes, which
// pybind11 by itself turns into an exception without a message.

namespace smile::python {

/// Returns a message as a text; bytes that are no UTF-8 are escaped.
inline pybind11::str MessageText(std::string_view message) {
  PyObject* text = PyUnicode_DecodeUTF8(
      message.data(), static_cast<pybind11::ssize_t>(message.size()), "backslashreplace");
  if (text == nullptr) throw pybind11::error_already_set();
  return pybind11::reinterpret_steal<pybind11::str>(text);
}

/// Raises what pybind11 raises for an exception, with its message.
inline void RaiseStandardError(const std::exception& error) {
  PyObject* type = PyExc_RuntimeError;
  if (dynamic_cast<const std::invalid_argument*>(&error) != nullptr ||
      dynamic_cast<const std::domain_error*>(&error) != nullptr ||
      dynamic_cast<const std::length_error*>(&error) != nullptr ||
      dynamic_cast<const std::range_error*>(&error) != nullptr) {
    type = PyExc_ValueError;
  } else if (dynamic_cast<const std::out_of_range*>(&error) != nullptr) {
    type = PyExc_IndexError;
  } else if (dynamic_cast<const std::overflow_error*>(&error) != nullptr) {
    type = PyExc_OverflowError;
  } else if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) {
    type = PyExc_MemoryError;
  }
  PyErr_SetObject(type, MessageText(error.what()).ptr());
}

/// Lets this module raise its exceptions so. Translators that are registered later come first.
inline void RegisterStandardErrors() {
  pybind11::register_local_exception_translator([](std::exception_ptr pointer) {
    try {
      if (pointer) std::rethrow_exception(pointer);
    } catch (const pybind11::error_already_set&) {
      throw;
    } catch (const pybind11::key_error& error) {
      PyErr_SetObject(PyExc_KeyError, MessageText(error.what()).ptr());
    } catch (const pybind11::builtin_exception&) {
      throw;
    } catch (const std::exception& error) {
      RaiseStandardError(error);
    }
  });
}

}  // namespace smile::python
