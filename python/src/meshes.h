// SPDX-License-Identifier: Apache-2.0
// Meshes as dictionaries of arrays: {"vertices", "faces", "normals", "tangents", "uv", "colors", "origin", "to_world", ...}.
#pragma once
#include <pybind11/pybind11.h>

#include <optional>
#include <string>
#include <vector>

#include "arrays.h"

namespace rakelight::python {

namespace py = pybind11;

/// The arrays of one mesh of the caller's: their memory where it fits, else copies. They keep it alive.
struct MeshArrays {
    std::string name{};
    py::array_t<float> vertices{};                                            ///< [V, 3]
    py::array_t<std::uint32_t> triangles{};                                   ///< [3T] each < V
    std::optional<py::array_t<float>> normals{}, tangents{}, uv{}, colors{};  ///< [V, 3], [V, 4], [V, 2], [V, 4]
    dvec3 origin{};                                                           ///< [m] vertices count from here
    std::optional<dmat4> to_world{};
};

/// @param place  of the mesh, for messages: "mesh 3"
/// @throws Error usage: shapes, types or counts that do not fit, an index that no vertex has
MeshArrays mesh_arrays(const py::dict& mesh, const std::string& place);

/// A matrix that places: finite, and its last row 0 0 0 1. @throws Error usage
dmat4 placement(py::handle from, const std::string& name);

}  // namespace rakelight::python
