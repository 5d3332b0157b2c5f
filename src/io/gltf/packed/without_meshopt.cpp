// SPDX-License-Identifier: Apache-2.0
// Of a build without meshoptimizer (RAKELIGHT_MESHOPT=OFF): such files are not read, so none is written again either.
#include "base/left_out.h"

#include <nlohmann/json.hpp>
#include "io/gltf/packed/meshopt.h"
#include "io/gltf/write/save_meshopt.h"

namespace rakelight::io::gltf {

Bytes decode_meshopt(const Value& packed, std::span<const std::byte>, Context&) {
    throw left_out("a buffer is compressed by meshopt", "meshoptimizer", "RAKELIGHT_MESHOPT").at(packed.place());
}

std::string meshopt_extension(const OrderedJson&) { return {}; }
std::vector<std::byte> compress(std::span<const std::byte>, std::size_t, bool, const std::string&, OrderedJson&,
                                OrderedJson&) {
    return {};
}

}  // namespace rakelight::io::gltf
