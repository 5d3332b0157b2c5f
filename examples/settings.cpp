// SPDX-License-Identifier: Apache-2.0
// A picture by settings in words, as a world file's [render] and the program's options have them; what a program that takes
// them from a configuration file does.
//
//   settings MODEL PICTURE [KEY=VALUE ...]      settings helmet.glb helmet.png samples=4 lighting=pbr light=point:0,2,3
#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include <rakelight/rakelight.h>

namespace {

/// Values of one key that are given several times are its list.
std::vector<rakelight::WorldValue> values_of(int count, char** words) {
    std::vector<rakelight::WorldValue> values;
    for (int i = 0; i < count; ++i) {
        const std::string word = words[i], key = word.substr(0, word.find('='));
        auto value = std::ranges::find(values, key, &rakelight::WorldValue::key);
        if (value == values.end()) value = values.insert(values.end(), {.key = key});
        value->words.push_back(key.size() < word.size() ? word.substr(key.size() + 1) : "on");
    }
    return values;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 3) return std::fputs("usage: settings MODEL PICTURE [KEY=VALUE ...]\n", stderr), 2;
    try {
        rakelight::Context context;
        const std::vector<rakelight::WorldValue> values = values_of(argc - 3, argv + 3);
        rakelight::PictureRequest request;
        if (rakelight::is_world_file(argv[1]))
            request = rakelight::read_world_request(argv[1], {}, {.values = values}, context).picture;
        else
            rakelight::read_render_keys(values, request);
        request.input = argv[1];
        request.output = argv[2];
        rakelight::render_picture(request, context);
        return 0;
    } catch (const rakelight::Error& error) {
        std::fprintf(stderr, "settings: %s\n", error.what());
        return 1;
    }
}
