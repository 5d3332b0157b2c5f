// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/transform.h"

#include <cmath>

namespace rakelight::io::gltf {
namespace {

constexpr double unit_tolerance = 1e-3;  // exporters round to 3 to 6 digits

dmat4 affine_matrix(const Document& document, const Value& node, const std::array<double, 16>& m) {
    dmat4 matrix;
    for (std::size_t c = 0; c < 4; ++c)
        for (std::size_t r = 0; r < 4; ++r) matrix[c][r] = m[4 * c + r];
    if (m[3] != 0 || m[7] != 0 || m[11] != 0 || m[15] != 1) {
        document.remark(Remark::changed, node.place(), "its matrix is not affine; its last row is replaced by 0 0 0 1");
        matrix[0].w = matrix[1].w = matrix[2].w = 0;
        matrix[3].w = 1;
    }
    return matrix;
}

dquat rotation_of(const Document& document, const Value& node, const std::array<double, 4>& r) {
    const dquat rotation{r[0], r[1], r[2], r[3]};
    const double length = std::sqrt(r[0] * r[0] + r[1] * r[1] + r[2] * r[2] + r[3] * r[3]);
    if (length == 0) {
        document.remark(Remark::guessed, node.place(), "its rotation has zero length; it is replaced by no rotation");
        return {};
    }
    if (std::fabs(length - 1) > unit_tolerance)
        document.remark(Remark::changed, node.place(), "its rotation is not a unit quaternion; it is normalized");
    return rotation;
}

}  // namespace

Transform read_transform(const Document& document, const Value& node) {
    Transform transform;
    if (const auto matrix = node.numbers<16>("matrix")) {
        transform.matrix = affine_matrix(document, node, *matrix);
        if (node.has("translation") || node.has("rotation") || node.has("scale"))
            document.remark(Remark::dropped, node.place(),
                            "it has both a matrix and translation, rotation or scale; the matrix counts");
        return transform;
    }
    if (const auto t = node.numbers<3>("translation")) transform.translation = {(*t)[0], (*t)[1], (*t)[2]};
    if (const auto r = node.numbers<4>("rotation")) transform.rotation = rotation_of(document, node, *r);
    if (const auto s = node.numbers<3>("scale")) transform.scale = {(*s)[0], (*s)[1], (*s)[2]};
    return transform;  // a matrix or scale that flattens what it places: prepare says it, for every format
}

}  // namespace rakelight::io::gltf
