// SPDX-License-Identifier: Apache-2.0
// What stays of an OBJ file that was read and is to be written back with other normals.
#pragma once
#include <memory>

#include "io/files/file.h"
#include "io/files/plain_text.h"
#include "io/obj/obj_faces.h"

namespace rakelight::io {

struct KeptObj {
    Bytes bytes;
    std::shared_ptr<const PlainText> text;  ///< of `bytes`
    obj::Contents contents;
    obj::VertexData data;    ///< the normals alone
    obj::Elements elements;  ///< with their chunks; the meshes' arrays are in the scene
};

}  // namespace rakelight::io
