// SPDX-License-Identifier: Apache-2.0
// rakelight::Error as exceptions of Python, and remarks as tuples.
#pragma once
#include <pybind11/pybind11.h>

#include <string>

#include <rakelight/base/report.h>

namespace rakelight::python {

namespace py = pybind11;

/// Bytes of files as text: what is not UTF-8 is replaced.
py::str text_of(const std::string& bytes);

/// Errors of the library are thrown as classes of rakelight._errors from here on.
void translate_errors();

/// [(kind, file, place, message, count)], those after the first `known` ones.
py::list remarks_of(const Report& report, std::size_t known = 0);

}  // namespace rakelight::python
