// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/packed/meshopt.h"

#include <meshoptimizer.h>

#include "base/format_text.h"

namespace rakelight::io::gltf {
namespace {

enum class Mode { attributes, triangles, indices };

Mode mode_of(const Value& packed) {
    const std::string mode = packed.text("mode");
    if (mode == "ATTRIBUTES") return Mode::attributes;
    if (mode == "TRIANGLES") return Mode::triangles;
    if (mode == "INDICES") return Mode::indices;
    packed.fail("the meshopt mode '" + one_line(mode, 30) + "' is unknown");
}

/// The decoders assert on these sizes instead of returning an error.
void check_sizes(const Value& packed, Mode mode, std::uint64_t count, std::uint64_t stride, std::uint64_t data_bytes) {
    const bool fits =
        mode == Mode::attributes ? stride >= 4 && stride <= 256 && stride % 4 == 0 : stride == 2 || stride == 4;
    if (!fits) packed.fail(format_text("the meshopt byteStride {} does not fit its mode", stride));
    if (mode == Mode::triangles && count % 3 != 0)
        packed.fail(format_text("the meshopt count {} is not a multiple of 3", count));
    // The densest codes: triangles take a byte each, other indices per byte each, and attributes two bits for 16 bytes.
    const std::uint64_t most = mode == Mode::triangles ? 3 * data_bytes
                               : mode == Mode::indices ? data_bytes
                                                       : 64 * data_bytes / stride + 256;
    if (count > most)
        packed.fail(format_text("the meshopt count {} is more than {} compressed bytes can hold", count, data_bytes));
}

void apply_filter(const Value& packed, Mode mode, void* data, std::size_t count, std::size_t stride) {
    const std::string filter = packed.text("filter", "NONE");
    if (filter == "NONE") return;
    const bool fits = filter == "OCTAHEDRAL"   ? stride == 4 || stride == 8
                      : filter == "QUATERNION" ? stride == 8
                                               : filter == "EXPONENTIAL";
    if (!fits || mode != Mode::attributes)
        packed.fail("the meshopt filter '" + one_line(filter, 30) + "' is unknown or does not fit the byteStride");
    if (filter == "OCTAHEDRAL")
        meshopt_decodeFilterOct(data, count, stride);
    else if (filter == "QUATERNION")
        meshopt_decodeFilterQuat(data, count, stride);
    else
        meshopt_decodeFilterExp(data, count, stride);
}

}  // namespace

Bytes decode_meshopt(const Value& packed, std::span<const std::byte> data, Context& context) {
    const Mode mode = mode_of(packed);
    const std::uint64_t count = packed.required_count("count"), stride = packed.required_count("byteStride");
    check_sizes(packed, mode, count, stride, data.size());
    MemoryCharge charge(context.memory(), count * stride, "an unpacked buffer view");
    std::vector<std::byte> unpacked(std::size_t(count * stride));
    if (count == 0) return charged_bytes({}, {});
    const auto* source = reinterpret_cast<const unsigned char*>(data.data());
    const std::size_t n = std::size_t(count), size = std::size_t(stride);
    const int result =
        mode == Mode::attributes  ? meshopt_decodeVertexBuffer(unpacked.data(), n, size, source, data.size())
        : mode == Mode::triangles ? meshopt_decodeIndexBuffer(unpacked.data(), n, size, source, data.size())
                                  : meshopt_decodeIndexSequence(unpacked.data(), n, size, source, data.size());
    if (result != 0) packed.fail(format_text("its meshopt data is broken or of a newer version (code {})", result));
    apply_filter(packed, mode, unpacked.data(), n, size);
    return charged_bytes(std::move(unpacked), std::move(charge));
}

}  // namespace rakelight::io::gltf
