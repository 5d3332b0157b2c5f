// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/write/save_gltf.h"

#include <algorithm>
#include <map>

#include <nlohmann/json.hpp>

#include "base/format_text.h"
#include "io/files/file.h"
#include "io/gltf/container.h"
#include "io/gltf/write/save_changes.h"
#include "io/gltf/write/save_files.h"
#include "io/gltf/write/save_primitive.h"

namespace rakelight::io {
namespace gltf {
namespace {

constexpr const char* draco_name = "KHR_draco_mesh_compression";

/// The primitive that a mesh was read from.
Value primitive_of(const Document& document, const Mesh& mesh) {
    const Value owner = document.element(mesh_kind, mesh.source_mesh, document.root());
    return owner.list("primitives")
        .element(mesh.source_primitive, format_text("{}, primitive {}", owner.place(), mesh.source_primitive));
}

/// @param attributes  of a primitive or of a morph target
DirectionTypes stored_types(const Accessors& accessors, const Value& attributes) {
    DirectionTypes types;
    for (const Direction direction : all_directions) {
        const char* const name = name_of(direction);
        if (!attributes.has(name)) continue;
        const Elements e = accessors.description(attributes.required_index(name),
                                                 {name, components(3) | components(4), float_or_small}, attributes);
        types[direction] = direction_type(e.type, e.normalized);
    }
    return types;
}

/// [meshes] Of those that are not triangles: float.
std::vector<StoredDirections> stored_directions(const Accessors& accessors, const Scene& scene) {
    std::vector<StoredDirections> stored(scene.meshes.size());
    for (std::size_t m = 0; m < stored.size(); ++m) {
        if (scene.meshes[m].topology != Topology::triangles) continue;
        const Value primitive = primitive_of(accessors.document(), scene.meshes[m]);
        stored[m].own = stored_types(accessors, primitive.object("attributes"));
        const Value targets = primitive.list("targets");
        for (std::size_t t = 0; t < targets.size(); ++t)
            stored[m].targets.push_back(stored_types(accessors, targets.element(t)));
    }
    return stored;
}

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
          storage_(before, stored_directions(accessors_, before)),
          changes_(find_changes(before, after, storage_, options.keep_instances, context)) {}

    GltfSaveResult save(const std::string& output) {
        result_.changed = changes_.any;
        OutputModel model(document_, buffers_, tree_, output);
        NewData data(tree_, model.buffer(), model.offset());
        const AccessorUses uses_before(tree_);
        if (result_.changed) {
            OwnArrays own(tree_, uses_before, model.binary());
            PrimitiveEditor editor(accessors_, tree_, data, own);
            for (const MeshVersion& version : changes_.versions) edit(version, editor);
            drop_unused_extension();
        } else {
            for (const MeshVersion& version : changes_.versions) list(version, version.source_mesh);
        }
        context_.throw_if_cancelled();
        model.write(data.bytes(), !result_.changed, keeps_unused_, context_);
        if (result_.changed) say_what_is_unused(uses_before);
        return std::move(result_);
    }

private:
    void list(const MeshVersion& version, std::uint32_t mesh) {
        for (const std::uint32_t m : version.meshes)
            result_.primitives.push_back(
                {mesh, after_.meshes[m].source_primitive, m, result_.changed && changes_.changed[m]});
    }

    void edit(const MeshVersion& version, PrimitiveEditor& editor) {
        context_.throw_if_cancelled();
        OrderedJson& meshes = tree_["meshes"];
        if (version.in_place) originals_.emplace(version.source_mesh, meshes[version.source_mesh]);
        OrderedJson mesh = originals_.at(version.source_mesh);
        for (const std::uint32_t m : version.meshes)
            if (changes_.changed[m]) mesh["primitives"][after_.meshes[m].source_primitive] = edited(m, version, editor);
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
        const Value source = primitive_of(document_, mesh);
        OrderedJson json = originals_.at(mesh.source_mesh)["primitives"][mesh.source_primitive];
        const std::uint32_t was = changes_.origin[m];
        const PrimitiveChange change = change_of(was, before_.meshes[was], mesh, storage_);
        // The arrays of a mesh of one version are its own.
        const bool may_overwrite = changes_.versions_of.at(version.source_mesh) == 1;
        say(editor.edit(json, source, before_.meshes[was], mesh, change, may_overwrite), source.place());
        report_change(change, before_.source, source.place(), context_.report());
        return edited_.emplace(m, std::move(json)).first->second;
    }

    void say(const PrimitiveEdit& done, const std::string& place) {
        Report& report = context_.report();
        if (done.unpacked)
            report.add(Remark::changed, before_.source, place, "Draco compression was undone where normals changed");
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
    SceneChanges changes_;
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
