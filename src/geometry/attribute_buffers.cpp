// SPDX-License-Identifier: Apache-2.0
// compute_attributes_into(): output to the caller's buffers.
#include <string>

#include "base/format_text.h"
#include "geometry/fast/fast_attributes.h"
#include "geometry/general_attributes.h"

namespace rakelight {
namespace {

void check_buffers(std::span<const AttributeMesh> meshes, const AttributeOptions& options,
                   std::span<const AttributeBuffers> out) {
    if (out.size() != meshes.size())
        throw Error(ErrorCode::usage, format_text("{} buffers for {} meshes", out.size(), meshes.size()));
    for (std::size_t m = 0; m < meshes.size(); ++m) {
        const auto need = [&](std::size_t given, const char* what) {
            if (given >= meshes[m].positions.size()) return;
            throw Error(ErrorCode::usage,
                        format_text("room for {} {} of {} vertices", given, what, meshes[m].positions.size()),
                        format_text("mesh {}", m));
        };
        need(out[m].normals.size(), "normals");
        if (options.tangents && !meshes[m].texcoords.empty()) need(out[m].tangents.size(), "tangents");
    }
}

}  // namespace

struct AttributeWorkspace::Impl {
    geometry::FastScratch scratch;
    geometry::GeneralScratch general;
    Impl() { scratch.general.is_kept = general.is_kept = true; }
};

AttributeWorkspace::AttributeWorkspace() : impl_(std::make_unique<Impl>()) {}
AttributeWorkspace::AttributeWorkspace(AttributeWorkspace&&) noexcept = default;
AttributeWorkspace& AttributeWorkspace::operator=(AttributeWorkspace&&) noexcept = default;
AttributeWorkspace::~AttributeWorkspace() = default;
std::size_t AttributeWorkspace::bytes() const { return impl_ ? impl_->scratch.bytes() + impl_->general.bytes() : 0; }
AttributeWorkspace::Impl& AttributeWorkspace::impl() {
    if (!impl_) impl_ = std::make_unique<Impl>();
    return *impl_;
}

std::vector<SplitAttributes> compute_attributes_into(std::span<const AttributeMesh> meshes,
                                                     const AttributeOptions& options,
                                                     std::span<const AttributeBuffers> out,
                                                     AttributeWorkspace& workspace, Context& context) {
    geometry::check_options(options);
    check_buffers(meshes, options, out);
    if (geometry::takes_fast_path(meshes, options))
        return geometry::fast_attributes(meshes, options, out, workspace.impl().scratch, context);
    return geometry::general_attributes_into(meshes, options, out, workspace.impl().general, context);
}

}  // namespace rakelight
