// SPDX-License-Identifier: Apache-2.0
#include "shading/draw_frame.h"

#include <algorithm>
#include <cmath>

#include "math/linear.h"

namespace rakelight::shading {
namespace {

/// Unit vector; +Z for none. The short way for nearly all.
dvec3 unit_or_forward(dvec3 v) {
    const double square = dot(v, v);
    return square > 1e-200 && square < 1e200 ? v * (1 / std::sqrt(square)) : normalize_or(v, dvec3{0, 0, 1});
}

}  // namespace

DrawFrame::DrawFrame(const DrawList& list, const Draw& draw, const dmat4& to_eye, const PictureCamera& view,
                     FrontFace front_face)
    : view_(view),
      mesh_(list.scene.meshes[draw.mesh]),
      to_eye_(to_eye),
      linear_(upper_left(to_eye)),
      to_normal_(cofactor(linear_)),
      mirror_(draw.mirrored != (mesh_.normals.empty() && front_face == FrontFace::clockwise) ? -1 : 1),
      side_(list, draw, front_face) {
    for (std::size_t c = 0; c < 3; ++c) to_normal_[c] = to_normal_[c] * mirror_;
}

dvec3 DrawFrame::position(std::uint32_t vertex) const {
    return transform_point(to_eye_, cast<double>(mesh_.positions[vertex]));
}

dvec3 DrawFrame::normal(std::uint32_t vertex) const {
    return unit_or_forward(to_normal_ * cast<double>(mesh_.normals[vertex]));
}

DrawFrame::Face DrawFrame::face(std::uint32_t triangle) const {
    const std::uint32_t* const index = indices(triangle);
    const dvec3 p[3] = {position(index[0]), position(index[1]), position(index[2])};
    const dvec3 centroid = (p[0] + p[1] + p[2]) / 3.0;
    const dvec3 normal = unit_or_forward(cross(p[1] - p[0], p[2] - p[0]));
    // All of a plane is seen from one side: that of the eye, which is the origin here.
    const double seen = dot(normal, view_.orthographic ? view_.camera_to_world[2].xyz() : -centroid);
    return {centroid, seen < 0 ? -normal : normal};
}

DrawFrame::Corners DrawFrame::corners(std::uint32_t triangle) const {
    const std::uint32_t* const index = indices(triangle);
    Corners out{};
    out.handedness = float(mirror_);
    if (!mesh_.tangents.empty()) out.handedness *= mesh_.tangents[index[0]].w;
    for (std::size_t k = 0; k < 3; ++k) {
        out.position[k] = position(index[k]);
        if (!mesh_.normals.empty())
            out.normal[k] = normalize_or(to_normal_ * cast<double>(mesh_.normals[index[k]]), dvec3{0, 0, 1});
        if (!mesh_.tangents.empty())
            out.tangent[k] = normalize_or(linear_ * cast<double>(mesh_.tangents[index[k]].xyz()), dvec3{});
        if (!mesh_.bitangents.empty())
            out.bitangent[k] = normalize_or(linear_ * cast<double>(mesh_.bitangents[index[k]]), dvec3{});
    }
    if (!mesh_.normals.empty()) return out;
    const dvec3 face = cross(out.position[1] - out.position[0], out.position[2] - out.position[0]) * mirror_;
    std::fill(out.normal, out.normal + 3, normalize_or(face, dvec3{0, 0, 1}));
    return out;
}

}  // namespace rakelight::shading
