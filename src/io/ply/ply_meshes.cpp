// SPDX-License-Identifier: Apache-2.0
#include "io/ply/ply_meshes.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace rakelight::io::ply {
namespace {

/// Corners with per-corner data become separate vertices, shared by corners with the same data.
class CornerSplitter {
public:
    CornerSplitter(std::size_t vertices, Context& context)
        : charge_(context.memory(), vertices * sizeof(std::uint32_t), "the corners of a file"),
          newest_(vertices, no_index) {}

    std::uint32_t number(std::uint32_t vertex, const CornerValue& value) {
        constexpr int most_looks = 32;  // a file may give one vertex any number of values
        std::uint32_t v = newest_[vertex];
        for (int looks = 0; v != no_index && looks < most_looks; ++looks, v = older_[v])
            if (values[v] == value) return v;
        constexpr std::size_t bytes = 2 * sizeof(std::uint32_t) + sizeof(CornerValue);
        if (source.size() == source.capacity())
            charge_.grow(std::max<std::size_t>(source.size(), 64) * bytes, "the corners of a file");
        const auto number = std::uint32_t(source.size());
        source.push_back(vertex), values.push_back(value), older_.push_back(newest_[vertex]);
        return newest_[vertex] = number;
    }
    std::vector<std::uint32_t> source;  ///< [new vertices] the vertex of the file
    std::vector<CornerValue> values;    ///< [new vertices]

private:
    MemoryCharge charge_;
    std::vector<std::uint32_t> newest_, older_;
};

template <class T>
void gather(Block<T>& block, const std::vector<std::uint32_t>& source, Context& context) {
    if (block.empty()) return;
    MemoryCharge charge(context.memory(), source.size() * sizeof(T), "the corners of a file");
    std::vector<T> values;
    values.reserve(source.size());
    for (const std::uint32_t v : source) values.push_back(block[v]);
    block = {std::move(values), std::move(charge)};
}

template <class T, class Of>
Block<T> made_of(const std::vector<CornerValue>& values, Context& context, const Of& of) {
    MemoryCharge charge(context.memory(), values.size() * sizeof(T), "the corners of a file");
    std::vector<T> out;
    out.reserve(values.size());
    for (const CornerValue& v : values) out.push_back(of(v));
    return {std::move(out), std::move(charge)};
}

void split_corners(Mesh& mesh, Faces& faces, Context& context) {
    CornerSplitter splitter(mesh.positions.size(), context);
    for (std::size_t i = 0; i < faces.triangles.size(); ++i)
        faces.triangles[i] = splitter.number(faces.triangles[i], faces.values[i]);
    gather(mesh.positions, splitter.source, context);
    gather(mesh.normals, splitter.source, context);
    gather(mesh.colors, splitter.source, context);
    for (Block<vec2>& set : mesh.texcoords) gather(set, splitter.source, context);
    for (VertexArray& a : mesh.arrays) gather(a.values, splitter.source, context);
    if (faces.have_texcoords)
        mesh.texcoords = {made_of<vec2>(splitter.values, context, [](const CornerValue& v) { return v.uv; })};
    if (faces.have_colors)
        mesh.colors = made_of<vec4>(splitter.values, context, [](const CornerValue& v) { return v.color; });
}

void add_mesh(Scene& scene, Mesh mesh, Topology topology, std::vector<std::uint32_t> indices, MemoryCharge charge) {
    mesh.topology = topology;
    mesh.indices = {std::move(indices), std::move(charge)};
    scene.nodes[0].meshes.push_back(std::uint32_t(scene.meshes.size()));
    scene.meshes.push_back(std::move(mesh));
}

std::vector<std::uint32_t> all_vertices(std::size_t count) {
    std::vector<std::uint32_t> indices(count);
    std::iota(indices.begin(), indices.end(), 0u);
    return indices;
}

}  // namespace

void add_meshes(Scene& scene, Mesh mesh, Faces& faces, Context& context) {
    const auto charge = [&](std::uint64_t count) {
        return MemoryCharge(context.memory(), count * sizeof(std::uint32_t), "a mesh");
    };
    if (!faces.lines.empty())
        add_mesh(scene, mesh, Topology::lines, std::move(faces.lines), charge(faces.lines.size()));
    if (!faces.triangles.empty()) {
        const std::size_t values = faces.has_values() ? faces.triangles.size() : 0;
        const MemoryCharge padded(context.memory(), (values - faces.values.size()) * sizeof(CornerValue),
                                  "the corners of a file");
        faces.values.resize(values);
        if (faces.has_values()) split_corners(mesh, faces, context);
        MemoryCharge paid = charge(faces.triangles.size());
        if (!faces.polygons.empty()) {
            MemoryCharge polygons = charge(faces.polygons.size());
            mesh.polygons = {std::move(faces.polygons), std::move(polygons)};
        }
        add_mesh(scene, std::move(mesh), Topology::triangles, std::move(faces.triangles), std::move(paid));
    } else if (scene.meshes.empty()) {
        const std::size_t count = mesh.positions.size();
        MemoryCharge paid = charge(count);
        add_mesh(scene, std::move(mesh), Topology::points, all_vertices(count), std::move(paid));
    }
}

}  // namespace rakelight::io::ply
