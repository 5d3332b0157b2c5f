// SPDX-License-Identifier: Apache-2.0
// The format of the model's file.
#pragma once
#include <assimp/types.h>

#include <string>

#include <rakelight_internal/base/file_ending.h>

#include "io/import/stream_format.h"

namespace rakelight::import_helper {

using namespace io::import_stream;

/// What the ending of the file's name says about what Assimp's reader of that format does.
struct Format {
    std::string ending;          ///< lower case, without the dot
    bool file_normals = false;   ///< normals are the file's (FBX, DAE, X)
    bool hint_normals = false;   ///< normals were made from smoothing groups (3DS, ASE)
    bool max_placement = false;  ///< texture placement is 3ds Max's
};

inline Format format_of(const std::string& path) {
    Format format;
    format.ending = file_ending(path);
    const std::string& e = format.ending;
    format.file_normals = e == "fbx" || e == "dae" || e == "x";
    format.hint_normals = e == "3ds" || e == "ase";
    format.max_placement = format.hint_normals;
    return format;
}

inline std::string text(const aiString& s) {
    const std::size_t size = s.length < sizeof s.data ? s.length : sizeof s.data - 1;
    return std::string(s.data, size);
}

}  // namespace rakelight::import_helper
