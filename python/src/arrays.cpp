// SPDX-License-Identifier: Apache-2.0
#include "arrays.h"

#include <cmath>
#include <limits>

#include <rakelight/base/error.h>

namespace rakelight::python {
namespace {

/// A copy where an element lies across the boundaries of its type (a field of records, a buffer at an odd offset).
constexpr int aligned = py::detail::npy_api::NPY_ARRAY_ALIGNED_;
constexpr int converted = py::array::c_style | py::array::forcecast | aligned;  ///< of another type, too

[[noreturn]] void refuse(const std::string& name, const std::string& reason) {
    throw Error(ErrorCode::usage, name + ": " + reason);
}

std::string shape_of(const py::array& array) {
    std::string text = "(";
    for (py::ssize_t i = 0; i < array.ndim(); ++i) text += (i ? ", " : "") + std::to_string(array.shape(i));
    return text + (array.ndim() == 1 ? ",)" : ")");
}

py::array array_like(py::handle from, const std::string& name) {
    if (from.is_none()) refuse(name, "an array is expected, not None");
    const py::array array = py::array::ensure(from);  // which clears what numpy says
    if (!array) refuse(name, "an array is expected");
    return array;
}

void check_shape(const py::array& array, const std::string& name, py::ssize_t columns) {
    const bool is_fine = columns == 0 ? array.ndim() == 1 : array.ndim() == 2 && array.shape(1) == columns;
    if (is_fine) return;
    const std::string wanted = columns == 0 ? "(n,)" : "(n, " + std::to_string(columns) + ")";
    refuse(name, "the shape must be " + wanted + ", not " + shape_of(array));
}

void check_numbers(const py::array& array, const std::string& name) {
    const char kind = array.dtype().kind();
    if (kind != 'f' && kind != 'i' && kind != 'u')
        refuse(name, "numbers are expected, not " + std::string(py::str(array.dtype())));
}

/// The first index that no vertex has. @param first  of the array
template <class T>
void check_indices(const T* indices, std::size_t count, std::size_t vertices, const std::string& name) {
    for (std::size_t i = 0; i < count; ++i) {
        const bool is_negative = std::numeric_limits<T>::is_signed && indices[i] < T(0);
        if (!is_negative && std::uint64_t(indices[i]) < vertices) continue;
        refuse(name, "index " + std::to_string(indices[i]) + " of triangle " + std::to_string(i / 3) +
                         " is not one of the " + std::to_string(vertices) + " vertices");
    }
}

/// @tparam T  that the array is of
template <class T>
py::array_t<std::uint32_t> as_indices(const py::array& array, const std::string& name, std::size_t vertices) {
    const auto typed = py::array_t<T, py::array::c_style | aligned>::ensure(array);
    if (!typed) refuse(name, "an array of integers is expected");
    check_indices(typed.data(), std::size_t(typed.size()), vertices, name);
    if constexpr (sizeof(T) == sizeof(std::uint32_t)) return py::array_t<std::uint32_t>(typed.attr("view")("uint32"));
    py::array_t<std::uint32_t> out(typed.size());
    std::uint32_t* const to = out.mutable_data();
    for (py::ssize_t i = 0; i < typed.size(); ++i) to[i] = std::uint32_t(typed.data()[i]);
    return out;
}

}  // namespace

py::array_t<float> floats(py::handle from, const std::string& name, py::ssize_t columns) {
    const py::array array = array_like(from, name);
    if (array.size() == 0 && array.ndim() == 1 && columns > 0)
        return py::array_t<float>(std::vector<py::ssize_t>{0, columns});
    check_shape(array, name, columns);
    check_numbers(array, name);
    const auto out = py::array_t<float, converted>::ensure(array);
    if (!out) refuse(name, "numbers are expected");
    return out;
}

py::array_t<std::uint32_t> triangles(py::handle from, const std::string& name, std::size_t vertices) {
    const py::array array = array_like(from, name);
    if (array.size() == 0) return py::array_t<std::uint32_t>(py::ssize_t(0));
    if (!(array.ndim() == 1 && array.size() % 3 == 0)) check_shape(array, name, 3);
    const char kind = array.dtype().kind();
    if (kind != 'i' && kind != 'u') refuse(name, "integers are expected, not " + std::string(py::str(array.dtype())));
    const bool is_signed = kind == 'i';
    switch (array.itemsize()) {
        case 4:
            return is_signed ? as_indices<std::int32_t>(array, name, vertices)
                             : as_indices<std::uint32_t>(array, name, vertices);
        case 8:
            if (!is_signed) return as_indices<std::uint64_t>(array, name, vertices);
            [[fallthrough]];
        default:
            return as_indices<std::int64_t>(py::array(array.attr("astype")("int64", py::arg("copy") = false)), name,
                                            vertices);
    }
}

dmat4 matrix(py::handle from, const std::string& name) {
    const py::array given = array_like(from, name);
    check_numbers(given, name);
    const auto array = py::array_t<double, converted>::ensure(given);
    if (!array) refuse(name, "numbers are expected");
    if (array.ndim() != 2 || array.shape(0) != 4 || array.shape(1) != 4)
        refuse(name, "the shape must be (4, 4), not " + shape_of(array));
    dmat4 m;
    for (std::size_t row = 0; row < 4; ++row)
        for (std::size_t column = 0; column < 4; ++column) {
            m[column][row] = array.at(row, column);
            if (!std::isfinite(m[column][row])) refuse(name, "the matrix is not finite");
        }
    return m;
}

py::array array_of_matrix(const dmat4& m) {
    py::array_t<double> out({4, 4});
    for (py::ssize_t row = 0; row < 4; ++row)
        for (py::ssize_t column = 0; column < 4; ++column)
            out.mutable_at(row, column) = m[std::size_t(column)][std::size_t(row)];
    return out;
}

}  // namespace rakelight::python
