// SPDX-License-Identifier: Apache-2.0
// A model with vertex colors looks alike whatever format holds it.
#include <gtest/gtest.h>
#include <rakelight/rakelight.h>

#include <string>
#include <vector>

#include "base/format_text.h"
#include "support/temporary_folder.h"

namespace rakelight::test {
namespace {

struct ColoredVertex {
    int at[3], color[3];
};

/// An open box (without a lid), each corner in a color of its own.
constexpr ColoredVertex corners[] = {{{0, 0, 0}, {200, 10, 20}},   {{2, 0, 0}, {10, 180, 30}}, {{2, 1, 0}, {0, 0, 255}},
                                     {{0, 1, 0}, {255, 255, 255}}, {{0, 0, 1}, {128, 64, 0}},  {{2, 0, 1}, {0, 0, 0}},
                                     {{2, 1, 1}, {90, 90, 200}},   {{0, 1, 1}, {250, 240, 10}}};
constexpr int faces[][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {0, 4, 7, 3}, {1, 2, 6, 5}};

std::string obj_text(const std::string& use) {
    std::string text;
    for (const ColoredVertex& v : corners)
        text += format_text("v {} {} {} {} {} {}\n", v.at[0], v.at[1], v.at[2], v.color[0], v.color[1], v.color[2]);
    text += use;
    for (const auto& f : faces) text += format_text("f {} {} {} {}\n", f[0] + 1, f[1] + 1, f[2] + 1, f[3] + 1);
    return text;
}

std::string ply_text() {
    std::string text =
        "ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\nproperty float y\nproperty float z\n"
        "property uchar red\nproperty uchar green\nproperty uchar blue\nelement face 5\n"
        "property list uchar int vertex_indices\nend_header\n";
    for (const ColoredVertex& v : corners)
        text += format_text("{} {} {} {} {} {}\n", v.at[0], v.at[1], v.at[2], v.color[0], v.color[1], v.color[2]);
    for (const auto& f : faces) text += format_text("4 {} {} {} {}\n", f[0], f[1], f[2], f[3]);
    return text;
}

class ColoredFormats : public testing::Test {
protected:
    Pixels picture_of(const std::string& file, bool is_unlit = false) {
        PictureRequest request;
        request.input = file;
        request.look = Look::standard;
        request.settings.width = 120, request.settings.height = 90;
        if (is_unlit) request.settings.shading = Shading::unlit;
        Pixels pixels;
        Context context;
        render_picture(request, pixels, context);
        return pixels;
    }
    TemporaryFolder folder_;
};

TEST_F(ColoredFormats, ObjAndPlyHaveEqualPixelsInTheDefaultLook) {
    folder_.write("some.mtl", "newmtl plain\nNs 20\n");
    const Pixels ply = picture_of(folder_.write("a.ply", ply_text()));
    for (const char* use :
         {"", "mtllib some.mtl\nusemtl plain\n", "mtllib some.mtl\nusemtl missing\n", "mtllib none.mtl\n"}) {
        const Pixels obj = picture_of(folder_.write("a.obj", obj_text(use)));
        EXPECT_TRUE(obj.bytes == ply.bytes) << use;
    }
}

TEST_F(ColoredFormats, AnUnlitObjShowsTheColorsOfTheFile) {
    std::string text;
    for (const char* at : {"-1 -1 0", "1 -1 0", "1 1 0", "-1 1 0"})
        text += std::string("v ") + at + " 0.784314 0.0392157 0.0784314\n";
    const Pixels pixels = picture_of(folder_.write("flat.obj", text + "f 1 2 3 4\n"), true);
    const std::size_t middle = 45 * pixels.row_bytes() + 60 * std::size_t(pixels.channels);
    EXPECT_EQ(int(pixels.bytes[middle]), 200);
    EXPECT_EQ(int(pixels.bytes[middle + 1]), 10);
    EXPECT_EQ(int(pixels.bytes[middle + 2]), 20);
}

}  // namespace
}  // namespace rakelight::test
