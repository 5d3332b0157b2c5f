// SPDX-License-Identifier: Apache-2.0
// The shortest way from a model to a picture: load, smooth, render, save.
//
//   minimal [MODEL] [PICTURE]      builtin:teapot and teapot.png by default
#include <cstdio>
#include <string>

#include <rakelight/rakelight.h>

int main(int argc, char** argv) {
    const std::string model = argc > 1 ? argv[1] : "builtin:teapot";
    const std::string picture = argc > 2 ? argv[2] : "teapot.png";
    try {
        rakelight::Context context;  // threads, memory limit, and the report of what was changed, guessed or dropped

        // A scene is a cheap value: smooth() gives a new one that shares all untouched data with the old.
        rakelight::Scene scene = rakelight::load(model, {}, context);
        scene = rakelight::smooth(scene, {.scope = rakelight::Scope::model}, context);

        // Without a camera or lights in the file, the model is fitted into the picture and gets a default light rig.
        rakelight::RenderSettings settings;
        settings.width = 640;
        settings.height = 360;
        rakelight::save(rakelight::render(scene, settings, context), picture);

        for (const rakelight::ReportEntry& remark : context.report().entries())
            std::fprintf(stderr, "%s: %s\n", rakelight::name_of(remark.remark), remark.message.c_str());
        return 0;
    } catch (const rakelight::Error& error) {
        std::fprintf(stderr, "minimal: %s\n", error.what());
        return 1;
    }
}
