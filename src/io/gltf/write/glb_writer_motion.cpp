// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/write/glb_writer_motion.h"

#include <algorithm>
#include <string>

#include <nlohmann/json.hpp>

#include <rakelight/base/error.h>
#include <rakelight_internal/base/text.h>

#include "base/format_text.h"
#include "math/linear.h"

namespace rakelight::io::gltf {
namespace {

/// @param offset, components, type  of the part of each influence that is meant
Elements part_of(const Block<JointInfluence>& influences, std::size_t offset, ComponentType type) {
    Elements e;
    e.data = reinterpret_cast<const std::byte*>(influences.data()) + offset;
    e.count = influences.size();
    e.stride = sizeof(JointInfluence);
    e.components = 4;
    e.type = type;
    return e;
}

std::uint32_t positions_of(const Block<vec3>& offsets, NewData& data) {
    vec3 low = offsets[0], high = low;
    for (const vec3& p : offsets) low = min(low, p), high = max(high, p);
    Elements e;
    e.data = reinterpret_cast<const std::byte*>(offsets.data());
    e.count = offsets.size();
    e.stride = sizeof(vec3);
    e.components = 3;
    return data.extended(e, {}, {{"min", {low.x, low.y, low.z}}, {"max", {high.x, high.y, high.z}}});
}

/// Offsets of 0: glTF 2.0, section 3.6.2.3: an accessor without a view is zeros.
std::uint32_t zeros(OrderedJson& root, std::size_t count) {
    OrderedJson& accessors = root["accessors"];
    accessors.push_back({{"componentType", int(ComponentType::f32)},
                         {"count", count},
                         {"type", "VEC3"},
                         {"min", {0, 0, 0}},
                         {"max", {0, 0, 0}}});
    return std::uint32_t(accessors.size() - 1);
}

const char* name_of(AnimationPath path) {
    switch (path) {
        case AnimationPath::translation:
            return "translation";
        case AnimationPath::rotation:
            return "rotation";
        case AnimationPath::scale:
            return "scale";
        case AnimationPath::morph_weights:
            return "weights";
        default:
            break;
    }
    return "";
}

const char* name_of(Interpolation interpolation) {
    return interpolation == Interpolation::step     ? "STEP"
           : interpolation == Interpolation::linear ? "LINEAR"
                                                    : "CUBICSPLINE";
}

}  // namespace

std::size_t target_count(const Scene& scene, const std::vector<std::uint32_t>& meshes) {
    std::size_t count = 0;
    for (const std::uint32_t m : meshes) count = std::max(count, scene.meshes[m].targets.size());
    return count;
}

MotionWriter::MotionWriter(OrderedJson& root, const Scene& scene, Context& context)
    : root_(root), scene_(scene), context_(context), is_skinned_(scene.meshes.size(), false) {
    for (const Node& node : scene.nodes)
        for (const std::uint32_t m : node.meshes) is_skinned_[m] = is_skinned_[m] || node.skin != no_index;
}

void MotionWriter::add_influences(OrderedJson& attributes, const Mesh& mesh, std::uint32_t number,
                                  NewData& data) const {
    if (mesh.influences.empty() || !is_skinned_[number]) return;
    const OrderedJson none = OrderedJson::object();
    const auto add = [&](const std::string& set, const Block<JointInfluence>& influences) {
        if (influences.empty()) return;
        attributes["JOINTS_" + set] =
            data.extended(part_of(influences, offsetof(JointInfluence, joints), ComponentType::u16), {}, none);
        attributes["WEIGHTS_" + set] =
            data.extended(part_of(influences, offsetof(JointInfluence, weights), ComponentType::f32), {}, none);
    };
    add("0", mesh.influences), add("1", mesh.more_influences);
}

void MotionWriter::add_targets(OrderedJson& primitive, const Mesh& mesh, std::size_t count, NewData& data) const {
    for (std::size_t t = 0; t < count; ++t) {
        OrderedJson json = OrderedJson::object();
        const bool is_there = t < mesh.targets.size();
        const bool moves = is_there && !mesh.targets[t].positions.empty();
        json["POSITION"] = moves ? positions_of(mesh.targets[t].positions, data) : zeros(root_, mesh.positions.size());
        const auto add = [&](const char* name, const Block<vec3>& offsets) {
            if (!offsets.empty())
                json[name] = data.directions({&offsets[0].x, 3 * offsets.size()}, 3, ComponentType::f32);
        };
        if (is_there && !mesh.normals.empty()) add("NORMAL", mesh.targets[t].normals);
        if (is_there && !mesh.tangents.empty()) add("TANGENT", mesh.targets[t].tangents);
        primitive["targets"].push_back(std::move(json));
    }
}

std::uint32_t MotionWriter::skin_of(std::uint32_t skin, dvec3 origin, NewData& data) {
    const auto [entry, is_new] = skins_.try_emplace({skin, {origin.x, origin.y, origin.z}}, 0u);
    if (!is_new) return entry->second;
    const Skin& source = scene_.skins[skin];
    std::vector<float> matrices;
    for (const dmat4& bind : source.inverse_bind) {
        const dmat4 m = bind * translation(origin);
        for (int column = 0; column < 4; ++column)
            for (const double x : {m[column].x, m[column].y, m[column].z, m[column].w}) matrices.push_back(float(x));
    }
    OrderedJson json = OrderedJson::object();
    if (!source.name.empty()) json["name"] = one_line(source.name);
    json["inverseBindMatrices"] = data.numbers(matrices, 16);
    json["joints"] = source.joints;
    entry->second = std::uint32_t(root_["skins"].size());
    root_["skins"].push_back(std::move(json));
    return entry->second;
}

namespace {

OrderedJson sampler_of(const AnimationChannel& channel, std::span<const float> values, std::uint32_t width,
                       NewData& data) {
    OrderedJson sampler = OrderedJson::object();
    sampler["input"] = data.numbers({channel.times.data(), channel.times.size()}, 1, true);
    sampler["interpolation"] = name_of(channel.interpolation);
    sampler["output"] = data.numbers(values, width);
    return sampler;
}

void add_to(OrderedJson& clip, OrderedJson sampler, OrderedJson target) {
    clip["channels"].push_back({{"sampler", clip["samplers"].size()}, {"target", std::move(target)}});
    clip["samplers"].push_back(std::move(sampler));
}

}  // namespace

bool MotionWriter::add_channel(OrderedJson& clip, const AnimationChannel& channel,
                               const std::vector<std::size_t>& mesh_node, NewData& data) const {
    if (channel.element == no_index) return false;
    const bool morphs = channel.path == AnimationPath::morph_weights;
    const std::size_t node = morphs ? mesh_node[channel.element] : channel.element;
    const bool has_place =
        !morphs || (node != no_index && target_count(scene_, scene_.nodes[channel.element].meshes) > 0);
    if (channel.times.empty() || channel.values.empty() || !has_place) return false;
    const std::uint32_t width = morphs ? 1 : channel.path == AnimationPath::rotation ? 4 : 3;
    add_to(clip, sampler_of(channel, {channel.values.data(), channel.values.size()}, width, data),
           {{"node", node}, {"path", name_of(channel.path)}});
    return true;
}

bool MotionWriter::add_pointers(OrderedJson& clip, const AnimationChannel& channel, PointerWriter& pointers,
                                NewData& data) const {
    if (channel.times.empty() || channel.values.empty()) return false;
    const std::vector<WrittenPointer> all = pointers.pointers_of(channel);
    for (const WrittenPointer& to : all) {
        std::vector<float> values(channel.values.begin(), channel.values.end());
        for (float& value : values) value /= to.divisor;
        OrderedJson target = {{"path", "pointer"}};
        target["extensions"]["KHR_animation_pointer"] = {{"pointer", to.pointer}};
        add_to(clip, sampler_of(channel, values, to.width, data), std::move(target));
    }
    return !all.empty();
}

bool MotionWriter::animations(const std::vector<std::size_t>& mesh_node, PointerWriter& pointers, NewData& data) {
    std::uint64_t left_out = 0;
    bool uses_pointers = false;
    for (const Animation& source : scene_.animations) {
        context_.throw_if_cancelled();
        OrderedJson clip = OrderedJson::object();
        if (!source.name.empty()) clip["name"] = one_line(source.name);
        clip["channels"] = OrderedJson::array();
        clip["samplers"] = OrderedJson::array();
        for (const AnimationChannel& channel : source.channels) {
            const bool is_written = channel.is_of_node() ? add_channel(clip, channel, mesh_node, data)
                                                         : add_pointers(clip, channel, pointers, data);
            uses_pointers |= is_written && !channel.is_of_node();
            left_out += !is_written;
        }
        if (!clip["channels"].empty()) root_["animations"].push_back(std::move(clip));
    }
    if (left_out > 0)
        context_.report().add(Remark::dropped, scene_.source, {},
                              counted(left_out, "animation channel was left out: it animates",
                                      "animation channels were left out: they animate") +
                                  " nothing that glTF can store");
    return uses_pointers;
}

}  // namespace rakelight::io::gltf
