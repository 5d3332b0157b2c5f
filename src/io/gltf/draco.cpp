// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/draco.h"

#include <draco/compression/decode.h>

#include <cstring>
#include <new>
#include <optional>
#include <stdexcept>

#include "io/gltf/draco_header.h"

namespace rakelight::io::gltf {
namespace {

/// What the library takes while it decodes (corner table, traversal, attributes), measured on real meshes and rounded
/// up.
constexpr std::uint64_t working_bytes_per_face = 64, working_bytes_per_point = 96;
/// Faces or points for which a byte of compressed data can stand; a regular grid under the valence code reaches about
/// 200.
constexpr std::uint64_t densest = 1024, slack = 65536;

std::optional<ComponentType> component_type(draco::DataType type) {
    switch (type) {
        case draco::DT_INT8:
            return ComponentType::i8;
        case draco::DT_UINT8:
            return ComponentType::u8;
        case draco::DT_INT16:
            return ComponentType::i16;
        case draco::DT_UINT16:
            return ComponentType::u16;
        case draco::DT_UINT32:
            return ComponentType::u32;
        case draco::DT_FLOAT32:
            return ComponentType::f32;
        default:
            return std::nullopt;
    }
}

void check_header(std::span<const std::byte> data, const Value& from, Context& context) {
    const auto header = read_draco_header(data);
    if (!header || !header->is_mesh) from.fail("its Draco data is no Draco mesh");
    if (header->major != 2 || header->minor != 2)
        from.fail("its Draco data has version " + std::to_string(header->major) + "." + std::to_string(header->minor) +
                  "; glTF allows 2.2 only");
    const std::uint64_t most = densest * data.size() + slack;
    if (header->faces > most || header->points > most)
        from.fail("its Draco data announces " + std::to_string(header->faces) + " triangles and " +
                  std::to_string(header->points) + " vertices, more than " + std::to_string(data.size()) +
                  " bytes can hold");
    context.memory().check(header->faces * working_bytes_per_face + header->points * working_bytes_per_point,
                           "decoding a Draco mesh");
}

}  // namespace

struct DracoMesh::Impl {
    std::unique_ptr<draco::Mesh> mesh;
};

DracoMesh::DracoMesh(std::span<const std::byte> data, const Value& from, Context& context)
    : impl_(std::make_unique<Impl>()) {
    check_header(data, from, context);
    try {
        draco::DecoderBuffer buffer;
        buffer.Init(reinterpret_cast<const char*>(data.data()), data.size());
        draco::Decoder decoder;
        auto result = decoder.DecodeMeshFromBuffer(&buffer);
        if (!result.ok()) from.fail("its Draco data is broken: " + result.status().error_msg_string());
        impl_->mesh = std::move(result).value();
    } catch (const std::bad_alloc&) {
        from.fail("its Draco data asks for more memory than there is");
    } catch (const std::length_error&) {
        from.fail("its Draco data asks for more memory than there is");
    }
    if (!impl_->mesh) from.fail("its Draco data holds no mesh");
    for (draco::FaceIndex f(0); f < impl_->mesh->num_faces(); ++f)
        for (const draco::PointIndex& corner : impl_->mesh->face(f))
            if (corner.value() >= impl_->mesh->num_points())
                from.fail("its Draco data has a corner " + std::to_string(corner.value()) + " of " +
                          std::to_string(impl_->mesh->num_points()) + " vertices");
}

DracoMesh::~DracoMesh() = default;

std::uint64_t DracoMesh::vertex_count() const { return impl_->mesh->num_points(); }

std::vector<std::uint32_t> DracoMesh::indices() const {
    std::vector<std::uint32_t> result;
    result.reserve(std::size_t(impl_->mesh->num_faces()) * 3);
    for (draco::FaceIndex f(0); f < impl_->mesh->num_faces(); ++f)
        for (const draco::PointIndex& corner : impl_->mesh->face(f)) result.push_back(corner.value());
    return result;
}

Elements DracoMesh::attribute(std::uint32_t id, const Elements& description, const Value& from,
                              Context& context) const {
    const draco::PointAttribute* attribute = impl_->mesh->GetAttributeByUniqueId(id);
    if (!attribute) from.fail("its Draco data has no attribute " + std::to_string(id));
    const auto type = component_type(attribute->data_type());
    const std::uint32_t width = std::uint32_t(attribute->num_components());
    if (!type || width != description.components)
        from.fail("Draco attribute " + std::to_string(id) + " has another type than its accessor");
    Elements elements = description;
    elements.type = *type;
    elements.count = vertex_count();
    elements.stride = elements.element_bytes();
    const std::uint64_t bytes = elements.element_bytes(), step = std::uint64_t(attribute->byte_stride());
    context.memory().charge(elements.count * bytes, "a Draco attribute");
    auto packed = std::make_shared<std::vector<std::byte>>(std::size_t(elements.count * bytes));
    const draco::DataBuffer* values = attribute->buffer();
    const std::uint64_t start = std::uint64_t(attribute->byte_offset());
    for (draco::PointIndex p(0); p < impl_->mesh->num_points(); ++p) {
        const std::uint64_t value = attribute->mapped_index(p).value();
        if (!values || step < bytes || value >= attribute->size() || start + value * step + bytes > values->data_size())
            from.fail("Draco attribute " + std::to_string(id) + " has no value for vertex " +
                      std::to_string(p.value()));
        std::memcpy(packed->data() + p.value() * bytes, values->data() + start + value * step, std::size_t(bytes));
    }
    elements.data = packed->data();
    elements.owner = packed;
    return elements;
}

}  // namespace rakelight::io::gltf
