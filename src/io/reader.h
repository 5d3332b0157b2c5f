// SPDX-License-Identifier: Apache-2.0
// Loading of all formats: a file name in, a validated scene out, remarks into the context's report.
#pragma once
#include <memory>
#include <string>

#include <rakelight/scene/scene.h>

#include "io/files/file.h"

namespace rakelight::io {

struct KeptObj;

struct ReadOptions {
    bool allow_outside = false;  ///< references may leave the model's own folder tree
    double import_seconds =
        8;  ///< time limit of the import helper for files of up to 32 MiB; larger ones get more in proportion
    std::shared_ptr<const KeptObj>* keep_obj = nullptr;  ///< of an OBJ file: gets what rewrite_obj_normals() needs
};

/// Reads a model file of any supported format; the content must match the format of the file name's ending.
/// @throws Error not_found, bad_file (with file and place; "nothing to draw" when it holds no drawable primitive).
Scene read_scene(const std::string& path, const ReadOptions& options, Context& context);
/// The same of a file that is in memory. @param path  where it would be: its ending, its folder, its name in messages
Scene read_scene(const std::string& path, Bytes bytes, const ReadOptions& options, Context& context);

/// Whether a name's ending is that of a model format which this build reads.
bool has_model_ending(const std::string& path);

/// What the lengths of a file are in, by its name's ending: "m", or "units" where the format has no unit of length.
const char* length_unit(const std::string& path);

/// The formats that this build reads, for --version and messages: "glTF 2.0, GLB, OBJ, FBX, ...".
std::string supported_formats();

}  // namespace rakelight::io
