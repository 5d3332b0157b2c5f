// SPDX-License-Identifier: Apache-2.0
#include "bake/low/make_coordinates.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <rakelight_internal/base/text.h>

#include "bake/low/charts.h"
#include "bake/low/shelf_packing.h"
#include "base/format_text.h"
#include "math/linear.h"
#include "prepare/split_vertices.h"
#include "prepare/variants.h"
#include "scene/charge_arrays.h"
#include "scene/placement.h"

namespace rakelight::bake {
namespace {

/// [V] the first vertex at exactly the same position. @param places  finite
std::vector<std::uint32_t> place_numbers(std::span<const dvec3> places) {
    std::vector<std::uint32_t> order(places.size()), numbers(places.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto key = [&](std::uint32_t v) { return std::tie(places[v].x, places[v].y, places[v].z); };
    std::ranges::sort(order,
                      [&](std::uint32_t a, std::uint32_t b) { return key(a) != key(b) ? key(a) < key(b) : a < b; });
    for (std::size_t i = 0; i < order.size(); ++i)
        numbers[order[i]] = i > 0 && key(order[i]) == key(order[i - 1]) ? numbers[order[i - 1]] : order[i];
    return numbers;
}

/// A mesh instance and its charts.
struct Part {
    Instance instance;
    std::vector<dvec3> places;  ///< [V] world space
    Charts charts;
    MemoryCharge charge;
};

/// [3T] counter-clockwise from outside, vertices at one place are merged
std::vector<std::uint32_t> outward_triangles(const Mesh& mesh, std::span<const dvec3> places, bool is_mirrored) {
    const std::vector<std::uint32_t> number = place_numbers(places);
    std::vector<std::uint32_t> out;
    out.reserve(mesh.indices.size());
    for (std::size_t t = 0; t < mesh.triangle_count(); ++t)
        for (const std::size_t k : {0, is_mirrored ? 2 : 1, is_mirrored ? 1 : 2})
            out.push_back(number[mesh.indices[3 * t + k]]);
    return out;
}

Part make_part(const Mesh& mesh, const Instance& instance, const dmat4& to_world, Context& context) {
    const std::uint64_t kept = mesh.positions.size() * sizeof(dvec3) + mesh.triangle_count() * 4;
    context.memory().check(kept + mesh.positions.size() * 8 + mesh.indices.size() * 20, "charts");
    Part part{.instance = instance, .charge = MemoryCharge(context.memory(), kept, "charts")};
    part.places.reserve(mesh.positions.size());
    for (const vec3 p : mesh.positions) {
        const dvec3 place = transform_point(to_world, cast<double>(p));
        part.places.push_back(is_finite(place) ? place : dvec3{});
    }
    const bool is_mirrored = determinant(upper_left(to_world)) < 0;
    part.charts = find_charts(part.places, outward_triangles(mesh, part.places, is_mirrored), context);
    part.charge.grow(part.charts.axis.size() * (1 + 2 * sizeof(dvec2)), "charts");
    return part;
}

/// Splits vertices so that each belongs to one chart.
class ChartVertices {
public:
    explicit ChartVertices(std::size_t vertices) : first_(vertices, no_index), count_(vertices) {}
    std::uint32_t vertex(std::uint32_t v, std::uint32_t chart) {
        if (first_[v] == no_index) first_[v] = chart;
        if (first_[v] == chart) return v;
        const auto [entry, is_new] = others_.try_emplace({v, chart}, std::uint32_t(count_ + source_.size()));
        if (is_new) source_.push_back(v);
        return entry->second;
    }
    const std::vector<std::uint32_t>& source() const { return source_; }

private:
    std::vector<std::uint32_t> first_;
    std::size_t count_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> others_;
    std::vector<std::uint32_t> source_;
};

/// @param place  [charts of the part] [px]
Mesh with_coordinates(const Mesh& source, const Part& part, const dvec2* place, double scale,
                      const CoordinateOptions& options, Context& context) {
    const dvec2 size{double(options.width), double(options.height)};
    std::vector<std::uint32_t> indices(source.indices.begin(), source.indices.end());
    ChartVertices vertices(source.positions.size());
    for (std::size_t c = 0; c < indices.size(); ++c)
        indices[c] = vertices.vertex(indices[c], part.charts.of_triangle[c / 3]);
    std::vector<vec2> uv(source.positions.size() + vertices.source().size());
    for (std::size_t c = 0; c < indices.size(); ++c) {
        const std::uint32_t chart = part.charts.of_triangle[c / 3];
        const dvec2 at =
            (flattened(part.places[source.indices[c]], part.charts.axis[chart]) - part.charts.low[chart]) * scale +
            place[chart];
        uv[indices[c]] = {float(at.x / size.x), float(at.y / size.y)};
    }
    Mesh mesh = source;
    mesh.tangents = {};
    mesh.texcoords.resize(std::min<std::size_t>(mesh.texcoords.size(), options.set));
    split_vertices(mesh, std::move(indices), vertices.source(), context);
    const Block<vec2> made(std::move(uv));
    for (Block<vec2>& set : mesh.texcoords)
        if (set.empty()) set = made;
    mesh.texcoords.resize(options.set + 1, made);
    charge_new_arrays(mesh, source, context);
    return mesh;
}

}  // namespace

MadeCoordinates make_coordinates(Scene scene, const CoordinateOptions& options, Context& context) {
    const auto [width, height, margin] = std::array{options.width, options.height, options.margin};
    const std::vector<dmat4> world = world_matrices(scene);
    const std::vector<Mesh> originals = scene.meshes;
    std::vector<Part> parts;
    std::vector<dvec2> sizes;
    for (const Instance& instance : drawn_instances(scene)) {
        const Mesh& mesh = originals[instance.mesh];
        if (options.only_lit && scene.materials[mesh.material].model == MaterialModel::unlit) continue;
        parts.push_back(make_part(mesh, instance, world[instance.node] * translation(mesh.origin), context));
        const Charts& charts = parts.back().charts;
        for (std::size_t i = 0; i < charts.low.size(); ++i) sizes.push_back(charts.high[i] - charts.low[i]);
    }
    const auto packing = pack_shelves(sizes, width, height, margin, context);
    if (!packing || (packing->scale <= 0 && !sizes.empty()))
        throw Error(ErrorCode::usage,
                    format_text("a map of {} x {} pixels has no room for {} with {} pixels around each", width, height,
                                counted(sizes.size(), "chart"), margin),
                    {}, "make the map larger")
            .about(options.size_setting);
    MeshVariants variants(scene, context);
    const dvec2* place = packing->place.data();
    for (const Part& part : parts) {
        variants.place(part.instance,
                       with_coordinates(originals[part.instance.mesh], part, place, packing->scale, options, context));
        place += part.charts.low.size();
    }
    return {std::move(scene), std::uint32_t(parts.size()), packing->scale};
}

}  // namespace rakelight::bake
