// SPDX-License-Identifier: Apache-2.0
// Looks at small models, drawn and saved.
#pragma once
#include <gtest/gtest.h>

#include <fstream>

#include <rakelight/math/linear.h>

#include "../../../apps/viewer/background/load_model.h"
#include "../../../apps/viewer/document/materials.h"
#include "../../../apps/viewer/document/save.h"
#include "../../../apps/viewer/view/studio.h"
#include "support/temporary_folder.h"

namespace rakelight::viewer {

inline constexpr int width = 96, height = 64;

class Looks : public testing::Test {
protected:
    /// Two squares of two materials, one of them with a texture's coordinates, and a lamp.
    std::string write_model() {
        std::ofstream(folder_.path() / "m.mtl")
            << "newmtl red\nKd 1 0 0\nKs 0.4 0.4 0.4\nNs 20\nnewmtl gray\nKd 0.5 0.5 0.5\n";
        std::ofstream(folder_.path() / "model.obj")
            << "mtllib m.mtl\no left\nv -2 -1 0\nv 0 -1 0\nv 0 1 0.6\nv -2 1 0\nusemtl red\nf 1 2 3 4\n"
               "o right\nv 0 -1 0\nv 2 -1 0\nv 2 1 0\nv 0 1 0.6\nusemtl gray\nf 5 6 7 8\n";
        return (folder_.path() / "model.obj").string();
    }
    std::shared_ptr<const Model> model(const std::string& file) {
        Start start{.load = {.allow_shaders = true}};
        start.takes = [](std::string_view) { return true; };
        return load_model(file, start, context_);
    }
    Shot shot(Studio& studio, const std::shared_ptr<const Model>& model, const Look& look) {
        return studio.plan(model, look, request_of(look, width, height), camera_of(look, *model, width, height),
                           context_);
    }
    Frame drawn(const std::shared_ptr<const Model>& model, const Look& look) {
        Studio studio;
        Frame frame;
        studio.draw(shot(studio, model, look), 0, frame, context_);
        return frame;
    }
    std::string file(const char* name) { return (folder_.path() / name).string(); }

    test::TemporaryFolder folder_;
    Context context_;
};

/// The picture of what is saved is the picture of what was seen.
#define EXPECT_SAVED_AS_SEEN(look, of)                                                                        \
    do {                                                                                                      \
        save_world(world_of(look, *(of), width, height, file("saved.scene.toml")), file("saved.scene.toml")); \
        const auto saved = model(file("saved.scene.toml"));                                                   \
        const Look back = first_look(*saved);                                                                 \
        const dvec3 moved = camera_of(back, *saved, width, height).to_world[3].xyz() -                        \
                            camera_of(look, *(of), width, height).to_world[3].xyz();                          \
        EXPECT_LT(length(moved), 1e-12);                                                                      \
        EXPECT_TRUE(drawn(saved, back).color == drawn(of, look).color);                                       \
    } while (false)

}  // namespace rakelight::viewer
