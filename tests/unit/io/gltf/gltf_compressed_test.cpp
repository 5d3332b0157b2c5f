// SPDX-License-Identifier: Apache-2.0
// Draco and meshopt data: what their own encoders wrote comes back, and what is damaged is refused.
#include <draco/compression/decode.h>
#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#include <meshoptimizer.h>

#include <random>
#include <set>

#include "io/gltf/packed/draco_header.h"
#include "unit/io/gltf/gltf_support.h"

namespace rakelight {
namespace {

using namespace test;
using Json = nlohmann::json;

/// A grid of n x n quads in z = 0 with its texture coordinates.
struct Grid {
    explicit Grid(std::uint32_t n) {
        for (std::uint32_t y = 0; y <= n; ++y)
            for (std::uint32_t x = 0; x <= n; ++x) positions.insert(positions.end(), {float(x), float(y), 0.0f});
        for (std::uint32_t y = 0; y < n; ++y)
            for (std::uint32_t x = 0; x < n; ++x) {
                const std::uint32_t v = y * (n + 1) + x;
                for (const std::uint32_t i : {v, v + 1, v + n + 2, v, v + n + 2, v + n + 1}) indices.push_back(i);
            }
    }
    std::vector<float> positions;
    std::vector<std::uint32_t> indices;
};

std::set<std::array<float, 9>> triangles_of(const std::vector<float>& p, std::span<const std::uint32_t> indices) {
    std::set<std::array<float, 9>> result;
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
        std::array<float, 9> best{};
        for (std::size_t turn = 0; turn < 3; ++turn) {  // the encoder may begin a triangle at any corner
            std::array<float, 9> t{};
            for (std::size_t c = 0; c < 9; ++c) t[c] = p[3 * indices[i + (turn + c / 3) % 3] + c % 3];
            if (turn == 0 || t < best) best = t;
        }
        result.insert(best);
    }
    return result;
}

std::set<std::array<float, 9>> triangles_of(const Mesh& mesh) {
    std::vector<float> p;
    for (const vec3& v : mesh.positions) p.insert(p.end(), {v.x, v.y, v.z});
    return triangles_of(p, mesh.indices.span());
}

std::vector<char> draco_encode(const Grid& grid, int method, int bits = -1) {
    draco::TriangleSoupMeshBuilder builder;
    builder.Start(int(grid.indices.size() / 3));
    const int id = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
    const auto at = [&](std::size_t k) { return &grid.positions[3 * grid.indices[k]]; };
    for (std::size_t f = 0; f < grid.indices.size() / 3; ++f)
        builder.SetAttributeValuesForFace(id, draco::FaceIndex(std::uint32_t(f)), at(3 * f), at(3 * f + 1),
                                          at(3 * f + 2));
    const auto mesh = builder.Finalize();
    draco::Encoder encoder;
    encoder.SetEncodingMethod(method);
    if (bits > 0) encoder.SetAttributeQuantization(draco::GeometryAttribute::POSITION, bits);
    draco::EncoderBuffer buffer;
    EXPECT_TRUE(encoder.EncodeMeshToBuffer(*mesh, &buffer).ok());
    return {buffer.data(), buffer.data() + buffer.size()};
}

GltfFile draco_file(const std::vector<char>& data, std::size_t vertices, std::size_t corners) {
    GltfFile file;
    file.root["accessors"] = {{{"componentType", f32}, {"count", vertices}, {"type", "VEC3"}},
                              {{"componentType", u32}, {"count", corners}, {"type", "SCALAR"}}};
    auto& primitive = file.primitive(0);
    primitive["indices"] = 1;
    primitive["extensions"]["KHR_draco_mesh_compression"] = {{"bufferView", file.view(data)},
                                                             {"attributes", {{"POSITION", 0}}}};
    file.root["extensionsUsed"] = {"KHR_draco_mesh_compression"};
    file.root["extensionsRequired"] = {"KHR_draco_mesh_compression"};
    return file;
}

TEST(GltfDraco, BothConnectivitiesComeBack) {
    const Grid grid(9);
    for (const int method : {int(draco::MESH_SEQUENTIAL_ENCODING), int(draco::MESH_EDGEBREAKER_ENCODING)}) {
        const auto data = draco_encode(grid, method);
        const Scene scene = draco_file(data, 100, 486).load();
        ASSERT_EQ(scene.meshes.size(), 1u);
        EXPECT_EQ(scene.meshes[0].positions.size(), 100u);
        EXPECT_EQ(triangles_of(scene.meshes[0]), triangles_of(grid.positions, grid.indices)) << method;
        const auto header = io::gltf::read_draco_header(std::as_bytes(std::span(data)));
        ASSERT_TRUE(header);
        EXPECT_EQ(header->faces, 162u);
        EXPECT_EQ(header->points, 100u);
    }
}

// The library's own decoding is the expected value: ours scales the codes back apart from it, to know the step.
TEST(GltfDraco, QuantizedPositionsAreThoseOfTheLibraryAndTellTheirStep) {
    const Grid grid(9);
    for (const int method : {int(draco::MESH_SEQUENTIAL_ENCODING), int(draco::MESH_EDGEBREAKER_ENCODING)})
        for (const int bits : {5, 11, 16}) {
            const auto data = draco_encode(grid, method, bits);
            draco::DecoderBuffer buffer;
            buffer.Init(data.data(), data.size());
            draco::Decoder decoder;
            const auto expected = std::move(decoder.DecodeMeshFromBuffer(&buffer)).value();
            const Mesh mesh = draco_file(data, 100, 486).load().meshes[0];
            ASSERT_EQ(mesh.positions.size(), expected->num_points());
            const draco::PointAttribute* p = expected->GetNamedAttribute(draco::GeometryAttribute::POSITION);
            for (std::uint32_t v = 0; v < expected->num_points(); ++v) {
                vec3 value;
                p->GetMappedValue(draco::PointIndex(v), &value);
                EXPECT_EQ(mesh.positions[v], value) << bits << " bits, vertex " << v;
            }
            EXPECT_NEAR(mesh.position_step, 9.0 / double((1 << bits) - 1), 1e-6);
        }
    EXPECT_EQ(draco_file(draco_encode(grid, draco::MESH_SEQUENTIAL_ENCODING), 100, 486).load().meshes[0].position_step,
              0);
}

TEST(GltfDraco, PositionsOfIntegersKeepTheirType) {
    draco::TriangleSoupMeshBuilder builder;
    builder.Start(1);
    const int id = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_INT16);
    const std::int16_t corners[3][3] = {{0, 0, -32768}, {32767, 0, 0}, {0, 5, 0}};
    builder.SetAttributeValuesForFace(id, draco::FaceIndex(0), corners[0], corners[1], corners[2]);
    const auto mesh = builder.Finalize();
    draco::Encoder encoder;
    draco::EncoderBuffer buffer;
    ASSERT_TRUE(encoder.EncodeMeshToBuffer(*mesh, &buffer).ok());
    GltfFile file = draco_file({buffer.data(), buffer.data() + buffer.size()}, 3, 3);
    file.root["accessors"][0]["componentType"] = i16;
    const Mesh loaded = file.load().meshes[0];
    std::set<std::array<float, 3>> positions;
    for (const vec3& p : loaded.positions) positions.insert({p.x, p.y, p.z});
    EXPECT_EQ(positions, (std::set<std::array<float, 3>>{{0, 0, -32768}, {32767, 0, 0}, {0, 5, 0}}));
    EXPECT_EQ(loaded.position_step, 1);
    file.root["accessors"][0]["componentType"] = i8;
    EXPECT_NE(file.refusal().find("beyond its accessor's type"), std::string::npos);
}

TEST(GltfDraco, DamagedDataNeverCrashes) {
    const Grid grid(5);
    std::mt19937 random(7);
    for (const int method : {int(draco::MESH_SEQUENTIAL_ENCODING), int(draco::MESH_EDGEBREAKER_ENCODING)}) {
        const auto whole = draco_encode(grid, method);
        for (int trial = 0; trial < 300; ++trial) {
            auto data = whole;
            if (trial % 3 == 0) data.resize(random() % whole.size());
            for (int k = 0; k < 2 && !data.empty(); ++k) data[random() % data.size()] = char(random());
            Context context({.threads = 1});
            try {
                for (const Mesh& mesh : draco_file(data, 36, 150).load(context).meshes)
                    for (const std::uint32_t i : mesh.indices) ASSERT_LT(i, mesh.positions.size());
            } catch (const Error&) {
            }
        }
    }
}

TEST(GltfDraco, CountsThatTheDataCannotHoldAreRefused) {
    auto data = draco_encode(Grid(2), draco::MESH_SEQUENTIAL_ENCODING);
    const char many[] = {char(0xFF), char(0xFF), char(0xFF), char(0x7F)};  // 2^28 - 1 faces
    data.erase(data.begin() + 11);
    data.insert(data.begin() + 11, many, many + 4);
    EXPECT_NE(draco_file(data, 9, 24).refusal().find("bytes can hold"), std::string::npos);
    data[5] = 1;
    EXPECT_NE(draco_file(data, 9, 24).refusal().find("version 1.2"), std::string::npos);
    EXPECT_NE(draco_file({'D', 'R', 'A', 'C', 'O'}, 9, 24).refusal().find("not a Draco mesh"), std::string::npos);
}

GltfFile meshopt_file(const Grid& grid, const char* extension) {
    const std::size_t vertices = grid.positions.size() / 3;
    std::vector<unsigned char> v(meshopt_encodeVertexBufferBound(vertices, 12)),
        i(meshopt_encodeIndexBufferBound(grid.indices.size(), vertices));
    v.resize(meshopt_encodeVertexBuffer(v.data(), v.size(), grid.positions.data(), vertices, 12));
    i.resize(meshopt_encodeIndexBuffer(i.data(), i.size(), grid.indices.data(), grid.indices.size()));
    GltfFile file;
    const auto packed = [&](const std::vector<unsigned char>& data, std::size_t count, std::size_t stride,
                            const char* mode) {
        const int view = file.view(data);
        Json& json = file.root["bufferViews"][view];
        json["extensions"][extension] = {{"buffer", 0},
                                         {"byteOffset", json["byteOffset"]},
                                         {"byteLength", data.size()},
                                         {"byteStride", stride},
                                         {"count", count},
                                         {"mode", mode}};
        json["buffer"] = 1;  // the fallback buffer, which is not there
        json["byteLength"] = count * stride;
        return view;
    };
    const int positions = packed(v, vertices, 12, "ATTRIBUTES"),
              indices = packed(i, grid.indices.size(), 4, "TRIANGLES");
    file.root["accessors"] = {
        {{"bufferView", positions}, {"componentType", f32}, {"count", vertices}, {"type", "VEC3"}},
        {{"bufferView", indices}, {"componentType", u32}, {"count", grid.indices.size()}, {"type", "SCALAR"}}};
    file.primitive(0)["indices"] = 1;
    file.root["extensionsUsed"] = {extension};
    file.root["extensionsRequired"] = {extension};
    return file;
}

TEST(GltfMeshopt, AttributesAndTrianglesComeBack) {
    const Grid grid(20);
    for (const char* extension : {"EXT_meshopt_compression", "KHR_meshopt_compression"}) {
        const Scene scene = meshopt_file(grid, extension).load();
        EXPECT_EQ(triangles_of(scene.meshes[0]), triangles_of(grid.positions, grid.indices));
        for (std::size_t v = 0; v < grid.positions.size() / 3; ++v)
            EXPECT_EQ(scene.meshes[0].positions[v].x, grid.positions[3 * v]);
    }
}

TEST(GltfMeshopt, WrongSizesAreRefused) {
    const Grid grid(3);
    const std::pair<const char*, Json> changes[] = {
        {"byteStride", 10}, {"byteStride", 0},        {"byteStride", 260}, {"count", 4294967296},
        {"mode", "MAGIC"},  {"filter", "OCTAHEDRAL"}, {"byteLength", 3},   {"filter", "SPIRAL"}};
    for (const auto& [name, value] : changes) {
        GltfFile file = meshopt_file(grid, "EXT_meshopt_compression");
        file.root["bufferViews"][0]["extensions"]["EXT_meshopt_compression"][name] = value;
        EXPECT_NE(file.refusal(), "") << name << " " << value;
    }
}

TEST(GltfMeshopt, FiltersAreApplied) {
    const float exact[8] = {0.5f, -2.0f, 1024.0f, 0.0f, 1.0f, -0.25f, 3.0f, 8.0f};
    std::vector<std::uint32_t> encoded(8);
    meshopt_encodeFilterExp(encoded.data(), 2, 16, 15, exact);
    std::vector<unsigned char> data(meshopt_encodeVertexBufferBound(2, 16));
    data.resize(meshopt_encodeVertexBuffer(data.data(), data.size(), encoded.data(), 2, 16));
    GltfFile file;
    const int view = file.view(data);
    file.root["bufferViews"][view]["extensions"]["EXT_meshopt_compression"] = {
        {"buffer", 0}, {"byteLength", data.size()}, {"byteStride", 16},
        {"count", 2},  {"mode", "ATTRIBUTES"},      {"filter", "EXPONENTIAL"}};
    file.root["bufferViews"][view]["byteStride"] = 16;
    file.root["accessors"] = {{{"bufferView", view}, {"componentType", f32}, {"count", 2}, {"type", "VEC3"}}};
    file.primitive(0)["mode"] = 0;
    const Scene scene = file.load();
    ASSERT_EQ(scene.meshes[0].topology, Topology::points);
    EXPECT_EQ(scene.meshes[0].positions[0], (vec3{0.5f, -2.0f, 1024.0f}));
    EXPECT_EQ(scene.meshes[0].positions[1], (vec3{1.0f, -0.25f, 3.0f}));
}

TEST(GltfMeshopt, DamagedDataNeverCrashes) {
    const Grid grid(8);
    std::mt19937 random(11);
    const GltfFile whole = meshopt_file(grid, "EXT_meshopt_compression");
    for (int trial = 0; trial < 300; ++trial) {
        GltfFile file = whole;
        for (int k = 0; k < 3; ++k) file.data[random() % file.data.size()] = char(random());
        try {
            for (const Mesh& mesh : file.load().meshes)
                for (const std::uint32_t i : mesh.indices) ASSERT_LT(i, mesh.positions.size());
        } catch (const Error&) {
        }
    }
}

}  // namespace
}  // namespace rakelight
