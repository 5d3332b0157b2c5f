// SPDX-License-Identifier: Apache-2.0
#include "io/import/scene_from_import.h"

#include <cmath>

#include "base/format_text.h"
#include "io/vertex_colors.h"
#include "math/linear.h"

namespace rakelight::io {
namespace {

using import_stream::Document;
using import_stream::Import;
using import_stream::Place;

bool is_finite(const dmat4& m) {
    for (std::size_t c = 0; c < 4; ++c)
        for (std::size_t r = 0; r < 4; ++r)
            if (!std::isfinite(m[c][r])) return false;
    return true;
}

dmat4 affine(dmat4 m) {  // readers leave rounding, or nonsense, in the last row
    for (std::size_t c = 0; c < 3; ++c) m[c].w = 0;
    m[3].w = 1;
    return m;
}

/// The node's own matrix: of its parts when an animation sets them.
Transform local_of(const Place& p, std::size_t number) {
    Transform t;
    t.translation = p.translation;
    t.rotation = p.rotation;
    t.scale = p.scale;
    const dquat& q = p.rotation;
    const bool parts = p.animated != 0 && rakelight::is_finite(p.translation) && rakelight::is_finite(p.scale) &&
                       std::isfinite(q.x + q.y + q.z + q.w);
    if (!parts) t = {.matrix = affine(p.matrix)};
    if (!parts && !is_finite(*t.matrix))
        throw Error(ErrorCode::bad_file, "a matrix is not finite",
                    format_text("node {} '{}'", number, one_line(p.name, 60)));
    return t;
}

dmat4 matrix_of(const Transform& t) { return t.matrix ? *t.matrix : compose(t.translation, t.rotation, t.scale); }

/// Nodes in the file's order; the file's axes and unit go into the root, or into a node above it where an animation owns the root.
void add_nodes(Document& d, Scene& scene) {
    const dmat4 axes = detail::to_our_axes(d.axes);
    const bool change = !(axes == dmat4{}), above = change && !d.places.empty() && d.places[0].animated != 0;
    const std::uint32_t shift = above ? 1 : 0;
    if (above) {
        Node& root = scene.nodes.emplace_back();
        root.name = "axes";
        root.local.matrix = axes;
    }
    for (std::size_t i = 0; i < d.places.size(); ++i) {
        Place& p = d.places[i];
        Node& node = scene.nodes.emplace_back();
        node.local = local_of(p, i);
        node.name = std::move(p.name);
        node.parent = p.parent != import_stream::nothing ? p.parent + shift : above ? 0 : no_index;
        if (change && !above && p.parent == import_stream::nothing)
            node.local = {.matrix = axes * matrix_of(node.local)};
        node.meshes = std::move(p.meshes);
    }
    if (shift == 0) return;
    for (auto& l : d.lamps) l.node += l.node != import_stream::nothing;
    for (auto& v : d.views) v.node += v.node != import_stream::nothing;
    for (auto& j : d.joints) j.node += 1;
    for (auto& m : d.motions)
        for (auto& t : m.tracks) t.node += 1;
}

std::vector<dmat4> matrices_to_world(const Scene& scene) {
    std::vector<dmat4> world;
    for (const Node& n : scene.nodes)
        world.push_back(n.parent == no_index ? matrix_of(n.local) : world[n.parent] * matrix_of(n.local));
    return world;
}

/// One skin for the whole file: every mesh counts its joints in the same table.
void add_skin(const Document& d, Scene& scene) {
    if (d.joints.empty()) return;
    Skin skin;
    std::vector<dmat4> inverse_bind;
    for (const auto& j : d.joints) {
        if (!is_finite(j.inverse_bind))
            throw Error(ErrorCode::bad_file, "the bind matrix of a joint is not finite",
                        "node " + std::to_string(j.node));
        skin.joints.push_back(j.node);
        inverse_bind.push_back(affine(j.inverse_bind));
    }
    skin.inverse_bind = std::move(inverse_bind);
    scene.skins.push_back(std::move(skin));
    for (Node& n : scene.nodes)
        for (std::uint32_t m : n.meshes)
            if (!scene.meshes[m].influences.empty()) n.skin = 0;
}

void add_morph_weights(Scene& scene) {
    std::map<std::size_t, Block<float>> zeros;  // by their number
    for (Node& n : scene.nodes)
        for (std::uint32_t m : n.meshes) {
            const std::size_t targets = scene.meshes[m].targets.size();
            if (n.morph_weights.size() >= targets) continue;
            Block<float>& shared = zeros[targets];
            if (shared.empty()) shared = std::vector<float>(targets, 0.0f);
            n.morph_weights = shared;
        }
}

void add_animations(Document& d, Scene& scene) {
    for (auto& motion : d.motions) {
        Animation animation;
        animation.name = std::move(motion.name);
        for (auto& t : motion.tracks) {
            const AnimationPath path = t.path == 0   ? AnimationPath::translation
                                       : t.path == 1 ? AnimationPath::rotation
                                                     : AnimationPath::scale;
            animation.channels.push_back(
                {t.node, path, Interpolation::linear, {}, std::move(t.times), std::move(t.values)});
        }
        scene.animations.push_back(std::move(animation));
    }
}

void add_notes(const Document& d, const std::string& path, Report& report) {
    constexpr Remark kinds[] = {Remark::changed, Remark::dropped, Remark::warning, Remark::note};
    for (const auto& n : d.notes)
        report.add(kinds[n.kind < 4 ? n.kind : 2], path, one_line(n.place, 120), one_line(n.message));
}

/// The color of what Assimp calls by this name is its own.
std::vector<bool> have_invented_color(const Document& d) {
    std::vector<bool> out;
    for (const import_stream::Surface& s : d.surfaces) out.push_back(s.name == "DefaultMaterial");
    return out;
}

bool draws_something(const Scene& scene) {
    for (const Node& n : scene.nodes)
        for (std::uint32_t m : n.meshes)
            if (!scene.meshes[m].indices.empty()) return true;
    return false;
}

}  // namespace

dmat4 detail::to_our_axes(const import_stream::AxisSystem& a) {
    const bool distinct = a.up != a.front && a.front != a.side && a.side != a.up;
    const double unit = std::isfinite(a.unit_m) && a.unit_m > 0 ? a.unit_m : 1;
    dmat4 m = scaling(dvec3{unit, unit, unit});
    if (!distinct) return m;
    m = {};
    for (std::size_t c = 0; c < 3; ++c) m[c] = {0, 0, 0, 0};
    m[std::size_t(a.side)].x = unit * a.side_sign;
    m[std::size_t(a.up)].y = unit * a.up_sign;
    m[std::size_t(a.front)].z = unit * a.front_sign;
    return m;
}

Scene scene_from_import(Import&& import, const std::string& path, const std::string& ending, const ReadOptions& options,
                        Context& context) {
    Scene scene;
    scene.source = path;
    add_notes(import.document, path, context.report());
    detail::add_meshes(import, path, scene, context);
    detail::add_materials(import, path, ending, options.allow_outside, scene, context);
    show_vertex_colors(scene, have_invented_color(import.document), context);
    add_nodes(import.document, scene);
    add_skin(import.document, scene);
    add_morph_weights(scene);
    add_animations(import.document, scene);
    detail::add_lights_and_cameras(import.document, matrices_to_world(scene), path, scene, context);
    if (!draws_something(scene))
        throw Error(ErrorCode::bad_file, "nothing to draw: no object has a triangle, line or point");
    scene.charges.push_back(share(std::move(import.charge)));  // without what the meshes' arrays have taken along
    return scene;
}

}  // namespace rakelight::io
