// SPDX-License-Identifier: Apache-2.0
// How often lighting is evaluated on each draw: as shading/shading_choice.h says, or by the size of its triangles.
#include "shading/shading_choice.h"

#include "engines/raster/lights/light_points.h"

namespace rakelight::raster {
namespace {

/// Whether no edge of a triangle that the whole picture (not only its window) may show is longer than this.
bool edges_are_within(const FrontEnd& front, std::uint32_t number, double pixels) {
    const ScreenVertices screen = front.screen[number];
    const Block<std::uint32_t>& indices = front.list.scene.meshes[front.list.draws[number].mesh].indices;
    constexpr std::uint32_t all_codes = (1u << outcode_bits) - 1;
    const double limit = pixels * (1 << subpixel_bits), square = limit * limit;
    const auto is_long = [square](const ScreenVertex& a, const ScreenVertex& b) {
        const double dx = double(a.x) - double(b.x), dy = double(a.y) - double(b.y);
        return dx * dx + dy * dy > square;
    };
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
        const ScreenVertex &a = screen[indices[i]], &b = screen[indices[i + 1]], &c = screen[indices[i + 2]];
        if ((a.bits & b.bits & c.bits & all_codes) != 0) continue;  // outside of one plane
        const std::uint32_t any = (a.bits | b.bits | c.bits) & all_codes;
        if ((any & cutting_planes) != 0 || is_long(a, b) || is_long(b, c) || is_long(c, a)) return false;
    }
    return true;
}

}  // namespace

void choose_shading(FrontEnd& front, Context& context) {
    const auto are_within = [&](std::uint32_t draw, double pixels) {
        return !front.clip[draw].empty() && edges_are_within(front, draw, pixels);
    };
    front.shading = shading::choose_shading(front.list, front.settings, are_within, context);
}

bool is_lit_at_corners(const FrontEnd& front, std::uint32_t draw) {
    return front.shading[draw] == Shading::flat || front.shading[draw] == Shading::gouraud;
}

}  // namespace rakelight::raster
