// SPDX-License-Identifier: Apache-2.0
// STL text: solids, ways to write numbers and keywords, and facets that are broken.
#include <limits>
#include <optional>

#include "unit/io/stl/stl_support.h"

namespace rakelight::io::stl_test {
namespace {

std::string facet(const std::string& vertices) {
    return "facet normal 0 0 1\nouter loop\n" + vertices + "endloop\nendfacet\n";
}
const std::string triangle = facet("vertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"),
                  other = facet("vertex 1 0 0\nvertex 1 1 0\nvertex 0 1 0\n");

std::string solid(const std::string& facets, const std::string& name = "a") {
    return "solid " + name + "\n" + facets + "endsolid " + name + "\n";
}

TEST(TextStl, TrianglesShareVerticesAndHaveNoNormals) {
    ReadStl stl(solid(triangle + other, "wedge of cheese"));
    ASSERT_EQ(stl.error, "");
    EXPECT_EQ(triangle_count(stl.scene), 2u);
    EXPECT_EQ(stl.mesh().positions.size(), 4u);
    EXPECT_TRUE(stl.mesh().normals.empty());
    EXPECT_EQ(stl.mesh().name, "wedge");
    ASSERT_EQ(stl.scene.nodes.size(), 2u);
    EXPECT_EQ(stl.scene.nodes[0].name, "");
    EXPECT_EQ(stl.scene.nodes[1].name, "wedge");
    EXPECT_EQ(stl.remarks(), 0u);
}

TEST(TextStl, EachSolidIsAnObject) {
    ReadStl stl(solid(triangle, "one") + solid("", "empty") + solid(triangle + other, ""));
    ASSERT_EQ(stl.error, "");
    ASSERT_EQ(stl.scene.meshes.size(), 2u);
    ASSERT_EQ(stl.scene.nodes.size(), 4u);
    EXPECT_EQ(stl.scene.nodes[0].name, "<STL_ASCII>") << "a solid has no name";
    EXPECT_EQ(stl.scene.nodes[1].name, "one");
    EXPECT_TRUE(stl.scene.nodes[2].meshes.empty());
    EXPECT_EQ(stl.mesh(1).triangle_count(), 2u);
    EXPECT_TRUE(stl.says("1 solids without facets"));
    EXPECT_EQ(stl.remarks(), 1u);
    EXPECT_EQ(ReadStl("solid a\n" + triangle + "solid b\n" + other + "endsolid\n").scene.meshes.size(), 2u);
}

TEST(TextStl, KeywordsMayBeInCapitalsAndBlanksAnyhow) {
    std::string capitals = solid(triangle);
    for (char& c : capitals) c = char(std::toupper(c));
    std::string windows, line = solid(triangle);
    for (const char c : line) windows += c == '\n' ? "\r\n" : std::string(1, c);
    std::string mac = line;
    std::ranges::replace(mac, '\n', '\r');
    std::ranges::replace(line, '\n', ' ');
    std::string wide = "\xFF\xFE";
    for (const char c : solid(triangle)) wide += std::string{c, '\0'};
    for (const std::string& text :
         {capitals, windows, mac, line, "\xEF\xBB\xBF" + solid(triangle), " \n\t" + solid(triangle), wide}) {
        ReadStl stl(text);
        EXPECT_EQ(stl.error, "") << text;
        EXPECT_EQ(triangle_count(stl.scene), 1u) << text;
        EXPECT_EQ(stl.remarks(), text == wide ? 1u : 0u) << text;
    }
    ReadStl padded(solid(triangle + other + triangle + other + triangle + other) + std::string(512, '\0'));
    EXPECT_EQ(padded.error, "");
    EXPECT_EQ(padded.remarks(), 0u);
}

TEST(TextStl, NumbersAreThoseOfTheText) {
    ReadStl stl(solid(facet("vertex 1.5e+00 -.25 +3\nvertex 0.1 1e-400 1E1\nvertex 16777217 2. 0\n")));
    ASSERT_EQ(stl.error, "");
    EXPECT_EQ(stl.position(0), (vec3{1.5f, -0.25f, 3}));
    EXPECT_EQ(stl.position(1), (vec3{0.1f, 0, 10}));
    EXPECT_EQ(stl.position(2), (vec3{16777216, 2, 0}));
    ReadStl commas(solid(facet("vertex 1,5 0 0\nvertex 0 2,25 0\nvertex 0 0 0\n")));
    ASSERT_EQ(commas.error, "");
    EXPECT_EQ(commas.position(1), (vec3{0, 2.25f, 0}));
    EXPECT_TRUE(commas.says("decimal points"));
}

TEST(TextStl, ModelsFarFromZeroGetAnOriginThatAllSolidsShare) {
    const std::string near = facet("vertex 5000000.125 0 0\nvertex 5000001.125 0 0\nvertex 5000000.125 1 0\n"),
                      far = facet("vertex 5000002.25 0 0\nvertex 5000003.25 0 0\nvertex 5000002.25 1 0\n");
    ReadStl stl(solid(near, "near") + solid(far, "far"));
    ASSERT_EQ(stl.error, "");
    EXPECT_NE(stl.mesh(0).origin, (dvec3{}));
    EXPECT_EQ(stl.mesh(0).origin, stl.mesh(1).origin);
    EXPECT_EQ(stl.mesh(0).origin.x + double(stl.position(0).x), 5000000.125);
}

TEST(TextStl, NumbersThatAreNotFiniteAreReported) {
    ReadStl stl(solid(facet("vertex nan 0 0\nvertex 1e39 0 1\nvertex 0 -inf 0\n") + triangle));
    ASSERT_EQ(stl.error, "");
    EXPECT_TRUE(stl.says("3 vertices are not finite numbers"));
    ReadStl normals(
        solid("facet normal nan -nan(ind) inf\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
              "endloop\nendfacet\nfacet\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
              "endfacet\n"));
    EXPECT_EQ(normals.error, "");
    EXPECT_EQ(normals.remarks(), 0u);
}

TEST(TextStl, BrokenFacetsAreRefusedWithTheirLine) {
    const auto error = [](const std::string& text) { return ReadStl("solid a\n" + text).error; };
    EXPECT_EQ(error(triangle + facet("vertex 0 0 0\nvertex 1 0 0\n")),
              "line 9: a facet has 2 vertices instead of three");
    EXPECT_EQ(error(facet("vertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nvertex 0 1 0\n")),
              "line 7: a facet has more than three vertices");
    EXPECT_EQ(error("vertex 0 0 0\n"), "line 2: a vertex stands outside of a facet");
    EXPECT_EQ(error(facet("vertex 0 zero 0\n")), "line 4: a vertex has 'zero' where a number should stand");
    EXPECT_EQ(error(facet("vertex 0 1.2.3 0\n")), "line 4: a vertex has '1.2.3' where a number should stand");
    EXPECT_EQ(error(facet("vertex 0 0\nvertex 1 0 0\n")), "line 5: a vertex has 'vertex' where a number should stand");
    EXPECT_EQ(error("facet normal 0 0 1\nouter loop\nvertex 0 0"), "line 4: the text ends inside a vertex");
    EXPECT_EQ(error("facet normal 0 0 1\nouter loop\nvertex 0 0 0\n"),
              "line 2: a facet has 1 vertex instead of three; the file is cut short or damaged");
    EXPECT_EQ(error("endsolid a\n"), "nothing to draw: the file holds no facet");
}

TEST(TextStl, AMissingEndAndForeignWordsAreWarnings) {
    ReadStl stl("solid a\n" + triangle);
    ASSERT_EQ(stl.error, "");
    EXPECT_TRUE(stl.says("the solid has no end"));
    ReadStl words(solid("color 1 0 0\n" + triangle) + "and more");
    ASSERT_EQ(words.error, "");
    EXPECT_EQ(triangle_count(words.scene), 1u);
    EXPECT_TRUE(words.says("6 words are none of STL"));
}

TEST(TextStl, EveryPrefixAndEveryDamageEndsInASceneOrAnError) {
    const std::string text = solid(triangle + other) + solid(other, "b");
    for (std::size_t size = 0; size <= text.size(); ++size) const ReadStl part(text.substr(0, size));
    for (std::size_t at = 0; at < text.size(); ++at)
        for (const char c : {'\0', '\n', ' ', '-', '9', 'e', '\xFF'}) {
            std::string damaged = text;
            damaged[at] = c;
            const ReadStl read(damaged);
        }
    EXPECT_NE(ReadStl("").error, "");
    EXPECT_NE(ReadStl("solid").error, "");
    EXPECT_NE(ReadStl("solidarity\n" + triangle).error, "");
}

TEST(TextStl, MemoryIsChargedAndLimited) {
    std::string facets;
    for (int i = 0; i < 1000; ++i) facets += triangle;
    EXPECT_NE(ReadStl(solid(facets), {.threads = 1, .max_memory = 50000}).error.find("more than the limit"),
              std::string::npos);
    std::string solids;
    for (int i = 0; i < 1000; ++i) solids += "solid\nendsolid\n";
    EXPECT_NE(ReadStl(solids, {.threads = 1, .max_memory = 50000}).error.find("the solids of an STL file"),
              std::string::npos);
    ReadStl read(solid(facets));
    EXPECT_LT(read.context.memory().charged(), 3000 * 4 + 3 * 12 + 3000u) << "what reading it took is given back";
}

}  // namespace
}  // namespace rakelight::io::stl_test
