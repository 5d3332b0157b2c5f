// SPDX-License-Identifier: Apache-2.0
// Options of attributes by their names in Python.
#pragma once
#include <pybind11/pybind11.h>

#include <rakelight/geometry/attributes.h>

namespace rakelight::python {

namespace py = pybind11;

/// {"scope": "model", "weight": "angle", "crease_angle_rad": 1.05, ...}: a key for each field that is not as by default.
/// @throws Error usage: a word that means nothing, with those that do; a number out of range
AttributeOptions attribute_options(const py::dict& options);

}  // namespace rakelight::python
