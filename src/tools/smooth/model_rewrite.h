// SPDX-License-Identifier: Apache-2.0
// From the model file that is read to the one that is written: what both formats have is kept.
#pragma once
#include <cstdint>
#include <memory>
#include <string>

#include <rakelight/tools/smooth_file.h>
#include <rakelight/world/load.h>

namespace rakelight {

namespace io {
struct KeptObj;
}

/// How an output comes of an input.
/// - `gltf_in_place`, `obj_in_place`: the input's file, in which only normals and tangents change.
/// - `new_gltf`, `new_obj`, `new_ply`: written anew from the scene.
enum class RewriteWay : std::uint8_t { gltf_in_place, obj_in_place, new_gltf, new_obj, new_ply };

/// A model that is about to be written to another file, or over itself.
struct ModelRewrite {
    std::string input, output;  ///< output: behind symbolic links
    RewriteWay way;
    LoadOptions load;
    Scene before;                               ///< with world positions where the output has no placements
    bool has_z_up = false;                      ///< glTF and OBJ outputs are turned
    std::shared_ptr<const io::KeptObj> kept{};  ///< obj_in_place: the lines that are written back
};

/// Whether what is loaded is one file on the disk, which can be copied.
bool is_one_file(const std::string& input, const LoadOptions& load);

/// By the endings of the names; what is not one file is written anew.
/// @throws Error usage: no such output can be written, or it is a folder
RewriteWay way_of(const std::string& input, const std::string& output, const LoadOptions& load);

/// Reads a model. @throws Error usage, not_found, bad_file
ModelRewrite begin_rewrite(const std::string& input, const std::string& output, const LoadOptions& load,
                           Context& context);

/// Writes it with the attributes of `after`.
/// @param after  ModelRewrite::before with other normals, tangents, splits and mesh copies
/// @param result  gets `changed`, `meshes_added` and `meshes`
void finish_rewrite(const ModelRewrite& model, const Scene& after, const SmoothFileOptions& options,
                    SmoothedFile& result, Context& context);

}  // namespace rakelight
