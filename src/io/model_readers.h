// SPDX-License-Identifier: Apache-2.0
// The readers of model files. Each is one constant, which the source of the reader defines; the table in reader.cpp says which
// endings it gets.
#pragma once
#include <string>

#include "io/reader.h"

namespace rakelight::io {

/// The scenes are not yet validated. @throws Error bad_file; read() also not_found; with the file's name
struct ModelReader {
    /// A file that is in memory. @param path  where it would be
    Scene (*read_bytes)(const std::string& path, Bytes bytes, const ReadOptions& options, Context& context);
    /// Null: as its bytes.
    Scene (*read_file)(const std::string& path, const ReadOptions& options, Context& context) = nullptr;

    Scene read(const std::string& path, const ReadOptions& options, Context& context) const {
        return read_file ? read_file(path, options, context)
                         : read_bytes(path, io::read_file(path, context), options, context);
    }
};
extern const ModelReader gltf_reader;  ///< glTF and GLB
extern const ModelReader obj_reader;   ///< OBJ with MTL
extern const ModelReader ply_reader, off_reader, stl_reader;
extern const ModelReader xyz_reader;  ///< XYZ and PTS
/// FBX, DAE, 3DS, ASE, Blend, X through the helper executable `rakelight-import` (Assimp), found beside the running
/// program or by RAKELIGHT_IMPORT; limited in memory and time. The helper reads files: bytes in memory go into a temporary
/// one.
extern const ModelReader import_reader;

}  // namespace rakelight::io
