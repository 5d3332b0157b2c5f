// SPDX-License-Identifier: Apache-2.0
// Coloring by a vertex attribute.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include <rakelight/scene/words.h>
#include <rakelight_internal/base/text.h>

#include "base/format_text.h"
#include "math/color.h"
#include "world/coloring.h"

namespace rakelight {
namespace {

constexpr std::size_t vertices_per_task = 1 << 14;
constexpr float without_value = 0.5f;  ///< display gray of vertices without a value

const VertexArray* find_array(const Mesh& mesh, const std::string& name) {
    const auto found = std::ranges::find(mesh.arrays, name, &VertexArray::name);
    return found == mesh.arrays.end() ? nullptr : &*found;
}

std::vector<std::string> array_names(const Scene& scene) {
    std::vector<std::string> names;
    for (const Mesh& mesh : scene.meshes)
        for (const VertexArray& a : mesh.arrays)
            if (std::ranges::find(names, a.name) == names.end()) names.push_back(a.name);
    return names;
}

double value_of(const VertexArray& array, std::size_t vertex, std::optional<int> component) {
    const float* const v = array.values.data() + vertex * array.components;
    if (array.components == 1) return double(v[0]);
    if (component) return double(v[*component]);
    double squared = 0;
    for (std::uint32_t k = 0; k < array.components; ++k) squared += double(v[k]) * double(v[k]);
    return std::sqrt(squared);
}

void check_array(const Scene& scene, const Coloring& coloring) {
    std::uint32_t most = 0;
    for (const Mesh& mesh : scene.meshes)
        if (const VertexArray* const a = find_array(mesh, coloring.array)) most = std::max(most, a->components);
    if (most == 0)
        throw Error(ErrorCode::usage, "no vertices have numbers named '" + one_line(coloring.array, 60) +
                                          "'; there are " + list_of_names(array_names(scene), 12, 60))
            .about("scalars");
    if (coloring.component && (*coloring.component < 0 || std::uint32_t(*coloring.component) >= most))
        throw Error(ErrorCode::usage, format_text("'{}' has {}, counted from 0", one_line(coloring.array, 60),
                                                  counted(most, "component")))
            .about("coloring-component");
}

dvec2 range_of(const Scene& scene, const Coloring& coloring) {
    dvec2 range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (const Mesh& mesh : scene.meshes) {
        const VertexArray* const array = find_array(mesh, coloring.array);
        const bool has_component =
            array && (!coloring.component || std::uint32_t(*coloring.component) < array->components);
        for (std::size_t v = 0; has_component && v < mesh.positions.size(); ++v) {
            const double value = value_of(*array, v, coloring.component);
            if (std::isfinite(value)) range = {std::min(range.x, value), std::max(range.y, value)};
        }
    }
    return range.x <= range.y ? range : dvec2{0, 1};
}

Block<vec4> colors_of(const Mesh& mesh, const VertexArray& array, const Coloring& coloring, Context& context) {
    const dvec2 range = *coloring.range;
    const double scale = range.y > range.x ? 1 / (range.y - range.x) : 0;
    const std::size_t count = mesh.positions.size();
    MemoryCharge charge(context.memory(), count * sizeof(vec4), "the colors of the vertices");
    std::vector<vec4> colors(count);
    context.parallel_for((count + vertices_per_task - 1) / vertices_per_task, [&](std::size_t task) {
        const std::size_t end = std::min(count, (task + 1) * vertices_per_task);
        for (std::size_t v = task * vertices_per_task; v < end; ++v) {
            const vec3 c = color_of(coloring.map, (value_of(array, v, coloring.component) - range.x) * scale);
            colors[v] = {c.x, c.y, c.z, 1};
        }
    });
    return {std::move(colors), std::move(charge)};
}

std::string text_of_range(dvec2 range) {
    char text[100];
    std::snprintf(text, sizeof text, "from %.6g to %.6g", range.x, range.y);
    return text;
}

}  // namespace

Coloring completed(const Scene& scene, Coloring coloring) {
    if (!coloring.is_on) return coloring;
    const std::vector<std::string> names = array_names(scene);
    if (names.empty())
        throw Error(ErrorCode::usage, "the vertices of the model have no numbers that it could be colored by", {},
                    "other properties of PLY files and attributes of glTF files whose names begin with '_' are such")
            .about("scalars");
    if (coloring.array.empty()) coloring.array = names[0];
    if (std::ranges::find(names, coloring.array) == names.end() &&
        std::ranges::find(names, "_" + coloring.array) != names.end())
        coloring.array.insert(0, "_");  // the glTF convention of custom attributes
    check_array(scene, coloring);
    if (!coloring.range) coloring.range = range_of(scene, coloring);
    if (!(coloring.range->x <= coloring.range->y))
        throw Error(ErrorCode::usage, "the range has to go from the smaller to the larger number")
            .about("coloring-range");
    return coloring;
}

void note_arrays(const Scene& scene, Report& report) {
    const std::vector<std::string> names = array_names(scene);
    if (names.empty()) return;
    report.add(Remark::note, scene.source, "",
               "numbers of the vertices that a picture shows by 'scalars' alone: " + list_of_names(names, 8, 40),
               {"scalars"});
}

Scene color_by_array(Scene scene, const Coloring& asked, Context& context) {
    if (!asked.is_on) return scene;
    const Coloring coloring = completed(scene, asked);
    Material plain;
    plain.name = "scalars";
    plain.model = MaterialModel::unlit;
    plain.double_sided = true;
    const auto colored = std::uint32_t(scene.materials.size());
    scene.materials.push_back(plain);
    plain.name = "without scalars";
    const float gray = linear_from_srgb(without_value);
    plain.base_color = {gray, gray, gray, 1};
    scene.materials.push_back(plain);
    for (Mesh& mesh : scene.meshes) {
        const VertexArray* const array = find_array(mesh, coloring.array);
        const bool has_value = array && (!coloring.component || std::uint32_t(*coloring.component) < array->components);
        mesh.colors = has_value ? colors_of(mesh, *array, coloring, context) : Block<vec4>{};
        mesh.material = has_value ? colored : colored + 1;
    }
    context.report().add(Remark::note, scene.source, "",
                         "colored by '" + one_line(coloring.array, 60) + "' " + text_of_range(*coloring.range));
    return scene;
}

}  // namespace rakelight
