// SPDX-License-Identifier: Apache-2.0
// Fuzz target: the look at a model file before the import helper gets it. The first byte chooses the format.
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "io/import/precheck.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static constexpr std::array<const char*, 9> endings = {"stl", "ply", "off", "3ds", "ase", "blend", "dae", "fbx", "x"};
    if (size == 0) return 0;
    rakelight::Report report;
    const std::string path = "model";
    try {
        rakelight::io::check_before_import(endings[data[0] % endings.size()], {std::as_bytes(std::span(data + 1, size - 1)), path, report});
    } catch (const rakelight::Error&) {
    }
    return 0;
}
