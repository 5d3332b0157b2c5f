// SPDX-License-Identifier: Apache-2.0
// Points about the eye that lighting is evaluated at, and the light of a triangle's corners as the kernels interpolate
// it.
#include <algorithm>

#include "engines/raster/light_points.h"
#include "math/linear.h"

namespace rakelight::raster {
namespace {

void set_deltas(float (&to)[3][3], const float (&a)[3], const float (&b)[3], const float (&c)[3]) {
    for (std::size_t k = 0; k < 3; ++k) {
        to[0][k] = a[k];
        to[1][k] = b[k] - a[k];
        to[2][k] = c[k] - a[k];
    }
}

}  // namespace

DrawFrame::DrawFrame(const FrontEnd& front, std::uint32_t draw)
    : view_(front.view),
      mesh_(front.list.scene.meshes[front.list.draws[draw].mesh]),
      to_eye_(front.to_eye[draw]),
      to_normal_(cofactor(upper_left(to_eye_))),
      mirror_(front.list.draws[draw].mirrored ? -1 : 1) {}

dvec3 DrawFrame::position(std::uint32_t vertex) const {
    return transform_point(to_eye_, cast<double>(mesh_.positions[vertex]));
}

dvec3 DrawFrame::normal(std::uint32_t vertex) const {
    return normalize_or(to_normal_ * cast<double>(mesh_.normals[vertex]) * mirror_, dvec3{0, 0, 1});
}

void DrawFrame::corners(std::uint32_t triangle, std::uint32_t (&index)[3], dvec3 (&position)[3]) const {
    for (std::size_t k = 0; k < 3; ++k) {
        index[k] = mesh_.indices[3 * std::size_t(triangle) + k];
        position[k] = this->position(index[k]);
    }
}

DrawFrame::Face DrawFrame::face(std::uint32_t triangle) const {
    std::uint32_t index[3];
    dvec3 p[3];
    corners(triangle, index, p);
    const dvec3 centroid = (p[0] + p[1] + p[2]) / 3.0;
    const dvec3 normal = normalize_or(cross(p[1] - p[0], p[2] - p[0]), dvec3{0, 0, 1});
    // All of a plane is seen from one side: that of the eye, which is the origin here.
    const double seen = dot(normal, view_.orthographic ? view_.camera_to_world[2].xyz() : -centroid);
    return {centroid, seen < 0 ? -normal : normal};
}

void make_lit_triangle(const FrontEnd& front, const LightPoints& points, const ScreenTriangle& s, ShadeTriangle& shade,
                       LitTriangle& out) {
    out = {};
    const DrawLight& light = points.draws[s.draw];
    const DrawFrame frame(front, s.draw);
    if (light.per_face) {
        const dvec3 n = frame.face(s.triangle).normal;
        shade.facing = 1;
        std::fill_n(&shade.normal[0][0], 9, 0.0f);
        for (std::size_t c = 0; c < 3; ++c) shade.normal[0][c] = float(n[c]);
        if (light.side[0].empty()) return;  // unlit
        const LitPoint& point = light.side[0][s.triangle];
        std::copy_n(point.ambient, 3, out.ambient[0]);
        std::copy_n(point.diffuse, 3, out.diffuse[0]);
        std::copy_n(point.specular, 3, out.specular[0]);
        return;
    }
    std::uint32_t index[3];
    const std::vector<LitPoint>& side = light.side[seen_side(front, frame, s, index)];
    if (side.empty()) return;  // unlit
    const LitPoint &a = side[index[0]], &b = side[index[1]], &c = side[index[2]];
    set_deltas(out.ambient, a.ambient, b.ambient, c.ambient);
    set_deltas(out.diffuse, a.diffuse, b.diffuse, c.diffuse);
    set_deltas(out.specular, a.specular, b.specular, c.specular);
}

int seen_side(const FrontEnd& front, const DrawFrame& frame, const ScreenTriangle& s, std::uint32_t (&index)[3]) {
    dvec3 position[3], normal[3];
    frame.corners(s.triangle, index, position);
    for (std::size_t k = 0; k < 3; ++k) normal[k] = frame.normal(index[k]);
    return facing(front, s, position, normal) < 0 ? 1 : 0;
}

ShadeJob material_job(const FrontEnd& front, const std::vector<lighting::LightParameters>& lights,
                      std::uint32_t material) {
    const RenderSettings& settings = front.settings;
    ShadeJob out{};
    const MaterialView& view = front.list.materials[material].view;
    const bool is_per_pixel = settings.shading != Shading::flat && settings.shading != Shading::gouraud;
    out.material = &view;
    out.lights = lights.data();
    out.light_count = std::int32_t(lights.size());
    out.reflection_model = settings.lighting == Lighting::lambert ? 0 : settings.lighting == Lighting::phong ? 1 : 2;
    out.reflection_form = settings.specular_form == SpecularForm::automatic
                              ? view.metallic_roughness
                              : settings.specular_form == SpecularForm::normalized;
    out.specular_horizon = settings.specular_horizon;
    out.orthogonalize = settings.orthogonalize;
    out.bump = settings.bump != Bump::none && is_per_pixel;
    out.unlit = view.unlit || settings.shading == Shading::unlit;
    out.orthographic = front.view.orthographic;
    const dvec3 back = front.view.camera_to_world[2].xyz();
    out.view_direction[0] = float(back.x), out.view_direction[1] = float(back.y), out.view_direction[2] = float(back.z);
    return out;
}

}  // namespace rakelight::raster
