// SPDX-License-Identifier: Apache-2.0
// numpy arrays in and out. Out: the library's own memory, which the array keeps alive. In: the caller's memory where type and layout fit.
#pragma once
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <rakelight/image/block.h>
#include <rakelight/math/vector.h>

namespace rakelight::python {

namespace py = pybind11;

/// What an element is to numpy: its number and how many of them.
template <class T>
struct Element {
    using Number = T;
    static constexpr py::ssize_t columns = 0;  ///< 0: the array has one dimension
};
template <class N>
struct Element<Vector2<N>> {
    using Number = N;
    static constexpr py::ssize_t columns = 2;
};
template <class N>
struct Element<Vector3<N>> {
    using Number = N;
    static constexpr py::ssize_t columns = 3;
};
template <class N>
struct Element<Vector4<N>> {
    using Number = N;
    static constexpr py::ssize_t columns = 4;
};

/// Memory of an owner as an array.
/// @param shape  of elements, without their columns
template <class T, class Owner>
py::array array_of(const T* data, std::vector<py::ssize_t> shape, std::unique_ptr<Owner> owner) {
    using Number = typename Element<T>::Number;
    if (Element<T>::columns > 0) shape.push_back(Element<T>::columns);
    const py::capsule base(owner.get(), [](void* p) { delete static_cast<Owner*>(p); });
    (void)owner.release();  // the capsule's from here on
    return py::array_t<Number>(std::move(shape), reinterpret_cast<const Number*>(data), base);
}

/// A vector, moved into an array that may be written to.
template <class T>
py::array take(std::vector<T> values, std::vector<py::ssize_t> shape) {
    auto owner = std::make_unique<std::vector<T>>(std::move(values));
    const T* const data = owner->data();
    return array_of(data, std::move(shape), std::move(owner));
}
template <class T>
py::array take(std::vector<T> values) {
    const py::ssize_t size = py::ssize_t(values.size());
    return take(std::move(values), {size});
}

/// What a block holds, to be read; None: it is empty.
/// @param shape  of elements; empty: [size]
template <class T>
py::object view(const Block<T>& block, std::vector<py::ssize_t> shape = {}) {
    if (block.empty()) return py::none();
    if (shape.empty()) shape = {py::ssize_t(block.size())};
    py::array array = array_of(block.data(), std::move(shape), std::make_unique<Block<T>>(block));
    array.attr("setflags")(py::arg("write") = false);
    return array;
}

/// An array of the caller's, [n, columns] floats, copied only where its type, layout or alignment is another.
/// @param columns  0: one dimension
/// @throws Error usage: another shape, or what is no number
py::array_t<float> floats(py::handle from, const std::string& name, py::ssize_t columns);

/// Triangles, [n, 3] or [3n], likewise. int32 is taken as it is.
/// @throws Error usage: another shape or type, an index that no vertex has
py::array_t<std::uint32_t> triangles(py::handle from, const std::string& name, std::size_t vertices);

/// A matrix of 4 x 4 numbers, rows first, as numpy has them. @throws Error usage: another shape, or not finite
dmat4 matrix(py::handle from, const std::string& name);
py::array array_of_matrix(const dmat4& m);

/// Elements of an array of floats().
template <class T>
std::span<const T> span_of(const py::array_t<float>& array) {
    constexpr py::ssize_t columns = Element<T>::columns > 0 ? Element<T>::columns : 1;
    return {reinterpret_cast<const T*>(array.data()), std::size_t(array.size() / columns)};
}
inline std::span<const std::uint32_t> span_of(const py::array_t<std::uint32_t>& array) {
    return {array.data(), std::size_t(array.size())};
}

}  // namespace rakelight::python
