// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/write/save_gltf.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <nlohmann/json.hpp>

#include "base/format_text.h"
#include "io/files/file.h"
#include "io/gltf/container.h"
#include "io/gltf/write/save_files.h"
#include "io/gltf/write/save_placements.h"
#include "io/gltf/write/save_primitive.h"
#include "io/same_attributes.h"

namespace rakelight::io {
namespace gltf {
namespace {

constexpr const char* draco_name = "KHR_draco_mesh_compression";

class Saver {
public:
    Saver(const std::string& source, Bytes file, const Scene& before, const Scene& after,
          const GltfSaveOptions& options, Context& context)
        : before_(before),
          after_(after),
          context_(context),
          keeps_unused_(options.keep_unused),
          document_(source, file, options.read, quiet_),
          tree_(parse_ordered(open_container(*file, source, quiet_).json)),
          buffers_(document_),
          accessors_(document_, buffers_),
          storage_(accessors_, before),
          versions_(mesh_versions(before, after, options.keep_instances, context)),
          origin_(origins(before, after)) {}

    GltfSaveResult save(const std::string& output) {
        find_changes();
        OutputModel model(document_, buffers_, tree_, output);
        NewData data(tree_, model.buffer(), model.offset());
        const AccessorUses uses_before(tree_);
        if (result_.changed) {
            OwnArrays own(tree_, uses_before, model.binary());
            PrimitiveEditor editor(accessors_, storage_, tree_, data, own);
            for (const MeshVersion& version : versions_) edit(version, editor);
            drop_unused_extension();
        } else {
            for (const MeshVersion& version : versions_) list(version, version.source_mesh);
        }
        context_.throw_if_cancelled();
        model.write(data.bytes(), !result_.changed, keeps_unused_, context_);
        if (result_.changed) say_what_is_unused(uses_before);
        return std::move(result_);
    }

private:
    bool is_changed(std::uint32_t mesh) const { return changed_[mesh]; }

    /// Bits count only when some difference is more than rounding: a second run over what the first wrote finds none.
    void find_changes() {
        changed_.assign(after_.meshes.size(), false);
        for (const MeshVersion& version : versions_) {
            ++versions_of_[version.source_mesh];
            result_.changed = result_.changed || !version.in_place;
            for (const std::uint32_t m : version.meshes) {
                const Mesh &a = before_.meshes[origin_[m]], &b = after_.meshes[m];
                if (b.topology != Topology::triangles || b.normals.empty()) continue;
                changed_[m] = !is_equal(a, b);
                result_.changed = result_.changed || !is_same_to_rounding(a, b);
            }
        }
    }

    template <class T>
    static bool all(const Block<T>& a, const Block<T>& b, auto same) {
        const auto each = [&](const T& x, const T& y) {
            for (std::size_t c = 0; c < sizeof(T) / sizeof(float); ++c)
                if (!same((&x.x)[c], (&y.x)[c])) return false;
            return true;
        };
        return std::equal(a.begin(), a.end(), b.begin(), b.end(), each);
    }

    /// Those that are to be written, if any are, are among the numbers of the file's vertices, except for rounding.
    static bool has_bitangents_of(const Mesh& a, const Mesh& b) {
        if (b.bitangents.empty()) return true;
        for (const VertexArray& array : a.arrays)
            if (array.name == gltf::bitangent_name && array.values.size() == 3 * b.bitangents.size())
                return std::equal(array.values.begin(), array.values.end(), &b.bitangents[0].x,
                                  [](float p, float q) { return std::fabs(double(p) - double(q)) <= rounding; });
        return false;
    }

    /// What is there is what would be written.
    bool is_equal(const Mesh& a, const Mesh& b) const {
        const auto same = [&](const char* name, const auto& x, const auto& y) {
            const ComponentType type = storage_.is_kept(a, name) ? storage_.stored(a, name) : ComponentType::f32;
            return x == y || all(x, y, [&](float p, float q) { return p == stored_value(q, type); });
        };
        const auto same_offsets = [&](std::uint32_t t, const char* name, const auto& x, const auto& y) {
            return all(
                x, y, [&, type = storage_.stored(a, t, name)](float p, float q) { return p == stored_value(q, type); });
        };
        return same_corners(a, b) && same("NORMAL", a.normals, b.normals) && same("TANGENT", a.tangents, b.tangents) &&
               has_bitangents_of(a, b) && all_targets(a, b, same_offsets);
    }

    /// same(target, name, offsets, offsets); those that are not new are the file's own, or there are none.
    static bool all_targets(const Mesh& a, const Mesh& b, const auto& same) {
        for (std::uint32_t t = 0; t < std::min(a.targets.size(), b.targets.size()); ++t) {
            const MorphTarget &x = a.targets[t], &y = b.targets[t];
            if (!y.normals.empty() && !(x.normals == y.normals) && !same(t, "NORMAL", x.normals, y.normals))
                return false;
            if (!y.tangents.empty() && !(x.tangents == y.tangents) && !same(t, "TANGENT", x.tangents, y.tangents))
                return false;
        }
        return true;
    }

    /// What is there differs from what was computed by the rounding of sums in another order, or of numbers to their
    /// codes.
    bool is_same_to_rounding(const Mesh& a, const Mesh& b) const {
        const auto same = [&](const char* name, const auto& x, const auto& y) {
            const double slack = rounding + (storage_.is_kept(a, name) ? half_step(storage_.stored(a, name)) : 0);
            return x == y || all(x, y, [&](float p, float q) { return std::fabs(double(p) - double(q)) <= slack; });
        };
        const auto same_offsets = [&](std::uint32_t t, const char* name, const auto& x, const auto& y) {
            return all(x, y, [slack = rounding + half_step(storage_.stored(a, t, name))](float p, float q) {
                return std::fabs(double(p) - double(q)) <= slack;
            });
        };
        return same_corners(a, b) && same("NORMAL", a.normals, b.normals) && same("TANGENT", a.tangents, b.tangents) &&
               has_bitangents_of(a, b) && all_targets(a, b, same_offsets);
    }

    void list(const MeshVersion& version, std::uint32_t mesh) {
        for (const std::uint32_t m : version.meshes)
            result_.primitives.push_back({mesh, after_.meshes[m].source_primitive, m, result_.changed && changed_[m]});
    }

    void edit(const MeshVersion& version, PrimitiveEditor& editor) {
        context_.throw_if_cancelled();
        OrderedJson& meshes = tree_["meshes"];
        if (version.in_place) originals_.emplace(version.source_mesh, meshes[version.source_mesh]);
        OrderedJson mesh = originals_.at(version.source_mesh);
        for (const std::uint32_t m : version.meshes)
            if (changed_[m]) mesh["primitives"][after_.meshes[m].source_primitive] = edited(m, version, editor);
        std::uint32_t number = version.source_mesh;
        if (version.in_place) {
            tree_["meshes"][number] = std::move(mesh);
        } else {
            number = std::uint32_t(tree_["meshes"].size());
            tree_["meshes"].push_back(std::move(mesh));
            for (const std::uint32_t node : version.nodes) tree_["nodes"][node]["mesh"] = number;
            ++result_.meshes_added;
        }
        list(version, number);
    }

    const OrderedJson& edited(std::uint32_t m, const MeshVersion& version, PrimitiveEditor& editor) {
        if (const auto known = edited_.find(m); known != edited_.end()) return known->second;
        const Mesh& mesh = after_.meshes[m];
        const Value source_mesh = document_.element(mesh_kind, mesh.source_mesh, document_.root());
        const std::string place = format_text("{}, primitive {}", source_mesh.place(), mesh.source_primitive);
        const Value source = source_mesh.list("primitives").element(mesh.source_primitive, place);
        OrderedJson json = originals_.at(mesh.source_mesh)["primitives"][mesh.source_primitive];
        const PrimitiveEdit done =
            editor.edit(json, source, before_.meshes[origin_[m]], mesh, versions_of_.at(version.source_mesh) == 1);
        say(done, place);
        return edited_.emplace(m, std::move(json)).first->second;
    }

    void say(const PrimitiveEdit& done, const std::string& place) {
        Report& report = context_.report();
        if (done.unpacked)
            report.add(Remark::changed, before_.source, place, "Draco compression was undone where normals changed");
        if (done.tangents_removed)
            report.add(Remark::dropped, before_.source, place,
                       "tangents that belong to the old normals were removed (not wanted, or there are no texture "
                       "coordinates to compute new ones from)");
        if (done.keeps_target_normals)
            report.add(Remark::warning, before_.source, place,
                       "the normals of morph targets are kept: they are offsets from the old normals");
        if (done.widened)
            report.add(Remark::changed, before_.source, place,
                       "8-bit normals or tangents were converted to float: neighbors that are stored or rotated "
                       "otherwise would differ by a rounding step");
        if (done.plain)
            report.add(Remark::changed, before_.source, place,
                       "the changed arrays are written without meshopt compression");
    }

    void say_what_is_unused(const AccessorUses& before) {
        const AccessorUses now(tree_);
        const std::uint64_t bytes = before.are_all_known() ? unused_bytes(tree_, before, now) : 0;
        if (bytes > 0)
            context_.report().add(Remark::note, before_.source, {},
                                  std::to_string(bytes) + " bytes of old vertex arrays stay in the file, unused");
    }

    /// What no primitive uses any more is not to be named as used or required.
    void drop_unused_extension() {
        for (const OrderedJson& mesh : tree_["meshes"]) {
            if (!mesh.contains("primitives")) continue;
            for (const OrderedJson& primitive : mesh["primitives"])
                if (primitive.contains("extensions") && primitive["extensions"].contains(draco_name)) return;
        }
        for (const char* name : {"extensionsUsed", "extensionsRequired"}) {
            const auto list = tree_.find(name);
            if (list == tree_.end()) continue;
            OrderedJson kept = OrderedJson::array();
            for (OrderedJson& entry : *list)
                if (entry != draco_name) kept.push_back(entry);
            if (kept.size() == list->size()) continue;
            if (kept.empty())
                tree_.erase(name);
            else
                *list = std::move(kept);
        }
    }

    const Scene &before_, &after_;
    Context& context_;
    bool keeps_unused_;
    Context quiet_{{.threads = 1,
                    .max_memory = context_.memory().limit(),
                    .parent = &context_}};  // the remarks were made when the scene was read
    const Document document_;
    OrderedJson tree_;
    Buffers buffers_;
    Accessors accessors_;
    DirectionStorage storage_;
    std::vector<MeshVersion> versions_;
    std::vector<std::uint32_t> origin_;
    std::vector<bool> changed_;                         ///< [meshes of after_] by any bit
    std::map<std::uint32_t, std::size_t> versions_of_;  ///< by the file's mesh; the arrays of a lone one are its own
    std::map<std::uint32_t, OrderedJson> originals_, edited_;
    GltfSaveResult result_;
};

}  // namespace
}  // namespace gltf

GltfSaveResult save_gltf(const std::string& source, const Scene& before, const Scene& after, const std::string& output,
                         const GltfSaveOptions& options, Context& context) {
    const Bytes file = read_file(source, context);
    try {
        return gltf::Saver(source, file, before, after, options, context).save(output);
    } catch (const Error& error) {
        throw error.with_file(source);
    } catch (const gltf::OrderedJson::exception&) {  // parts that are not drawn are not checked when a file is read
        throw Error(ErrorCode::bad_file,
                    "a part of the file has another type than glTF requires, so it cannot be edited")
            .with_file(source);
    }
}

}  // namespace rakelight::io
