// SPDX-License-Identifier: Apache-2.0
// The cameras of a Collada file, read from its text: Assimp 5.2 finds them but neither their angles nor their planes.
#pragma once
#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/import/stream_format.h"

namespace rakelight::io {

/// <optics> of one camera; absent what the file does not give.
struct ColladaOptics {
    std::optional<double> xfov_deg, yfov_deg, aspect, znear, zfar, xmag, ymag;
};

/// Optics by the id and by the name of the node that places the camera.
/// @throws Error bad_file: no well-formed XML
std::map<std::string, ColladaOptics> collada_cameras(std::span<const std::byte> bytes);

/// Puts what the file says into the views that Assimp left without.
void complete_views(const std::map<std::string, ColladaOptics>& cameras, std::vector<import_stream::View>& views);

}  // namespace rakelight::io
