// SPDX-License-Identifier: Apache-2.0
// What a program with a window wants of a long run: how far it is, to end it, to begin again, and a limit on memory.
//
//   context [MODEL]      builtin:teapot by default
#include <cstdio>
#include <string>

#include <rakelight/rakelight.h>

int main(int argc, char** argv) {
    using namespace rakelight;
    const std::string model = argc > 1 ? argv[1] : "builtin:teapot";
    try {
        Context* running = nullptr;
        bool is_impatient = true;
        Context context({.progress = [&](std::string_view stage, double fraction) {
            std::fprintf(stderr, "%.*s %3.0f %%\n", int(stage.size()), stage.data(), 100 * fraction);
            // From any thread, as a button would: what runs ends at its next item, by an Error.
            if (is_impatient && stage == "render" && fraction > 0.2) running->cancel();
        }});
        running = &context;

        const Scene scene = load(model, {}, context);
        RenderSettings settings;
        settings.width = 640;
        settings.height = 360;
        try {
            render(scene, settings, context);
            return std::puts("it was not cancelled"), 1;
        } catch (const Error& error) {
            if (!context.cancelled()) throw;  // another reason
            std::printf("ended: %s\n", error.what());
        }

        is_impatient = false;
        context.reset_cancel();
        settings.width = 64;
        settings.height = 36;
        const Frame frame = render(scene, settings, context);
        std::printf("then %d x %d pixels\n", frame.width, frame.height);

        // A limit counts what files ask for, before memory is taken. Results are charged to the context they were made with.
        Context small({.threads = 1, .max_memory = 1000});
        try {
            load(model, {}, small);
            return std::puts("the limit was not kept"), 1;
        } catch (const Error& error) {
            std::printf("refused: %s\n", error.what());
        }
        return 0;
    } catch (const Error& error) {
        std::fprintf(stderr, "context: %s\n", error.what());
        return 1;
    }
}
