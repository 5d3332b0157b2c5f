// SPDX-License-Identifier: Apache-2.0
#include "engines/opengl/picture/blended_check.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "math/linear.h"
#include "shading/draw_choices.h"

namespace rakelight::opengl {
namespace {

constexpr std::size_t most_triangles = 40000, most_pairs = 50000;  ///< that are looked at, for a few milliseconds
constexpr double least_area = 1;                                   ///< [px^2]
constexpr double least_gap = 1e-4;                                 ///< of the depth keys, as a share of them

/// A triangle on the screen. Depth keys are affine there; greater is nearer.
struct Seen {
    dvec2 corner[3];
    double key[3];
    double left, right, top, bottom;
};

double area_of(dvec2 a, dvec2 b, dvec2 c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

/// A convex polygon of the screen.
struct Polygon {
    dvec2 corner[12];
    int count = 0;

    /// What is left where `inside`, which is affine, is not negative.
    template <class Inside>
    void clip(const Inside& inside) {
        Polygon out;
        for (int i = 0; i < count; ++i) {
            const dvec2 a = corner[i], b = corner[(i + 1) % count];
            const double at_a = inside(a), at_b = inside(b);
            if (at_a >= 0) out.corner[out.count++] = a;
            if ((at_a >= 0) != (at_b >= 0)) out.corner[out.count++] = a + (b - a) * (at_a / (at_a - at_b));
        }
        *this = out;
    }
    double area() const {
        double twice = 0;
        for (int i = 2; i < count; ++i) twice += area_of(corner[0], corner[i - 1], corner[i]);
        return std::fabs(twice) / 2;
    }
};

double key_at(const Seen& t, dvec2 p) {
    const double whole = area_of(t.corner[0], t.corner[1], t.corner[2]);
    const double b1 = area_of(t.corner[0], p, t.corner[2]) / whole, b2 = area_of(t.corner[0], t.corner[1], p) / whole;
    return t.key[0] + b1 * (t.key[1] - t.key[0]) + b2 * (t.key[2] - t.key[0]);
}

/// The first of two that are drawn one after the other is nearer somewhere.
bool is_wrong(const Seen& first, const Seen& second) {
    Polygon both{{first.corner[0], first.corner[1], first.corner[2]}, 3};
    const double turn = area_of(second.corner[0], second.corner[1], second.corner[2]) < 0 ? -1 : 1;
    for (int k = 0; k < 3; ++k)
        both.clip([&](dvec2 p) { return turn * area_of(second.corner[k], second.corner[(k + 1) % 3], p); });
    both.clip([&](dvec2 p) { return key_at(first, p) - key_at(second, p) * (1 + least_gap); });
    return both.area() > least_area;
}

/// The triangles that are drawn, in their order.
class SeenTriangles {
public:
    SeenTriangles(const shading::DrawList& list, const shading::PictureCamera& view, const RenderSettings& settings)
        : list_(list), view_(view), settings_(settings) {}

    std::vector<Seen> of(const std::vector<BlendedRun>& runs) const {
        std::vector<Seen> seen;
        std::size_t left = most_triangles;
        for (const BlendedRun& run : runs) {
            const shading::Draw& draw = list_.draws[run.draw];
            const Mesh& mesh = list_.scene.meshes[draw.mesh];
            const dmat4 to_camera = view_.world_to_camera * draw.to_world;
            const shading::Culling culling = shading::culling_of(list_, draw, settings_);
            for (const std::uint32_t t : run.triangles) {
                if (left-- == 0) return seen;
                add(mesh, t, to_camera, culling, seen);
            }
        }
        return seen;
    }

private:
    void add(const Mesh& mesh, std::uint32_t triangle, const dmat4& to_camera, const shading::Culling& culling,
             std::vector<Seen>& to) const {
        Seen t;
        for (std::size_t k = 0; k < 3; ++k) {
            const dvec3 p =
                transform_point(to_camera, cast<double>(mesh.positions[mesh.indices[3 * std::size_t(triangle) + k]]));
            if (!(-p.z > view_.z_near)) return;
            const double w = view_.orthographic ? 1 : -p.z;
            t.corner[k] = {(p.x * view_.scale_x / w + 1) * 0.5 * view_.width,
                           (1 - p.y * view_.scale_y / w) * 0.5 * view_.height};
            t.key[k] = view_.orthographic ? 1 - (-p.z - view_.z_near) / (view_.z_far - view_.z_near) : 1 / w;
        }
        const double area = area_of(t.corner[0], t.corner[1], t.corner[2]);
        if (!(std::fabs(area) > 2 * least_area)) return;
        const bool is_front = (area < 0) == culling.front_is_negative;
        if (is_front ? culling.front : culling.back) return;
        const auto [left, right] = std::minmax({t.corner[0].x, t.corner[1].x, t.corner[2].x});
        const auto [top, bottom] = std::minmax({t.corner[0].y, t.corner[1].y, t.corner[2].y});
        t.left = left, t.right = right, t.top = top, t.bottom = bottom;
        if (right > 0 && left < view_.width && bottom > 0 && top < view_.height) to.push_back(t);
    }

    const shading::DrawList& list_;
    const shading::PictureCamera& view_;
    const RenderSettings& settings_;
};

}  // namespace

bool has_wrong_order(const shading::DrawList& list, const shading::PictureCamera& view, const RenderSettings& settings,
                     const std::vector<BlendedRun>& runs) {
    const std::vector<Seen> seen = SeenTriangles(list, view, settings).of(runs);
    std::vector<std::size_t> by_left(seen.size());
    std::iota(by_left.begin(), by_left.end(), std::size_t(0));
    std::sort(by_left.begin(), by_left.end(),
              [&](std::size_t a, std::size_t b) { return seen[a].left < seen[b].left; });
    std::size_t pairs = 0;
    for (std::size_t i = 0; i < by_left.size(); ++i)
        for (std::size_t j = i + 1; j < by_left.size() && seen[by_left[j]].left < seen[by_left[i]].right; ++j) {
            if (++pairs > most_pairs) return false;
            const Seen& first = seen[std::min(by_left[i], by_left[j])];
            const Seen& second = seen[std::max(by_left[i], by_left[j])];
            const bool overlaps = first.top < second.bottom && second.top < first.bottom;
            const double nearest = std::max({first.key[0], first.key[1], first.key[2]}),
                         farthest = std::min({second.key[0], second.key[1], second.key[2]});
            if (overlaps && nearest > farthest && is_wrong(first, second)) return true;
        }
    return false;
}

}  // namespace rakelight::opengl
