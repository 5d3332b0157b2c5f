// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/write/glb_writer.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <system_error>

#include <nlohmann/json.hpp>

#include <rakelight/base/report.h>
#include <rakelight_internal/base/file_ending.h>

#include "io/files/output_file.h"
#include "io/gltf/write/glb_writer_materials.h"
#include "io/gltf/write/glb_writer_motion.h"
#include "io/gltf/write/save_data.h"
#include "io/gltf/write/save_files.h"
#include "math/linear.h"

namespace rakelight::io {
namespace gltf {
namespace {

OrderedJson json_of(const dmat4& m) {
    OrderedJson json = OrderedJson::array();
    for (int column = 0; column < 4; ++column)
        for (const double x : {m[column].x, m[column].y, m[column].z, m[column].w}) json.push_back(x);
    return json;
}

/// A rotation and a translation whose -Z is `direction`.
dmat4 placed_light(const Light& light) {
    const dvec3 z = normalize_or(-light.direction, dvec3{0, 0, 1});
    const dvec3 x = normalize_or(cross(std::abs(z.y) < 0.9 ? dvec3{0, 1, 0} : dvec3{1, 0, 0}, z), dvec3{1, 0, 0});
    const dvec3 y = cross(z, x), p = light.position;
    return {{{x.x, x.y, x.z, 0}, {y.x, y.y, y.z, 0}, {z.x, z.y, z.z, 0}, {p.x, p.y, p.z, 1}}};
}

class GlbWriter {
public:
    GlbWriter(const Scene& scene, Context& context) : scene_(scene), context_(context), motion_(root_, scene, context) {
        root_["asset"] = {{"version", "2.0"}, {"generator", "Rakelight"}};
        root_["scene"] = 0;
        root_["scenes"] = OrderedJson::array({OrderedJson::object()});
        for (const char* name : {"nodes", "meshes", "accessors", "bufferViews"}) root_[name] = OrderedJson::array();
    }

    void write(const std::string& path) {
        say_what_is_lost();
        std::vector<std::byte> binary;
        const MovedMaterials moved(scene_);
        MaterialWriter materials(root_, scene_, moved, context_);
        materials.write(binary);
        while (binary.size() % 4 != 0) binary.push_back(std::byte{0});
        NewData data(root_, 0, binary.size());
        nodes(data);
        cameras();
        PointerWriter pointers(root_, scene_, moved, lights());
        const bool uses_pointers = motion_.animations(mesh_node_, pointers, data);
        for (const std::vector<std::string>& list : {materials.extensions(), pointers.extensions()})
            for (const std::string& name : list) used(name);
        if (uses_pointers) used("KHR_animation_pointer");
        if (!extensions_.empty()) root_["extensionsUsed"] = extensions_;
        if (std::find(extensions_.begin(), extensions_.end(), "EXT_texture_webp") != extensions_.end())
            root_["extensionsRequired"] = {"EXT_texture_webp"};  // the textures have no other source
        binary.insert(binary.end(), data.bytes().begin(), data.bytes().end());
        if (root_["meshes"].empty()) throw Error(ErrorCode::bad_file, "nothing to write: there is no mesh");
        root_["buffers"] = OrderedJson::array({{{"byteLength", binary.size()}}});
        file_ending(path) == "gltf" ? write_text(path, binary) : write_container(path, binary);
    }

private:
    void used(const std::string& extension) {
        if (std::find(extensions_.begin(), extensions_.end(), extension) == extensions_.end())
            extensions_.push_back(extension);
    }

    void lost(const char* what) { context_.report().add(Remark::dropped, scene_.source, {}, what); }

    void say_what_is_lost() {
        const auto has_groups = [](const Mesh& m) { return !m.smoothing.empty() || !m.smoothing_hint.empty(); };
        if (std::any_of(scene_.meshes.begin(), scene_.meshes.end(), has_groups))
            context_.report().add(Remark::note, scene_.source, {},
                                  "glTF cannot store smoothing groups: only the normals keep them");
        if (std::any_of(scene_.meshes.begin(), scene_.meshes.end(), [](const Mesh& m) { return !m.arrays.empty(); }))
            lost("other vertex attributes are not written");
    }

    /// @param targets  how many morph targets the glTF mesh has
    OrderedJson primitive(std::uint32_t number, std::size_t targets, NewData& data) {
        const Mesh& mesh = scene_.meshes[number];
        const auto floats = [&](const auto& block, const char* type) {
            using T = std::remove_cvref_t<decltype(block[0])>;
            Elements e;
            e.data = reinterpret_cast<const std::byte*>(block.data());
            e.count = block.size();
            e.stride = sizeof(T);
            e.components = sizeof(T) / sizeof(float);
            return data.extended(e, {}, {{"componentType", 5126}, {"type", type}});
        };
        const auto directions = [&](const auto& block) {
            constexpr auto width = sizeof(block[0]) / sizeof(float);
            return data.directions({&block[0].x, block.size() * width}, width, ComponentType::f32);
        };
        OrderedJson attributes;
        vec3 low = mesh.positions[0], high = low;
        for (const vec3& p : mesh.positions) low = min(low, p), high = max(high, p);
        Elements positions;
        positions.data = reinterpret_cast<const std::byte*>(mesh.positions.data());
        positions.count = mesh.positions.size();
        positions.stride = sizeof(vec3);
        positions.components = 3;
        attributes["POSITION"] =
            data.extended(positions, {}, {{"min", {low.x, low.y, low.z}}, {"max", {high.x, high.y, high.z}}});
        if (!mesh.normals.empty()) attributes["NORMAL"] = directions(mesh.normals);
        if (!mesh.normals.empty() && !mesh.tangents.empty()) attributes["TANGENT"] = directions(mesh.tangents);
        if (!mesh.normals.empty() && !mesh.bitangents.empty())
            attributes["_BITANGENT"] = floats(mesh.bitangents, "VEC3");
        for (std::size_t set = 0; set < mesh.texcoords.size() && !mesh.texcoords[set].empty(); ++set)
            attributes["TEXCOORD_" + std::to_string(set)] = floats(mesh.texcoords[set], "VEC2");
        if (!mesh.colors.empty()) attributes["COLOR_0"] = floats(mesh.colors, "VEC4");
        motion_.add_influences(attributes, mesh, number, data);
        OrderedJson json = {{"attributes", std::move(attributes)},
                            {"indices", data.indices(mesh.indices, ComponentType::u16)}};
        motion_.add_targets(json, mesh, targets, data);
        if (mesh.material != no_index) json["material"] = mesh.material;
        if (mesh.topology != Topology::triangles) json["mode"] = mesh.topology == Topology::lines ? 1 : 0;
        return json;
    }

    /// The glTF mesh of a node's meshes; nodes with the same list share it. `no_index` when they hold nothing.
    std::uint32_t mesh_of(const std::vector<std::uint32_t>& list, NewData& data) {
        if (const auto known = meshes_.find(list); known != meshes_.end()) return known->second;
        OrderedJson primitives = OrderedJson::array();
        for (const std::uint32_t m : list)
            if (!scene_.meshes[m].indices.empty() && !scene_.meshes[m].positions.empty())
                primitives.push_back(primitive(m, target_count(scene_, list), data));
        if (primitives.empty()) return meshes_[list] = no_index;
        OrderedJson mesh = OrderedJson::object();
        if (!scene_.meshes[list[0]].name.empty()) mesh["name"] = one_line(scene_.meshes[list[0]].name);
        mesh["primitives"] = std::move(primitives);
        add_target_names(mesh, list);
        const auto number = std::uint32_t(root_["meshes"].size());
        root_["meshes"].push_back(std::move(mesh));
        return meshes_[list] = number;
    }

    /// Where programs look for them.
    void add_target_names(OrderedJson& mesh, const std::vector<std::uint32_t>& list) {
        OrderedJson names = OrderedJson::array();
        for (const std::uint32_t m : list)
            for (std::size_t t = names.size(); t < scene_.meshes[m].targets.size(); ++t)
                names.push_back(one_line(scene_.meshes[m].targets[t].name));
        if (!names.empty()) mesh["extras"]["targetNames"] = std::move(names);
    }

    /// What the node that shows a mesh has beside it.
    void show_mesh(OrderedJson& json, const Node& node, std::uint32_t mesh, dvec3 origin, NewData& data) {
        json["mesh"] = mesh;
        if (node.skin != no_index) json["skin"] = motion_.skin_of(node.skin, origin, data);
        const std::size_t targets = target_count(scene_, node.meshes);
        if (targets == 0 || node.morph_weights.empty()) return;
        std::vector<float> weights(node.morph_weights.begin(), node.morph_weights.end());
        weights.resize(targets, 0.0f);
        json["weights"] = weights;
    }

    std::size_t add_node(OrderedJson node, std::uint32_t parent) {
        OrderedJson& list = root_["nodes"];
        const std::size_t number = list.size();
        list.push_back(std::move(node));
        (parent == no_index ? root_["scenes"][0]["nodes"] : list[parent]["children"]).push_back(number);
        return number;
    }

    static void add_placement(OrderedJson& json, const Transform& local) {
        if (local.matrix) {
            if (!(*local.matrix == dmat4{})) json["matrix"] = json_of(*local.matrix);
            return;
        }
        const auto& [t, r, s] = std::tie(local.translation, local.rotation, local.scale);
        if (!(t == dvec3{})) json["translation"] = {t.x, t.y, t.z};
        if (!(r == dquat{})) json["rotation"] = {r.x, r.y, r.z, r.w};
        if (!(s == dvec3{1, 1, 1})) json["scale"] = {s.x, s.y, s.z};
    }

    void nodes(NewData& data) {
        std::vector<std::pair<std::size_t, dvec3>>
            away;  // meshes that do not count from zero: each on a child of its own
        mesh_node_.assign(scene_.nodes.size(), no_index);
        for (std::size_t n = 0; n < scene_.nodes.size(); ++n) {
            context_.throw_if_cancelled();
            const Node& node = scene_.nodes[n];
            OrderedJson json = OrderedJson::object();
            if (!node.name.empty()) json["name"] = one_line(node.name);
            add_placement(json, node.local);
            const dvec3 origin = node.meshes.empty() ? dvec3{} : scene_.meshes[node.meshes[0]].origin;
            const std::uint32_t mesh = node.meshes.empty() ? no_index : mesh_of(node.meshes, data);
            // That of a skinned one does not count: its joints take the origin in.
            const bool is_away = mesh != no_index && !(origin == dvec3{}) && node.skin == no_index;
            if (mesh != no_index && !is_away) {
                show_mesh(json, node, mesh, origin, data);
                mesh_node_[n] = n;
            }
            add_node(std::move(json), node.parent);
            if (is_away) away.emplace_back(n, origin);
        }
        for (const auto& [n, origin] : away) {
            OrderedJson json = {{"translation", {origin.x, origin.y, origin.z}}};
            show_mesh(json, scene_.nodes[n], mesh_of(scene_.nodes[n].meshes, data), origin, data);
            mesh_node_[n] = add_node(std::move(json), std::uint32_t(n));
        }
    }

    void cameras() {
        for (std::size_t c = 0; c < scene_.cameras.size(); ++c) {
            root_["cameras"].push_back(camera_json(scene_.cameras[c]));
            const Camera& camera = scene_.cameras[c];
            OrderedJson node = {{"camera", c}};
            if (camera.node == no_index) node["matrix"] = json_of(camera.to_world);
            add_node(std::move(node), camera.node);
        }
    }

    /// @return [of the scene] their numbers in the file, or `no_index`
    std::vector<std::size_t> lights() {
        std::vector<std::size_t> numbers;
        OrderedJson list = OrderedJson::array();
        bool is_converted = false;
        for (const Light& light : scene_.lights) {
            if (light.type == LightType::ambient) {
                lost("glTF cannot store ambient lights");
                numbers.push_back(no_index);
                continue;
            }
            is_converted = is_converted || light.units == LightUnits::classical;
            OrderedJson node = {{"extensions", {{"KHR_lights_punctual", {{"light", list.size()}}}}}};
            if (light.node == no_index) node["matrix"] = json_of(placed_light(light));
            numbers.push_back(list.size());
            list.push_back(light_json(light));
            add_node(std::move(node), light.node);
        }
        if (list.empty()) return numbers;
        root_["extensions"]["KHR_lights_punctual"]["lights"] = std::move(list);
        extensions_.push_back("KHR_lights_punctual");
        if (is_converted)
            context_.report().add(Remark::changed, scene_.source, {},
                                  "classical lights were converted to photometric ones; of their attenuation only the "
                                  "quadratic term was kept");
        return numbers;
    }

    /// JSON with its data in NAME.bin beside it. Both are whole before one replaces an older file.
    void write_text(const std::string& path, const std::vector<std::byte>& binary) {
        const std::filesystem::path place(path);
        const std::string name = place.stem().string() + ".bin";
        const std::filesystem::path beside = place.parent_path() / name;
        std::error_code fault;
        if (std::filesystem::exists(beside, fault) && !std::filesystem::exists(place, fault))
            throw Error(ErrorCode::failed,
                        "'" + one_line(name, 80) + "' already exists and does not belong to this model", {},
                        "choose another name, or write .glb");
        root_["buffers"][0]["uri"] = percent_encoded(name);
        OutputFile data(beside.string()), file(path);
        data.write(binary);
        data.finish();
        const std::string json = root_.dump(2, ' ', false, OrderedJson::error_handler_t::replace);
        file.write(std::as_bytes(std::span(json)));
        file.finish();
        data.commit();
        file.commit();
    }

    void write_container(const std::string& path, const std::vector<std::byte>& binary) {
        std::string json = root_.dump(-1, ' ', false, OrderedJson::error_handler_t::replace);
        while (json.size() % 4 != 0) json += ' ';
        const std::uint64_t padded = (binary.size() + 3) / 4 * 4, size = 12 + 8 + json.size() + 8 + padded;
        if (size > 0xFFFFFFFFu)
            throw Error(ErrorCode::failed, "a GLB file cannot be larger than 4 GiB").with_file(path);
        OutputFile file(path);
        const auto words = [&](std::initializer_list<std::uint32_t> list) {
            file.write(std::as_bytes(std::span(list.begin(), list.size())));
        };
        words({0x46546C67, 2, std::uint32_t(size), std::uint32_t(json.size()), 0x4E4F534A});
        file.write(std::as_bytes(std::span(json)));
        words({std::uint32_t(padded), 0x004E4942});
        file.write(binary);
        const std::array<std::byte, 3> zeros{};
        file.write(std::span(zeros).first(std::size_t(padded - binary.size())));
        file.commit();
    }

    const Scene& scene_;
    Context& context_;
    OrderedJson root_;
    MotionWriter motion_;
    std::vector<std::size_t> mesh_node_;  ///< [nodes] the node of the file that shows each one's meshes, or `no_index`
    std::map<std::vector<std::uint32_t>, std::uint32_t> meshes_;
    std::vector<std::string> extensions_;
};

}  // namespace
}  // namespace gltf

void write_glb(const Scene& scene, const std::string& path, Context& context) {
    gltf::GlbWriter(scene, context).write(path);
}

}  // namespace rakelight::io
