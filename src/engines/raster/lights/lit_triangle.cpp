// SPDX-License-Identifier: Apache-2.0
// The light of a triangle's corners as the kernels interpolate
// it.
#include <algorithm>
#include <cmath>

#include "engines/raster/lights/light_points.h"
#include "math/linear.h"

namespace rakelight::raster {
namespace {

void set_deltas(float (&to)[3][3], const float (&a)[3], const float (&b)[3], const float (&c)[3]) {
    for (std::size_t k = 0; k < 3; ++k) {
        to[k][0] = a[k];
        to[k][1] = b[k] - a[k];
        to[k][2] = c[k] - a[k];
    }
}

/// Which of a draw's lit sides a triangle shows.
std::size_t side_of(const FrontEnd& front, const DrawLight& light, const ScreenTriangle& s) {
    if (light.sides != 3) return std::size_t(light.sides - 1);
    const shading::LitSide side(front.list, front.list.draws[s.draw], front.settings.front_face);
    return side.is_turned(s.triangle, s.is_back) ? 1 : 0;
}

}  // namespace

DrawFrame frame_of(const FrontEnd& front, std::uint32_t draw) {
    return {front.list, front.list.draws[draw], front.to_eye[draw], front.view, front.settings.front_face};
}

void make_lit_triangle(const FrontEnd& front, const LightPoints& points, const ScreenTriangle& s, ShadeTriangle& shade,
                       LitTriangle& out) {
    const DrawLight& light = points.draws[s.draw];
    out = {};
    if (light.per_face) {  // pbr and the environment read it, too
        const dvec3 n = frame_of(front, s.draw).face(s.triangle).normal;
        shade.facing = 1;
        std::fill_n(&shade.normal[0][0], 9, 0.0f);
        for (std::size_t c = 0; c < 3; ++c) shade.normal[c][0] = float(n[c]);
    }
    if (light.sides == 0) return;  // unlit
    if (light.per_face) {
        const LitPoint& point = light.side[0][s.triangle];
        for (std::size_t c = 0; c < 3; ++c) {
            out.ambient[c][0] = point.ambient[c];
            out.diffuse[c][0] = point.diffuse[c];
            out.specular[c][0] = point.specular[c];
        }
        return;
    }
    const std::vector<LitPoint>& side = light.side[side_of(front, light, s)];
    const std::uint32_t* const index =
        front.list.scene.meshes[front.list.draws[s.draw].mesh].indices.data() + 3 * std::size_t(s.triangle);
    const LitPoint &a = side[index[0]], &b = side[index[1]], &c = side[index[2]];
    set_deltas(out.ambient, a.ambient, b.ambient, c.ambient);
    set_deltas(out.diffuse, a.diffuse, b.diffuse, c.diffuse);
    set_deltas(out.specular, a.specular, b.specular, c.specular);
}

std::vector<LitCorner> lit_corners(const FrontEnd& front, const LightPoints& points, const ScreenTriangle& s) {
    const DrawLight& light = points.draws[s.draw];
    if (light.sides == 0) return {};
    const DrawFrame frame = frame_of(front, s.draw);
    const auto corner = [](std::uint32_t vertex, dvec3 position, dvec3 normal, const LitPoint& received) {
        LitCorner out{.vertex = vertex, .position = {}, .normal = {}, .light = received};
        for (std::size_t c = 0; c < 3; ++c) {
            out.position[c] = float(position[c]);
            out.normal[c] = float(normal[c]);
        }
        return out;
    };
    if (light.per_face) {
        const DrawFrame::Face face = frame.face(s.triangle);
        return {corner(no_index, face.centroid, face.normal, light.side[0][s.triangle])};
    }
    const std::size_t side = side_of(front, light, s);
    const std::uint32_t* const index =
        front.list.scene.meshes[front.list.draws[s.draw].mesh].indices.data() + 3 * std::size_t(s.triangle);
    std::vector<LitCorner> out;
    for (std::size_t k = 0; k < 3; ++k)
        out.push_back(corner(index[k], frame.position(index[k]), frame.normal(index[k]) * (side == 0 ? 1.0 : -1.0),
                             light.side[side][index[k]]));
    return out;
}

}  // namespace rakelight::raster
