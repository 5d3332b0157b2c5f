// SPDX-License-Identifier: Apache-2.0
// Many pictures of one scene: a session keeps what was made for the first. The model turns once round, as numbered pictures.
//
//   turntable [MODEL] [FOLDER] [FRAMES]      builtin:teapot, the folder it runs in and 12 by default
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

#include <rakelight/rakelight.h>

int main(int argc, char** argv) {
    using namespace rakelight;
    const std::string model = argc > 1 ? argv[1] : "builtin:teapot", folder = argc > 2 ? argv[2] : ".";
    const int frames = argc > 3 ? std::atoi(argv[3]) : 12;
    try {
        Context context;
        Session session;
        session.set(load(model, {}, context));

        RenderSettings settings;
        settings.width = 320;
        settings.height = 240;
        const Scene& scene = scene_of(*session.prepared(settings, context));
        const Bounds box = bounds(scene);
        Frame frame;
        for (int i = 0; i < frames; ++i) {
            const double angle = 2 * pi * i / frames, distance = 1.6 * box.diagonal();
            const dvec3 from =
                box.center() + dvec3{distance * std::sin(angle), 0.4 * distance, distance * std::cos(angle)};
            Camera camera;
            camera.to_world = look_at(from, box.center(), {0, 1, 0});
            camera.z_far = 4 * distance;
            camera.z_near = camera.z_far / 1000;
            session.render(camera, settings, frame, context);  // the default lights turn with the camera
            char name[32];
            std::snprintf(name, sizeof name, "/turntable-%03d.png", i);
            save(frame, folder + name);
        }
        return 0;
    } catch (const Error& error) {
        std::fprintf(stderr, "turntable: %s\n", error.what());
        return 1;
    }
}
