// SPDX-License-Identifier: Apache-2.0
// The stream of the helper: what is written is read, and no lie about a count or an index gets through.
#include <gtest/gtest.h>

#include <cstring>

#include "io/import/stream_reader.h"
#include "io/import/stream_writer.h"

namespace rakelight::io::import_stream {
namespace {

Part quad() {
    Part p;
    p.name = "quad";
    p.surface = 0;
    p.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    p.indices = {0, 1, 2, 0, 2, 3};
    p.normals.assign(4, {0, 0, 1});
    p.texcoords = {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
    p.smoothing_hint.assign(6, {0, 0, 1});
    p.smoothing = {1, 2};
    p.polygons.assign(2, 0);
    p.influences.resize(4);
    p.influences[0].weights[0] = 1;
    p.shapes.push_back({"smile", std::vector<vec3>(4), {}});
    return p;
}

Document document() {
    Document d;
    d.part_count = 1;
    d.surfaces.push_back({.name = "red", .has = Surface::has_diffuse, .diffuse = {1, 0, 0}});
    d.surfaces[0].links.push_back({.path = "a.png", .role = std::uint32_t(Role::normal)});
    d.pictures.push_back({"p", "png", 0, 0, {1, 2, 3}});
    d.places.push_back({.name = "root", .meshes = {0}});
    d.places.push_back({.name = "child", .parent = 0});
    d.lamps.push_back({.name = "lamp", .node = 1, .type = 3});
    d.views.push_back({.name = "view", .node = nothing});
    d.joints.push_back({1, {}});
    d.motions.push_back({"wave", {{1, 1, {0, 1}, {0, 0, 0, 1, 0, 0, 0, 1}}}});
    d.notes.push_back({2, "here", "there"});
    return d;
}

std::vector<std::byte> written(Document d, std::vector<Part> parts, std::uint64_t mark = end_mark) {
    std::vector<std::byte> out;
    Writer writer([&out](std::span<const std::byte> b) { out.insert(out.end(), b.begin(), b.end()); });
    writer.value(Head{magic, version, std::uint32_t(Kind::scene)});
    transfer(writer, d);
    for (Part& p : parts) transfer(writer, p);
    writer.value(mark);
    return out;
}

Import read(std::span<const std::byte> bytes) {
    Context context({.threads = 1, .max_memory = 1 << 20});
    MemorySource source(bytes);
    return read_import(source, context);
}

template <class Change>
void expect_refused(const char* what, Change change) {
    SCOPED_TRACE(what);
    Document d = document();
    std::vector<Part> parts{quad()};
    change(d, parts[0]);
    EXPECT_THROW(read(written(d, parts)), Error);
}

TEST(ImportStream, WhatIsWrittenIsRead) {
    const Import got = read(written(document(), {quad()}));
    ASSERT_EQ(got.parts.size(), 1u);
    const Part want = quad();
    EXPECT_EQ(got.parts[0].name, "quad");
    EXPECT_EQ(got.parts[0].positions, want.positions);
    EXPECT_EQ(got.parts[0].indices, want.indices);
    EXPECT_EQ(got.parts[0].texcoords, want.texcoords);
    EXPECT_EQ(got.parts[0].smoothing_hint, want.smoothing_hint);
    EXPECT_EQ(got.parts[0].smoothing, want.smoothing);
    EXPECT_EQ(got.parts[0].polygons, want.polygons);
    EXPECT_EQ(got.parts[0].shapes[0].name, "smile");
    EXPECT_EQ(got.document.surfaces[0].links[0].path, "a.png");
    EXPECT_EQ(got.document.places[1].parent, 0u);
    EXPECT_EQ(got.document.motions[0].tracks[0].values.size(), 8u);
    EXPECT_EQ(got.document.pictures[0].bytes.size(), 3u);
}

TEST(ImportStream, EveryCutIsAnError) {
    const std::vector<std::byte> whole = written(document(), {quad()});
    for (std::size_t size = 0; size < whole.size(); ++size) EXPECT_THROW(read({whole.data(), size}), Error) << size;
}

TEST(ImportStream, AWrongEndMarkIsAnError) { EXPECT_THROW(read(written(document(), {quad()}, 1)), Error); }

TEST(ImportStream, IndicesOutOfRangeAreRefused) {
    expect_refused("vertex", [](Document&, Part& p) { p.indices[5] = 4; });
    expect_refused("material", [](Document&, Part& p) { p.surface = 1; });
    expect_refused("mesh of node", [](Document& d, Part&) { d.places[0].meshes = {1}; });
    expect_refused("parent after child", [](Document& d, Part&) { d.places[0].parent = 1; });
    expect_refused("own parent", [](Document& d, Part&) { d.places[1].parent = 1; });
    expect_refused("light", [](Document& d, Part&) { d.lamps[0].node = 2; });
    expect_refused("camera", [](Document& d, Part&) { d.views[0].node = 2; });
    expect_refused("joint", [](Document& d, Part&) { d.joints[0].node = 2; });
    expect_refused("influence", [](Document&, Part& p) { p.influences[0].joints[0] = 1; });
    expect_refused("animation", [](Document& d, Part&) { d.motions[0].tracks[0].node = 9; });
    expect_refused("picture", [](Document& d, Part&) { d.surfaces[0].links[0].picture = 1; });
}

TEST(ImportStream, SizesThatDoNotFitAreRefused) {
    expect_refused("indices", [](Document&, Part& p) { p.indices.pop_back(); });
    expect_refused("normals", [](Document&, Part& p) { p.normals.pop_back(); });
    expect_refused("tangents", [](Document&, Part& p) { p.tangents.resize(3); });
    expect_refused("texcoords", [](Document&, Part& p) { p.texcoords[0].resize(5); });
    expect_refused("triangle array", [](Document&, Part& p) { p.polygons.resize(3); });
    expect_refused("list of groups", [](Document&, Part& p) { p.smoothing.resize(3); });
    expect_refused("hint", [](Document&, Part& p) { p.smoothing_hint.resize(5); });
    expect_refused("shape", [](Document&, Part& p) { p.shapes[0].positions.resize(3); });
    expect_refused("values", [](Document& d, Part&) { d.motions[0].tracks[0].values.pop_back(); });
    expect_refused("raw picture whose size overflows", [](Document& d, Part&) {
        d.pictures[0].width = d.pictures[0].height = 1u << 31;
        d.pictures[0].bytes.clear();
    });
    expect_refused("raw picture", [](Document& d, Part&) { d.pictures[0].width = d.pictures[0].height = 4; });
}

TEST(ImportStream, EnumerationsOutOfRangeAreRefused) {
    expect_refused("topology", [](Document&, Part& p) { p.topology = 3; });
    expect_refused("role", [](Document& d, Part&) { d.surfaces[0].links[0].role = 99; });
    expect_refused("wrap", [](Document& d, Part&) { d.surfaces[0].links[0].wrap_v = 3; });
    expect_refused("light", [](Document& d, Part&) { d.lamps[0].type = 4; });
    expect_refused("path", [](Document& d, Part&) { d.motions[0].tracks[0].path = 3; });
    expect_refused("axis", [](Document& d, Part&) { d.axes.up = 3; });
    expect_refused("sign", [](Document& d, Part&) { d.axes.front_sign = 0; });
}

TEST(ImportStream, AHugeCountIsRefusedBeforeMemoryIsTaken) {
    std::vector<std::byte> bytes = written(document(), {quad()});
    const std::uint64_t huge = ~0ull / 2;
    const std::size_t pictures = sizeof(Head) + sizeof(AxisSystem);  // the first count
    std::memcpy(bytes.data() + pictures, &huge, 8);
    EXPECT_THROW(read(bytes), Error);
    const std::uint64_t large = 1ull << 34;  // fits 64 bits, not the budget
    std::memcpy(bytes.data() + pictures, &large, 8);
    EXPECT_THROW(read(bytes), Error);
}

TEST(ImportStream, ARefusalBecomesTheError) {
    std::vector<std::byte> out;
    Writer writer([&out](std::span<const std::byte> b) { out.insert(out.end(), b.begin(), b.end()); });
    writer.value(Head{magic, version, std::uint32_t(Kind::refusal)});
    writer.text("the reader\nsaid no");
    try {
        read(out);
        FAIL() << "it was read";
    } catch (const Error& e) {
        EXPECT_EQ(e.code(), ErrorCode::bad_file);
        EXPECT_STREQ(e.what(), "the reader?said no");
    }
}

}  // namespace
}  // namespace rakelight::io::import_stream
