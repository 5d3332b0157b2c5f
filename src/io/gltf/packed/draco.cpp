// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/packed/draco.h"

#include <draco/attributes/attribute_quantization_transform.h>
#include <draco/compression/decode.h>

#include <cmath>
#include <cstring>
#include <map>
#include <new>
#include <optional>
#include <stdexcept>

#include "base/format_text.h"
#include "io/files/file.h"
#include "io/gltf/packed/draco_header.h"

namespace rakelight::io::gltf {
namespace {

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
        case draco::DT_INT32:  // how positions of integers come out, see narrow()
            return ComponentType::u32;
        case draco::DT_FLOAT32:
            return ComponentType::f32;
        default:
            return std::nullopt;
    }
}

template <class T>
void narrow_to(std::vector<std::byte>& bytes, const Value& from) {
    const std::size_t count = bytes.size() / sizeof(std::int32_t);
    for (std::size_t i = 0; i < count; ++i) {
        std::int32_t wide;
        std::memcpy(&wide, bytes.data() + i * sizeof wide, sizeof wide);
        const T value = T(wide);
        if (std::int32_t(value) != wide) from.fail("its Draco data has a position beyond its accessor's type");
        std::memcpy(bytes.data() + i * sizeof value, &value, sizeof value);  // never past what was read
    }
    bytes.resize(count * sizeof(T));
}

/// Integers of 32 bits, as the library holds them before it gives them their own type again, to the accessor's type.
void narrow(std::vector<std::byte>& bytes, ComponentType type, const Value& from) {
    switch (type) {
        case ComponentType::i8:
            return narrow_to<std::int8_t>(bytes, from);
        case ComponentType::u8:
            return narrow_to<std::uint8_t>(bytes, from);
        case ComponentType::i16:
            return narrow_to<std::int16_t>(bytes, from);
        case ComponentType::u16:
            return narrow_to<std::uint16_t>(bytes, from);
        default:
            from.fail("its Draco data has positions of another type than their accessor");
    }
}

struct DecodedMesh final : DracoMesh {
    std::uint64_t vertex_count() const override { return mesh->num_points(); }
    std::vector<std::uint32_t> indices() const override;
    Elements attribute(std::uint32_t id, const Elements& description, const Value& from,
                       Context& context) const override;
    double step(std::uint32_t id) const override;
    void dequantize(int id, const Value& from);

    std::unique_ptr<draco::Mesh> mesh;
    std::map<std::uint32_t, double> steps;  ///< by unique id, of quantized positions
};

/// The library would do this itself, but then it forgets the step.
void DecodedMesh::dequantize(int id, const Value& from) {
    const draco::PointAttribute* codes = mesh->attribute(id);
    const draco::AttributeTransformData* data = codes->GetAttributeTransformData();
    if (!data || data->transform_type() != draco::ATTRIBUTE_QUANTIZATION_TRANSFORM) return;
    draco::AttributeQuantizationTransform transform;
    const int width = codes->num_components();
    if (codes->data_type() != draco::DT_INT32 || !transform.InitFromAttribute(*codes) ||
        transform.min_values().size() < std::size_t(width) || transform.quantization_bits() < 1 ||
        transform.quantization_bits() > 30)
        from.fail("its Draco data has positions without their quantization");
    draco::GeometryAttribute shape;
    shape.Init(codes->attribute_type(), nullptr, std::uint8_t(width), draco::DT_FLOAT32, false,
               width * std::int64_t(sizeof(float)), 0);
    auto values = std::make_unique<draco::PointAttribute>(shape);
    if (!values->Reset(codes->size())) from.fail("its Draco data asks for more memory than there is");
    if (codes->is_mapping_identity()) {
        values->SetIdentityMapping();
    } else {
        values->SetExplicitMapping(mesh->num_points());
        for (draco::PointIndex p(0); p < mesh->num_points(); ++p) values->SetPointMapEntry(p, codes->mapped_index(p));
    }
    if (!transform.InverseTransformAttribute(*codes, values.get()))
        from.fail("its Draco data has positions that cannot be scaled back");
    const std::uint32_t unique_id = codes->unique_id();
    const double step = double(transform.range()) / double((1u << transform.quantization_bits()) - 1);
    if (std::isfinite(step) && step > 0) steps[unique_id] = step;
    mesh->SetAttribute(id, std::move(values));
    mesh->attribute(id)->set_unique_id(unique_id);
}

std::vector<std::uint32_t> DecodedMesh::indices() const {
    std::vector<std::uint32_t> result;
    result.reserve(std::size_t(mesh->num_faces()) * 3);
    for (draco::FaceIndex f(0); f < mesh->num_faces(); ++f)
        for (const draco::PointIndex& corner : mesh->face(f)) result.push_back(corner.value());
    return result;
}

double DecodedMesh::step(std::uint32_t id) const {
    const auto known = steps.find(id);
    return known == steps.end() ? 0 : known->second;
}

Elements DecodedMesh::attribute(std::uint32_t id, const Elements& description, const Value& from,
                                Context& context) const {
    const draco::PointAttribute* attribute = mesh->GetAttributeByUniqueId(id);
    if (!attribute) from.fail("its Draco data has no attribute " + std::to_string(id));
    const auto type = component_type(attribute->data_type());
    const std::uint32_t width = std::uint32_t(attribute->num_components());
    if (!type || width != description.components)
        from.fail(format_text("Draco attribute {} has another type than its accessor", id));
    Elements elements = description;
    elements.type = *type;
    elements.count = vertex_count();
    elements.stride = elements.element_bytes();
    const std::uint64_t bytes = elements.element_bytes(), step = std::uint64_t(attribute->byte_stride());
    MemoryCharge charge(context.memory(), elements.count * bytes, "a Draco attribute");
    std::vector<std::byte> packed(std::size_t(elements.count * bytes));
    const draco::DataBuffer* values = attribute->buffer();
    const std::uint64_t start = std::uint64_t(attribute->byte_offset());
    for (draco::PointIndex p(0); p < mesh->num_points(); ++p) {
        const std::uint64_t value = attribute->mapped_index(p).value();
        if (!values || step < bytes || value >= attribute->size() || start + value * step + bytes > values->data_size())
            from.fail(format_text("Draco attribute {} has no value for vertex {}", id, p.value()));
        std::memcpy(packed.data() + p.value() * bytes, values->data() + start + value * step, std::size_t(bytes));
    }
    if (attribute->data_type() == draco::DT_INT32) {
        narrow(packed, description.type, from);
        elements.type = description.type;
        elements.stride = elements.element_bytes();
    }
    const Bytes values_of_all = charged_bytes(std::move(packed), std::move(charge));
    elements.data = values_of_all->data();
    elements.owner = values_of_all;
    return elements;
}

}  // namespace

std::unique_ptr<DracoMesh> decode_draco(std::span<const std::byte> data, const Value& from, Context& context) {
    auto decoded = std::make_unique<DecodedMesh>();
    check_draco_header(data, from, context);
    try {
        draco::DecoderBuffer buffer;
        buffer.Init(reinterpret_cast<const char*>(data.data()), data.size());
        draco::Decoder decoder;
        decoder.SetSkipAttributeTransform(draco::GeometryAttribute::POSITION);
        auto result = decoder.DecodeMeshFromBuffer(&buffer);
        if (!result.ok()) from.fail("its Draco data is broken: " + result.status().error_msg_string());
        decoded->mesh = std::move(result).value();
        for (int a = 0; decoded->mesh && a < decoded->mesh->num_attributes(); ++a)
            if (decoded->mesh->attribute(a)->attribute_type() == draco::GeometryAttribute::POSITION)
                decoded->dequantize(a, from);
    } catch (const std::bad_alloc&) {
        from.fail("its Draco data asks for more memory than there is");
    } catch (const std::length_error&) {
        from.fail("its Draco data asks for more memory than there is");
    }
    if (!decoded->mesh) from.fail("its Draco data holds no mesh");
    for (draco::FaceIndex f(0); f < decoded->mesh->num_faces(); ++f)
        for (const draco::PointIndex& corner : decoded->mesh->face(f))
            if (corner.value() >= decoded->mesh->num_points())
                from.fail(format_text("its Draco data has a corner {} of {} vertices", corner.value(),
                                      decoded->mesh->num_points()));
    return decoded;
}

}  // namespace rakelight::io::gltf
