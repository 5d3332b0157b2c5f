// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/plausibility.h"

namespace rakelight::io::gltf {

void remark_on_quantization(const Document& document, const Accessors& accessors, const Value& primitive) {
    if (document.uses_quantization()) return;
    const Value attributes = primitive.object("attributes");
    for (const char* name : {"POSITION", "NORMAL", "TANGENT"}) {
        const std::uint32_t accessor = attributes.index(name);
        if (accessor == no_index) continue;
        const Elements elements = accessors.description(accessor, {name, ~0u, ~0u}, primitive);
        if (elements.type != ComponentType::f32)
            document.remark(Remark::warning, primitive.place(),
                            std::string(name) + " has integers though the file does not use KHR_mesh_quantization");
    }
}

}  // namespace rakelight::io::gltf
