// SPDX-License-Identifier: Apache-2.0
// An opened glTF file: the tree, the binary chunk, and where messages go.
#pragma once
#include <memory>
#include <span>
#include <string>

#include "io/files/file.h"
#include "io/gltf/value.h"
#include "io/reader.h"

namespace rakelight::io::gltf {

/// A list at the root of the tree and what one of its elements is called in messages.
struct Kind {
    const char* list;
    const char* word;
};
inline constexpr Kind accessor_kind{"accessors", "accessor"}, animation_kind{"animations", "animation"},
    buffer_kind{"buffers", "buffer"}, buffer_view_kind{"bufferViews", "bufferView"}, camera_kind{"cameras", "camera"},
    image_kind{"images", "image"}, light_kind{"lights", "light"}, material_kind{"materials", "material"},
    mesh_kind{"meshes", "mesh"}, node_kind{"nodes", "node"}, sampler_kind{"samplers", "sampler"},
    scene_kind{"scenes", "scene"}, skin_kind{"skins", "skin"}, texture_kind{"textures", "texture"};

/// One file being read. Not copyable: values point into its tree.
class Document {
public:
    /// Takes a GLB container apart, parses the JSON, and checks version and required extensions. @throws Error bad_file
    /// @param file  the whole file  @param path  its name, for messages and for resolving references
    Document(const std::string& path, Bytes file, const ReadOptions& options, Context& context);
    Document(const Document&) = delete;
    Document& operator=(const Document&) = delete;

    const Value& root() const { return root_; }
    std::size_t count(Kind kind) const { return root_.list(kind.list).size(); }
    /// Element `index` of a list. @throws Error at the place of `from`: "mesh 7 does not exist (the file has 3)"
    Value element(Kind kind, std::uint32_t index, const Value& from) const {
        return element_of(root_, kind, index, from);
    }
    /// The same for a list inside another object (the lights of KHR_lights_punctual).
    Value element_of(const Value& owner, Kind kind, std::uint32_t index, const Value& from) const;
    /// The element's own name, or "mesh 3".
    static std::string name_of(const Value& element, Kind kind, std::uint32_t index);

    bool uses_quantization() const { return uses_quantization_; }  ///< KHR_mesh_quantization in extensionsUsed
    void remark(Remark remark, const std::string& place, std::string message) const;

    const std::string& path() const { return path_; }
    const ReadOptions& options() const { return options_; }
    Context& context() const { return context_; }
    bool has_binary() const { return has_binary_; }
    std::span<const std::byte> binary() const { return binary_; }  ///< the BIN chunk of a GLB file
    std::uint64_t file_bytes() const { return file_->size(); }
    const Bytes& file() const { return file_; }
    /// Pays for the tables of the scene that is read; becomes one of Scene::charges.
    MemoryCharge& scene_charge() const { return scene_charge_; }

private:
    void check_version() const;
    void check_extensions();

    std::string path_;
    const ReadOptions& options_;
    Context& context_;
    Bytes file_;
    std::span<const std::byte> binary_;
    bool has_binary_ = false, uses_quantization_ = false;
    mutable MemoryCharge scene_charge_;
    MemoryCharge tree_charge_;
    std::shared_ptr<const Json> tree_;
    Value root_;
};

/// Runs `read`; when it fails, the part it would have made is left out and the reason goes into the report. For parts
/// that a picture can do without (textures, animations, cameras, lights).
template <class Read>
bool read_or_drop(const Document& document, const std::string& what, Read read) {
    try {
        read();
        return true;
    } catch (const Error& error) {
        if (error.code() == ErrorCode::failed) throw;  // cancelled, out of memory
        document.remark(Remark::dropped, error.place(), what + " is left out: " + error.reason());
        return false;
    }
}

}  // namespace rakelight::io::gltf
