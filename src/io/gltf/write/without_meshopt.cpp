// SPDX-License-Identifier: Apache-2.0
// Of a build without meshoptimizer (RAKELIGHT_MESHOPT=OFF): new data is not compressed.
#include <nlohmann/json.hpp>

#include "io/gltf/write/save_meshopt.h"

namespace rakelight::io::gltf {

std::vector<std::byte> compress(std::span<const std::byte>, std::size_t, bool, const std::string&, OrderedJson&,
                                OrderedJson&) {
    return {};
}

}  // namespace rakelight::io::gltf
