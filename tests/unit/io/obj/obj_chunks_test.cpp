// SPDX-License-Identifier: Apache-2.0
// What is made of a file must not depend on where it is cut into chunks, nor on threads.
#include <cstring>

#include "io/files/file.h"
#include "io/obj/obj_lines.h"
#include "io/obj/read_obj.h"
#include "io/obj/write/rewrite_normals.h"
#include "unit/io/obj/obj_fixture.h"

namespace rakelight::io {
namespace {

class ObjChunks : public obj_test::ObjFolder {};

std::vector<std::size_t> line_begins(std::string_view text) {
    std::vector<std::size_t> begins;
    obj::LineReader lines(text);
    for (obj::Line line; lines.next(line);) begins.push_back(line.begin);
    return begins;
}

TEST_F(ObjChunks, ChunksBeginWhereLogicalLinesDo) {
    const std::string texts[] = {"v 1 2 3\nv 4 \\\n5 6\n\nf 1 2 \\\r\n3\r\n# C:\\\nv 7 8 9",
                                 "a\rb\\\rc\r\n\r\n\n\rd\\",
                                 "\xEF\xBB\xBFv 1 2 3\n\\\n\\\n",
                                 "\\\\\n\\\n\n\\\n\\\n\\",
                                 "\n",
                                 "",
                                 "\xEF\xBB\xBF"};
    for (const std::string& text : texts) {
        const std::vector<std::size_t> begins = line_begins(text);
        for (std::size_t bytes = 1; bytes <= text.size() + 1; ++bytes) {
            std::vector<std::size_t> in_chunks;
            std::uint64_t number = 1;
            std::size_t at = text.starts_with("\xEF\xBB\xBF") ? 3 : 0;
            for (const obj::Chunk& chunk : obj::chunks_of(text, bytes)) {
                EXPECT_EQ(chunk.begin, at);
                at = chunk.end;
                obj::LineReader lines(text, chunk, number);
                for (obj::Line line; lines.next(line);) in_chunks.push_back(line.begin);
                number = lines.next_number();
            }
            EXPECT_EQ(at, text.size());
            EXPECT_EQ(in_chunks, begins) << bytes;
        }
    }
}

/// All that chunks could get wrong: state that goes on, references to lines before and after, polygons, faults.
const std::string everything = [] {
    std::string text = "mtllib none.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0 \\\n 1\nvt 0 0\nvt 1 0\nvt 1 1\nvn 0 0 2\n";
    for (int i = 0; i < 40; ++i) {
        const std::string n = std::to_string(i);
        if (i % 4 == 0) text += "g part " + std::to_string(i % 12) + "\n";
        if (i % 5 == 0) text += "usemtl m" + std::to_string(i % 3) + "\r\n";
        if (i % 3 == 1) text += "s " + std::string(i % 2 ? n : "off") + "\n";
        text += "v " + n + " 0." + n + " " + n + "e-1" + (i % 2 ? " 0.5 0.25 1" : "") + "\n";
        text +=
            "f 1 2 3\nf -1 \\\n-2 -3\nf 1/1 2/2 3/3 4/1\nf 1//1 2//1 3//1\nf 1 2 3 4 " + std::to_string(44 - i) + "\n";
        if (i % 7 == 3) text += "l 1 2 3 -1\np 1 2\nf 1 2\nf 1 99999 2\nf 1 2 x\nvn 0 0 0\nbevel on\n# end \\\n";
        if (i % 11 == 5) text += "v 1 nan 2\nvt 1e999 0\ns x\nwhat\n";
    }
    return text;
}();

std::vector<std::string> words(const Context& context) {
    std::vector<std::string> all;
    for (const ReportEntry& e : const_cast<Context&>(context).report().entries())
        all.push_back(e.place + ": " + e.message);
    return all;
}

TEST_F(ObjChunks, TheSceneAndTheRemarksAreTheSameWhereverTheFileIsCut) {
    for (const std::string& text : {everything, "o one\n" + everything + "o two\nf 1 2 3\n"}) {
        Context whole({.threads = 1});
        const Scene expected = obj::read_obj_text(text, "model.obj", {}, whole, std::size_t(1) << 30);
        ASSERT_GT(expected.meshes.size(), 4u);
        for (const std::size_t bytes : {1, 17, 64, 300, 2000})
            for (const int threads : {1, 3}) {
                Context context({.threads = threads});
                const Scene scene = obj::read_obj_text(text, "model.obj", {}, context, bytes);
                EXPECT_EQ(scene.nodes, expected.nodes);
                EXPECT_EQ(scene.materials, expected.materials);
                ASSERT_EQ(scene.meshes.size(), expected.meshes.size());
                for (std::size_t m = 0; m < scene.meshes.size(); ++m) {
                    const Mesh &a = scene.meshes[m], &b = expected.meshes[m];
                    const auto same = [](const auto& x, const auto& y) {
                        return x.size() == y.size() &&
                               (x.empty() || std::memcmp(x.data(), y.data(), x.size() * sizeof(x[0])) == 0);
                    };
                    EXPECT_TRUE(same(a.positions, b.positions) && same(a.normals, b.normals) &&
                                same(a.colors, b.colors) && same(a.indices, b.indices) &&
                                same(a.smoothing, b.smoothing) && same(a.polygons, b.polygons));
                    ASSERT_EQ(a.texcoords.size(), b.texcoords.size());
                    for (std::size_t set = 0; set < a.texcoords.size(); ++set)
                        EXPECT_TRUE(same(a.texcoords[set], b.texcoords[set]));
                    EXPECT_EQ(a.material, b.material);
                    EXPECT_EQ(a.topology, b.topology);
                }
                EXPECT_EQ(words(context), words(whole)) << bytes;
            }
    }
}

TEST_F(ObjChunks, ARewrittenFileIsTheSameWhereverItIsCut) {
    for (const std::string& text :
         {everything, "\xEF\xBB\xBFo one\n" + everything + "o two\nf 1 2 3\nsurf 0 1 0 1 1//1\n"}) {
        Scene scene = load(text);
        for (Mesh& mesh : scene.meshes) {
            std::vector<vec3> normals(mesh.positions.size());
            for (std::size_t i = 0; i < normals.size(); ++i) normals[i] = {0.1f * float(i % 13), 0.6f, 0.8f};
            mesh.normals = std::move(normals);
        }
        const std::string source = write("source.obj", text);
        const auto written = [&](std::size_t bytes, int threads) {
            Context context({.threads = threads});
            const std::string output = write("written.obj", "");
            EXPECT_TRUE(rewrite_obj_normals(source, scene, output, {}, context, bytes));
            const Bytes made = read_file(output, context);
            return std::string(reinterpret_cast<const char*>(made->data()), made->size());
        };
        const std::string whole = written(std::size_t(1) << 30, 1);
        EXPECT_NE(whole, text);
        for (const std::size_t bytes : {1, 33, 500})
            for (const int threads : {1, 3}) EXPECT_EQ(written(bytes, threads), whole) << bytes;
    }
}

}  // namespace
}  // namespace rakelight::io
