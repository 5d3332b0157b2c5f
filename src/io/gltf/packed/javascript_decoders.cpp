// SPDX-License-Identifier: Apache-2.0
// Of the web build: Draco and meshopt are unpacked by decoders that JavaScript passes as Module.decoders, { meshopt, draco }:
// MeshoptDecoder of the npm package meshoptimizer, and what createDecoderModule() of draco3dgltf makes.
#include <emscripten.h>

#include "base/format_text.h"
#include "io/files/file.h"
#include "io/gltf/packed/draco.h"
#include "io/gltf/packed/draco_header.h"
#include "io/gltf/packed/meshopt_codec.h"

// clang-format off
EM_JS(int, rl_unpack_meshopt, (void* out, int count, int stride, const void* data, int bytes, int mode, int filter), {
    const decoder = Module.decoders && Module.decoders.meshopt;
    if (!decoder) { Module.missingDecoder = 'meshopt'; return -1000; }
    const at = (pointer, size) => HEAPU8.subarray(pointer >>> 0, (pointer >>> 0) + size);
    try {
        decoder.decodeGltfBuffer(at(out, count * stride), count, stride, at(data, bytes), ['ATTRIBUTES', 'TRIANGLES', 'INDICES'][mode],
                                 ['NONE', 'OCTAHEDRAL', 'QUATERNION', 'EXPONENTIAL'][filter]);
        return 0;
    } catch (fault) {
        return -1;
    }
});

// Decodes twice, since only codes that are not yet scaled back tell their step. Returns a number for the functions below;
// 0: broken, -1: no decoder.
EM_JS(int, rl_open_draco, (const void* data, int bytes, int* counts), {
    const draco = Module.decoders && Module.decoders.draco;
    if (!draco) { Module.missingDecoder = 'draco'; return -1; }
    const packed = new Int8Array(HEAPU8.buffer, data >>> 0, bytes), made = [];
    const keep = object => { made.push(object); return object; };
    const decode = isScaled => {
        const decoder = keep(new draco.Decoder()), mesh = keep(new draco.Mesh()), buffer = new draco.DecoderBuffer();
        try {
            if (!isScaled) decoder.SkipAttributeTransform(draco.POSITION);
            buffer.Init(packed, bytes);
            if (!decoder.DecodeBufferToMesh(buffer, mesh).ok()) throw new Error('broken');
            return { decoder, mesh };
        } finally {
            draco.destroy(buffer);
        }
    };
    try {
        const { decoder, mesh } = decode(true), codes = decode(false);
        HEAP32[counts >>> 2] = mesh.num_points();
        HEAP32[(counts >>> 2) + 1] = mesh.num_faces();
        const meshes = Module.dracoMeshes || (Module.dracoMeshes = []);
        return meshes.push({ decoder, mesh, codes, made });
    } catch (fault) {
        for (const each of made) draco.destroy(each);
        return 0;
    }
});

EM_JS(void, rl_close_draco, (int number), {
    for (const each of Module.dracoMeshes[number - 1].made) Module.decoders.draco.destroy(each);
    Module.dracoMeshes[number - 1] = null;
});

EM_JS(void, rl_draco_indices, (int number, void* out, int bytes), {
    const draco = Module.decoders.draco, { decoder, mesh } = Module.dracoMeshes[number - 1];
    const room = draco._malloc(bytes);
    decoder.GetTrianglesUInt32Array(mesh, bytes, room);
    HEAPU8.set(new Uint8Array(draco.HEAPF32.buffer, room, bytes), out >>> 0);
    draco._free(room);
});

// Draco's number of the type, and the number of components; false: no such attribute.
EM_JS(int, rl_draco_attribute, (int number, int id, int* shape), {
    const { decoder, mesh } = Module.dracoMeshes[number - 1], attribute = decoder.GetAttributeByUniqueId(mesh, id);
    if (!attribute.ptr) return 0;
    HEAP32[shape >>> 2] = attribute.data_type();
    HEAP32[(shape >>> 2) + 1] = attribute.num_components();
    return 1;
});

EM_JS(int, rl_draco_values, (int number, int id, int type, void* out, int bytes), {
    const draco = Module.decoders.draco, { decoder, mesh } = Module.dracoMeshes[number - 1];
    const room = draco._malloc(bytes);
    const isDone = decoder.GetAttributeDataArrayForAllPoints(mesh, decoder.GetAttributeByUniqueId(mesh, id), type, bytes, room);
    if (isDone) HEAPU8.set(new Uint8Array(draco.HEAPF32.buffer, room, bytes), out >>> 0);
    draco._free(room);
    return isDone ? 1 : 0;
});

EM_JS(double, rl_draco_step, (int number, int id), {
    const draco = Module.decoders.draco, { decoder, mesh } = Module.dracoMeshes[number - 1].codes;
    const attribute = decoder.GetAttributeByUniqueId(mesh, id);
    if (!attribute.ptr || attribute.attribute_type() !== draco.POSITION) return 0;
    const transform = new draco.AttributeQuantizationTransform();
    const step = transform.InitFromAttribute(attribute) ? transform.range() / (2 ** transform.quantization_bits() - 1) : 0;
    draco.destroy(transform);
    return step > 0 && Number.isFinite(step) ? step : 0;
});
// clang-format on

namespace rakelight::io::gltf {
namespace {

constexpr int no_decoder = -1000, draco_int32 = 5;

Error missing(const char* what, const char* name) {
    return Error(ErrorCode::bad_file, std::string(what) + ", and no decoder was passed", {},
                 std::string("install the npm package ") + name);
}

/// Draco's number of a type; 0: none.
int draco_type(ComponentType type) {
    switch (type) {
        case ComponentType::i8:
            return 1;
        case ComponentType::u8:
            return 2;
        case ComponentType::i16:
            return 3;
        case ComponentType::u16:
            return 4;
        case ComponentType::u32:
            return 6;
        case ComponentType::f32:
            return 9;
    }
    return 0;
}

std::optional<ComponentType> type_of(int draco) {
    for (const ComponentType type : {ComponentType::i8, ComponentType::u8, ComponentType::i16, ComponentType::u16,
                                     ComponentType::u32, ComponentType::f32})
        if (draco_type(type) == draco) return type;
    return std::nullopt;
}

class JavaScriptMesh final : public DracoMesh {
public:
    JavaScriptMesh(int number, int points, int faces) : number_(number), points_(points), faces_(faces) {}
    ~JavaScriptMesh() override { rl_close_draco(number_); }
    std::uint64_t vertex_count() const override { return std::uint64_t(points_); }
    double step(std::uint32_t id) const override { return rl_draco_step(number_, int(id)); }

    std::vector<std::uint32_t> indices() const override {
        std::vector<std::uint32_t> result(3 * std::size_t(faces_));
        rl_draco_indices(number_, result.data(), int(4 * result.size()));
        return result;
    }

    Elements attribute(std::uint32_t id, const Elements& description, const Value& from,
                       Context& context) const override {
        int shape[2];
        if (!rl_draco_attribute(number_, int(id), shape))
            from.fail("its Draco data has no attribute " + std::to_string(id));
        const auto type = shape[0] == draco_int32 ? description.type : type_of(shape[0]);
        if (!type || shape[1] != int(description.components))
            from.fail(format_text("Draco attribute {} has another type than its accessor", id));
        Elements elements = description;
        elements.type = *type;
        elements.count = vertex_count();
        elements.stride = elements.element_bytes();
        const std::uint64_t bytes = elements.count * elements.stride;
        MemoryCharge charge(context.memory(), bytes, "a Draco attribute");
        std::vector<std::byte> values(std::size_t(bytes), std::byte{});
        if (!rl_draco_values(number_, int(id), draco_type(*type), values.data(), int(bytes)))
            from.fail(format_text("Draco attribute {} has no value for each vertex", id));
        const Bytes kept = charged_bytes(std::move(values), std::move(charge));
        elements.data = kept->data();
        elements.owner = kept;
        return elements;
    }

private:
    int number_, points_, faces_;
};

}  // namespace

int unpack_meshopt(const MeshoptJob& job) {
    const int code = rl_unpack_meshopt(job.out.data(), int(job.count), int(job.stride), job.data.data(),
                                       int(job.data.size()), int(job.mode), int(job.filter));
    if (code == no_decoder) throw missing("a buffer is compressed by meshopt", "meshoptimizer");
    return code;
}

std::unique_ptr<DracoMesh> decode_draco(std::span<const std::byte> data, const Value& from, Context& context) {
    check_draco_header(data, from, context);
    int counts[2];
    const int number = rl_open_draco(data.data(), int(data.size()), counts);
    if (number < 0) throw missing("a mesh is compressed by Draco", "draco3dgltf").at(from.place());
    if (number == 0) from.fail("its Draco data is broken");
    auto mesh = std::make_unique<JavaScriptMesh>(number, counts[0], counts[1]);
    for (const std::uint32_t corner : mesh->indices())
        if (corner >= mesh->vertex_count())
            from.fail(format_text("its Draco data has a corner {} of {} vertices", corner, mesh->vertex_count()));
    return mesh;
}

}  // namespace rakelight::io::gltf
