// SPDX-License-Identifier: Apache-2.0
#include "shading/edge_lengths.h"

#include <cmath>

#include "shading/guard_band.h"

namespace rakelight::shading {
namespace {

constexpr unsigned passes_ends = 1 | 2, leaves_guard = 64, unknown = 128;  ///< of Shown::outside

/// A vertex in the picture [px], and which planes it is outside of.
struct Shown {
    double x = 0, y = 0;
    unsigned outside = unknown;
};

/// Written so that a comparison with NaN counts as outside.
Shown shown(dvec3 place, const PictureCamera& view, const GuardBand& guard) {
    const double away = -place.z, w = view.orthographic ? 1 : away;
    const double x = place.x * view.scale_x, y = place.y * view.scale_y;
    Shown out{.outside = 0};
    if (!(away >= view.z_near)) out.outside |= 1;
    if (!(away <= view.z_far)) out.outside |= 2;
    if (!(x >= -w)) out.outside |= 4;
    if (!(x <= w)) out.outside |= 8;
    if (!(y >= -w)) out.outside |= 16;
    if (!(y <= w)) out.outside |= 32;
    if (!(std::abs(x) <= double(guard.x) * w && std::abs(y) <= double(guard.y) * w)) out.outside |= leaves_guard;
    if (w > 0) out.x = x / w * 0.5 * view.width, out.y = y / w * 0.5 * view.height;
    return out;
}

}  // namespace

bool edges_are_within(const DrawList& list, const Draw& draw, const PictureCamera& view, double pixels) {
    const Mesh& mesh = list.scene.meshes[draw.mesh];
    const GuardBand guard(view);
    const dmat4 to_camera = view.world_to_camera * draw.to_world;
    std::vector<Shown> places(mesh.positions.size());  // found when they are asked for: a long edge often comes first
    const auto place = [&](std::uint32_t vertex) -> const Shown& {
        Shown& s = places[vertex];
        if (s.outside == unknown)
            s = shown(transform_point(to_camera, cast<double>(mesh.positions[vertex])), view, guard);
        return s;
    };
    const auto is_long = [square = pixels * pixels](const Shown& a, const Shown& b) {
        const double dx = a.x - b.x, dy = a.y - b.y;
        return dx * dx + dy * dy > square;
    };
    bool is_seen = false;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const Shown &a = place(mesh.indices[i]), &b = place(mesh.indices[i + 1]), &c = place(mesh.indices[i + 2]);
        if ((a.outside & b.outside & c.outside & ~leaves_guard) != 0) continue;  // outside of one plane
        is_seen = true;
        const unsigned any = a.outside | b.outside | c.outside;
        if ((any & (passes_ends | leaves_guard)) != 0 || is_long(a, b) || is_long(b, c) || is_long(c, a)) return false;
    }
    return is_seen;
}

}  // namespace rakelight::shading
