// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/packed/meshopt.h"

#include "base/format_text.h"
#include "io/gltf/packed/meshopt_codec.h"

namespace rakelight::io::gltf {
namespace {

MeshoptMode mode_of(const Value& packed) {
    const std::string mode = packed.text("mode");
    if (mode == "ATTRIBUTES") return MeshoptMode::attributes;
    if (mode == "TRIANGLES") return MeshoptMode::triangles;
    if (mode == "INDICES") return MeshoptMode::indices;
    packed.fail("the meshopt mode '" + one_line(mode, 30) + "' is unknown");
}

/// The decoders assert on these sizes instead of returning an error.
void check_sizes(const Value& packed, MeshoptMode mode, std::uint64_t count, std::uint64_t stride,
                 std::uint64_t data_bytes) {
    const bool fits =
        mode == MeshoptMode::attributes ? stride >= 4 && stride <= 256 && stride % 4 == 0 : stride == 2 || stride == 4;
    if (!fits) packed.fail(format_text("the meshopt byteStride {} does not fit its mode", stride));
    if (mode == MeshoptMode::triangles && count % 3 != 0)
        packed.fail(format_text("the meshopt count {} is not a multiple of 3", count));
    // The densest codes: triangles take a byte each, other indices per byte each, and attributes two bits for 16 bytes.
    const std::uint64_t most = mode == MeshoptMode::triangles ? 3 * data_bytes
                               : mode == MeshoptMode::indices ? data_bytes
                                                              : 64 * data_bytes / stride + 256;
    if (count > most)
        packed.fail(format_text("the meshopt count {} is more than {} compressed bytes can hold", count, data_bytes));
}

MeshoptFilter filter_of(const Value& packed, MeshoptMode mode, std::uint64_t stride) {
    const std::string filter = packed.text("filter", "NONE");
    if (filter == "NONE") return MeshoptFilter::none;
    const bool is_attribute = mode == MeshoptMode::attributes;
    if (is_attribute && filter == "OCTAHEDRAL" && (stride == 4 || stride == 8)) return MeshoptFilter::octahedral;
    if (is_attribute && filter == "QUATERNION" && stride == 8) return MeshoptFilter::quaternion;
    if (is_attribute && filter == "EXPONENTIAL") return MeshoptFilter::exponential;
    packed.fail("the meshopt filter '" + one_line(filter, 30) + "' is unknown or does not fit the byteStride");
}

}  // namespace

Bytes decode_meshopt(const Value& packed, std::span<const std::byte> data, Context& context) {
    const MeshoptMode mode = mode_of(packed);
    const std::uint64_t count = packed.required_count("count"), stride = packed.required_count("byteStride");
    check_sizes(packed, mode, count, stride, data.size());
    const MeshoptFilter filter = filter_of(packed, mode, stride);
    if (count == 0) return charged_bytes({}, {});
    MemoryCharge charge(context.memory(), count * stride, "an unpacked buffer view");
    std::vector<std::byte> unpacked(std::size_t(count * stride));
    const MeshoptJob job{mode, filter, std::size_t(count), std::size_t(stride), data, unpacked};
    int code = 0;
    try {
        code = unpack_meshopt(job);
    } catch (const Error& error) {
        throw error.at(packed.place());
    }
    if (code != 0) packed.fail(format_text("its meshopt data is broken or of a newer version (code {})", code));
    return charged_bytes(std::move(unpacked), std::move(charge));
}

}  // namespace rakelight::io::gltf
