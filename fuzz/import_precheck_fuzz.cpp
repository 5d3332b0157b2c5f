// SPDX-License-Identifier: Apache-2.0
// Fuzz target: the look at a model file before the import helper gets it, in every format, so that any model is a seed.
// Besides Error nothing may come out.
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "io/import/collada_cameras.h"
#include "io/import/precheck.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace rakelight;
    const std::string path = "model";
    for (const char* ending : {"3ds", "ase", "blend", "dae", "fbx", "x"}) {
        Report report;
        try {
            io::check_before_import(ending, {std::as_bytes(std::span(data, size)), path, report});
        } catch (const Error&) {
        }
    }
    try {
        io::collada_cameras(std::as_bytes(std::span(data, size)));
    } catch (const Error&) {  // no well-formed XML
    }
    return 0;
}
