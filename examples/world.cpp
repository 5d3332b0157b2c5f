// SPDX-License-Identifier: Apache-2.0
// A world file as the program draws it: its [render] says how. Data channels that it asks for are written beside the picture.
//
//   world WORLD.scene.toml PICTURE
#include <cstdio>

#include <rakelight/rakelight.h>

int main(int argc, char** argv) {
    if (argc != 3) return std::fputs("usage: world WORLD.scene.toml PICTURE\n", stderr), 2;
    try {
        rakelight::Context context;
        rakelight::PictureRequest request = rakelight::request_of_world(argv[1], {}, context);
        request.output = argv[2];
        const rakelight::PictureResult result = rakelight::render_picture(request, context);
        std::printf("%d x %d pixels, %zu channel files\n", result.width, result.height, result.channel_files.size());
        return 0;
    } catch (const rakelight::Error& error) {
        std::fprintf(stderr, "world: %s\n", error.what());
        return 1;
    }
}
