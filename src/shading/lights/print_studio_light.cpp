// SPDX-License-Identifier: Apache-2.0
// Runs while the program is built: prints what make_environment_light() makes of the studio, which never changes, as a table for
// studio_light.cpp. The studio is gray: one number a texel, by its bits. With without-sharpest the first map, which is nine tenths of
// them, is left out: where download size matters, studio_light() makes it.
#include <bit>
#include <cstdint>
#include <cstdio>
#include <cstring>

#include "image/maps/environment.h"

int main(int argc, char** argv) {
    using namespace rakelight;
    Context context;
    const EnvironmentLight light =
        make_environment_light(make_mip_chain(studio_panorama(), ColorSpace::linear, context), context);
    const auto print = [](const vec3& c) {
        if (c.x != c.y || c.x != c.z) return false;
        std::printf("0x%08xu,\n", unsigned(std::bit_cast<std::uint32_t>(c.x)));
        return true;
    };
    std::puts("// Made by print_studio_light.cpp.\nconstexpr std::uint32_t irradiance[] = {");
    bool is_gray = true;
    for (const vec3& c : light.irradiance) is_gray &= print(c);
    const bool has_sharpest = argc < 2 || std::strcmp(argv[1], "without-sharpest") != 0;
    std::printf("};\nconstexpr bool has_sharpest = %s;\nconstexpr int sizes[] = {\n", has_sharpest ? "true" : "false");
    for (const OctahedralMap& map : light.mirrored) std::printf("%d,\n", map.size);
    std::puts("};\nconstexpr std::uint32_t texels[] = {");
    for (const OctahedralMap& map : light.mirrored)
        if (has_sharpest || &map != &light.mirrored[0])
            for (const vec3& c : map.texels) is_gray &= print(c);
    std::puts("};");
    return is_gray ? 0 : 1;
}
