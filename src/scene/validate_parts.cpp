// SPDX-License-Identifier: Apache-2.0
// validate(): the checks of meshes and animations, and the messages.
#include "scene/validate_parts.h"

#include <algorithm>
#include <cmath>
#include <unordered_set>

#include <rakelight/base/error.h>
#include <rakelight/scene/animated_properties.h>
#include <rakelight/scene/motion.h>
#include <rakelight/scene/validate.h>

#include "base/format_text.h"
#include "math/linear.h"
#include "scene/faults.h"
#include "scene/motion/sample_channel.h"
#include "scene/placement.h"

namespace rakelight {

std::string Place::text() const {
    std::string text = format_text("{} {}", kind, number);
    if (!name.empty()) text += " '" + one_line(name, 80) + "'";
    return text;
}

void Place::fail(const std::string& reason) const { throw Error(ErrorCode::bad_file, reason, text()); }

void Place::index(const char* what, std::uint32_t value, std::size_t count) const {
    if (value >= count) fail(format_text("{} {} does not exist (there are {})", what, value, count));
}

void Place::index_or_none(const char* what, std::uint32_t value, std::size_t count) const {
    if (value != no_index) index(what, value, count);
}

void Place::size(const char* what, std::size_t is, std::size_t wanted, const char* unit) const {
    if (is != wanted) fail(format_text("{} {} for {} {}", is, what, wanted, unit));
}

void Place::size_or_empty(const char* what, std::size_t is, std::size_t wanted, const char* unit) const {
    if (is != 0) size(what, is, wanted, unit);
}

void Place::finite(const char* what, double value) const {
    if (!std::isfinite(value)) fail(std::string(what) + " is not finite");
}

void Place::finite(const char* what, const dvec3& value) const {
    if (!is_finite(value)) fail(std::string(what) + " is not finite");
}

void Place::finite(const char* what, const dvec4& value) const {
    finite(what, value.xyz());
    finite(what, value.w);
}

void Place::finite(const char* what, const dmat4& value) const {
    for (const dvec4& column : value.columns) finite(what, column);
}

void Place::fine(const char* fault) const {
    if (fault) fail(fault);
}

namespace {

/// Four independent maxima break the dependency chain (saves a quarter of the time of validate()).
std::uint32_t largest_of(std::span<const std::uint32_t> indices) {
    std::uint32_t largest[4] = {0, 0, 0, 0};
    std::size_t i = 0;
    for (; i + 4 <= indices.size(); i += 4)
        for (std::size_t k = 0; k < 4; ++k) largest[k] = std::max(largest[k], indices[i + k]);
    for (; i < indices.size(); ++i) largest[0] = std::max(largest[0], indices[i]);
    return std::max({largest[0], largest[1], largest[2], largest[3]});
}

void check_indices(const Place& place, const Mesh& mesh) {
    const std::size_t vertices = mesh.positions.size();
    const unsigned corners = mesh.topology == Topology::triangles ? 3 : mesh.topology == Topology::lines ? 2 : 1;
    if (mesh.indices.size() % corners != 0)
        place.fail(format_text("{} indices are not a multiple of {}", mesh.indices.size(), corners));
    if (mesh.indices.empty() || largest_of(mesh.indices) < vertices)
        return;  // the common case, without a branch a corner
    for (std::size_t corner = 0; corner < mesh.indices.size(); ++corner)
        if (mesh.indices[corner] >= vertices)
            place.fail(
                format_text("index {} at corner {} exceeds {} vertices", mesh.indices[corner], corner, vertices));
}

std::uint32_t check_influences(const Place& place, const Mesh& mesh) {
    std::uint32_t needed = 0;
    for (const Block<JointInfluence>* block : {&mesh.influences, &mesh.more_influences})
        for (const JointInfluence& influence : *block)
            for (std::size_t k = 0; k < 4; ++k) {
                place.finite("a joint weight", influence.weights[k]);
                if (influence.weights[k] != 0) needed = std::max(needed, influence.joints[k] + 1u);
            }
    return needed;
}

void check_target(const Scene& scene, const Place& place, const AnimationChannel& channel) {
    switch (channel.path) {
        case AnimationPath::material:
            place.index_or_none("material", channel.element, scene.materials.size());
            break;
        case AnimationPath::light:
            place.index_or_none("light", channel.element, scene.lights.size());
            break;
        case AnimationPath::camera:
            place.index_or_none("camera", channel.element, scene.cameras.size());
            break;
        default:
            place.index_or_none("node", channel.element, scene.nodes.size());
            return;
    }
    if (!animated_property(channel.path, channel.property))
        place.fail("there is no property '" + one_line(channel.property, 40) + "' to animate");
}

/// Already checked blocks: a small file may use one large block in thousands of channels.
struct SeenNumbers {
    std::unordered_set<const void*> times, values;
};

void check_channel(const Scene& scene, const Place& place, const AnimationChannel& channel, SeenNumbers& seen) {
    place.enumerator("path", channel.path, AnimationPath::camera);
    place.enumerator("interpolation", channel.interpolation, Interpolation::cubic_spline);
    check_target(scene, place, channel);
    if (channel.element == no_index) return;
    if (seen.times.insert(channel.times.identity()).second)
        for (std::size_t k = 0; k < channel.times.size(); ++k) {
            place.finite("a key's time", channel.times[k]);
            if (k > 0 && channel.times[k] < channel.times[k - 1]) place.fail("the times of a channel do not ascend");
        }
    if (seen.values.insert(channel.values.identity()).second)
        for (const float value : channel.values) place.finite("a key's value", value);
    const std::size_t per_key =
        channel_width(scene, channel) * (channel.interpolation == Interpolation::cubic_spline ? 3 : 1);
    place.size("values of a channel", channel.values.size(), channel.times.size() * per_key, "expected");
}

void check_animation(const Scene& scene, std::size_t number, SeenNumbers& seen) {
    const Animation& animation = scene.animations[number];
    const Place place{"animation", number, animation.name};
    for (const AnimationChannel& channel : animation.channels) check_channel(scene, place, channel, seen);
}

void check_choice(const Place& place, const NormalChoice& choice) {
    place.enumerator("choice of normals", choice.source, NormalSource::seams);
    const double crease = choice.crease_angle_rad.value_or(0);
    if (!(crease >= 0 && crease <= pi)) place.fail("the crease angle is not 0 to pi");
}

}  // namespace

std::uint32_t check_mesh(const Scene& scene, std::size_t number, const Mesh* known) {
    const Mesh& mesh = scene.meshes[number];
    const Place place{"mesh", number, mesh.name};
    const std::size_t vertices = mesh.positions.size();
    place.enumerator("topology", mesh.topology, Topology::points);
    place.enumerator("kind of smoothing", mesh.smoothing_kind, SmoothingKind::numbers);
    place.fine(mesh.subdivision ? fault_of(*mesh.subdivision) : nullptr);
    if (mesh.normal_choice) check_choice(place, *mesh.normal_choice);
    if (vertices >= no_index) place.fail("too many vertices for 32-bit indices");
    place.finite("the origin", mesh.origin);
    place.finite("the step of the positions", mesh.position_step);
    if (mesh.position_step < 0) place.fail("the step of the positions is negative");
    place.index_or_none("material", mesh.material, scene.materials.size());
    place.size_or_empty("normals", mesh.normals.size(), vertices, "vertices");
    place.size_or_empty("tangents", mesh.tangents.size(), vertices, "vertices");
    place.size_or_empty("bitangents", mesh.bitangents.size(), vertices, "vertices");
    for (const Block<vec2>& set : mesh.texcoords)
        place.size_or_empty("texture coordinates", set.size(), vertices, "vertices");
    place.size_or_empty("colors", mesh.colors.size(), vertices, "vertices");
    for (const VertexArray& array : mesh.arrays) {
        if (array.components < 1 || array.components > 16)
            place.fail("numbers of vertices have 0 or more than 16 components");
        if (array.values.size() != vertices * array.components)
            place.fail("the numbers '" + one_line(array.name, 40) + "' are not those of all vertices");
    }
    place.size_or_empty("joint influences", mesh.influences.size(), vertices, "vertices");
    place.size_or_empty("more joint influences", mesh.more_influences.size(), mesh.influences.size(), "vertices");
    place.size_or_empty("smoothing groups", mesh.smoothing.size(), mesh.triangle_count(), "triangles");
    place.size_or_empty("smoothing hints", mesh.smoothing_hint.size(), 3 * std::size_t(mesh.triangle_count()),
                        "corners");
    place.size_or_empty("polygon numbers", mesh.polygons.size(), mesh.triangle_count(), "triangles");
    for (const MorphTarget& target : mesh.targets) {
        place.size_or_empty("morph positions", target.positions.size(), vertices, "vertices");
        place.size_or_empty("morph normals", target.normals.size(), vertices, "vertices");
        place.size_or_empty("morph tangents", target.tangents.size(), vertices, "vertices");
    }
    const bool are_known = known && known->indices == mesh.indices && known->topology == mesh.topology &&
                           known->positions.size() == vertices;
    if (!are_known) check_indices(place, mesh);
    return check_influences(place, mesh);
}

void check_transform(const Place& place, const Transform& t) {
    if (t.matrix) {
        place.finite("the matrix", *t.matrix);
        return;
    }
    place.finite("the translation", t.translation);
    place.finite("the scale", t.scale);
    place.finite("the rotation", dvec4{t.rotation.x, t.rotation.y, t.rotation.z, t.rotation.w});
}

void check_animation(const Scene& scene, std::size_t number) {
    SeenNumbers seen;
    check_animation(scene, number, seen);
}

void check_pose(const Scene& scene) {
    if (!scene.pose) return;
    const Place place{"scene", 0, scene.source};
    place.size("placements of the pose", scene.pose->local.size(), scene.nodes.size(), "nodes");
    place.size("morph weights of the pose", scene.pose->morph_weights.size(), scene.nodes.size(), "nodes");
    std::unordered_set<const void*> seen;
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
        check_transform(Place{"node", i, scene.nodes[i].name}, scene.pose->local[i]);
        if (!seen.insert(scene.pose->morph_weights[i].identity()).second) continue;
        for (const float weight : scene.pose->morph_weights[i])
            Place{"node", i, scene.nodes[i].name}.finite("a morph weight", weight);
    }
}

void check_animations(const Scene& scene) {
    SeenNumbers seen;
    for (std::size_t i = 0; i < scene.animations.size(); ++i) check_animation(scene, i, seen);
}

}  // namespace rakelight
