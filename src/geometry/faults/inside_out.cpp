// SPDX-License-Identifier: Apache-2.0
#include "geometry/faults/inside_out.h"

#include <algorithm>
#include <cmath>

#include "base/cancel_check.h"
#include "geometry/input/union_find.h"
#include "math/linear.h"

namespace rakelight::geometry {
namespace {

constexpr std::size_t max_bodies = 1000, max_looks = 30'000'000;
constexpr std::uint32_t nobody = ~0u;
constexpr double min_fill = 1e-6;  ///< minimum of 36 pi volume^2 / area^3: 1 for a sphere, 0 for a sheet
constexpr double max_opening =
    1e-5;  ///< limit of |sum of area vectors| / area: 0 for closed, consistently oriented surfaces

struct Body {
    dvec3 low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
    dvec3 area_vector;            ///< [m^2]
    double area = 0, volume = 0;  ///< [m^2], [m^3]
    bool is_open = false;
    InsideOutBody found;

    bool is_closed() const { return !is_open && length(area_vector) <= max_opening * area; }
    bool is_inside_out() const {
        return is_closed() && volume < 0 && 36 * pi * volume * volume > min_fill * area * area * area;
    }
    bool holds(const Body& other) const {
        for (std::size_t a = 0; a < 3; ++a)
            if (!(low[a] <= other.low[a] && other.high[a] <= high[a])) return false;
        return true;
    }
};

/// All bodies of a model, and the body of each place.
class Bodies {
public:
    Bodies(const PlacedMeshes& placed, const Context& context)
        : placed_(placed), check_cancel_(context), number_(placed.place.size(), nobody) {
        UnionFind sets;
        sets.reset(placed.place.size());
        for_each_face([&](const Face& f) {
            sets.join(f.place[0], f.place[1]);
            sets.join(f.place[0], f.place[2]);
        });
        for_each_face([&](const Face& f) {
            std::uint32_t& number = number_[sets.root(f.place[0])];
            if (number == nobody) number = std::uint32_t(list.size()), list.emplace_back();
            for (const std::uint32_t place : f.place) number_[place] = number;
            add_box(f);
        });
        for_each_face([&](const Face& f) { add_face(f); });
    }

    void open(std::uint32_t corner) {
        const std::uint32_t m = placed_.input.mesh_of_triangle(corner / 3);
        list[number_[placed_.place[placed_.input.corner_vertex(m, corner)]]].is_open = true;
    }

    std::vector<Body> list;

private:
    struct Face {
        std::uint32_t mesh, place[3];
        dvec3 at[3];  ///< [m] world
    };

    template <class Visit>
    void for_each_face(const Visit& visit) {
        const AttributeInput& input = placed_.input;
        FacePlaces found;
        for (std::uint32_t m = 0; m < input.meshes.size(); ++m)
            for (std::uint32_t t = input.triangle_base[m]; t < input.triangle_base[m + 1]; ++t) {
                check_cancel_();
                if (!face_places(placed_, m, t, found)) continue;
                Face face{m, {}, {}};
                for (std::uint32_t k = 0; k < 3; ++k) {
                    face.place[k] = found.corner[k];
                    const std::uint32_t v = input.corner_vertex(m, 3 * t + k) - input.vertex_base[m];
                    face.at[k] = input.placements[m].position(input.meshes[m].positions[v]);
                }
                visit(face);
            }
    }

    void add_box(const Face& f) {
        Body& body = list[number_[f.place[0]]];
        for (const dvec3& p : f.at)
            for (std::size_t a = 0; a < 3; ++a) {
                body.low[a] = std::min(body.low[a], p[a]);
                body.high[a] = std::max(body.high[a], p[a]);
            }
    }

    /// Relative to the center of the box, for precision far from the origin.
    void add_face(const Face& f) {
        Body& body = list[number_[f.place[0]]];
        const dvec3 middle = (body.low + body.high) * 0.5, a = f.at[0] - middle, b = f.at[1] - middle,
                    c = f.at[2] - middle;
        const double side = placed_.input.placements[f.mesh].flip;  // mirroring reverses the orientation
        const dvec3 area_vector = cross(b - a, c - a) * (0.5 * side);
        body.area_vector = body.area_vector + area_vector;
        body.area += length(area_vector);
        body.volume += dot(a, cross(b, c)) * side / 6;
        ++body.found.triangles;
        const std::uint32_t object = placed_.input.meshes[f.mesh].object;
        if (body.found.objects.empty() || body.found.objects.back() != object) body.found.objects.push_back(object);
    }

    const PlacedMeshes& placed_;
    CancelCheck check_cancel_;
    std::vector<std::uint32_t> number_;  ///< [places]
};

/// Closed bodies, largest boxes first, so that enclosing bodies are found early.
class Enclosures {
public:
    explicit Enclosures(const std::vector<Body>& bodies) {
        for (const Body& body : bodies)
            if (body.is_closed()) closed_.push_back(&body);
        std::stable_sort(closed_.begin(), closed_.end(), [](const Body* a, const Body* b) {
            const dvec3 of_a = a->high - a->low, of_b = b->high - b->low;
            return dot(of_a, of_a) > dot(of_b, of_b);
        });
    }
    /// Also true if the search was cut off: the result is then unknown.
    bool may_hold(const Body& body) {
        for (const Body* other : closed_) {
            if (looks_++ == max_looks) return --looks_, true;
            if (other != &body && other->holds(body)) return true;
        }
        return false;
    }

private:
    std::vector<const Body*> closed_;
    std::size_t looks_ = 0;
};

}  // namespace

std::vector<InsideOutBody> find_inside_out(const PlacedMeshes& placed, std::span<const std::uint32_t> open_corners,
                                           const Context& context) {
    Bodies bodies(placed, context);
    for (const std::uint32_t corner : open_corners) bodies.open(corner);
    Enclosures enclosures(bodies.list);
    std::vector<InsideOutBody> found;
    for (Body& body : bodies.list) {
        if (found.size() == max_bodies) break;
        context.throw_if_cancelled();
        if (!body.is_inside_out() || enclosures.may_hold(body)) continue;  // the inner surface of a hollow body
        std::vector<std::uint32_t>& objects = body.found.objects;
        std::sort(objects.begin(), objects.end());
        objects.erase(std::unique(objects.begin(), objects.end()), objects.end());
        found.push_back(body.found);
    }
    return found;
}

}  // namespace rakelight::geometry
