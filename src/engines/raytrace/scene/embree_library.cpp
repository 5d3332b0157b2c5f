// SPDX-License-Identifier: Apache-2.0
#include "engines/raytrace/scene/embree_library.h"

#include <dlfcn.h>

#include <rakelight/base/error.h>

namespace rakelight::raytrace {
namespace {

constexpr const char* file = "libembree3.so.3";

[[noreturn]] void refuse(const std::string& why) {
    throw Error(ErrorCode::failed, "the engine trace needs Embree 3: " + why, {},
                "install it (on Debian the package libembree3-3), or use 'engine' soft")
        .naming({"engine"});
}

EmbreeLibrary load() {
    void* const library = dlopen(file, RTLD_NOW | RTLD_LOCAL);  // for good: devices may live as long as the program
    if (!library) refuse(std::string(file) + " cannot be loaded");
    EmbreeLibrary out{};
    const auto find = [library](const char* name) {
        void* const function = dlsym(library, name);
        if (!function) refuse(std::string(file) + " has no " + name);
        return function;
    };
#define RL_FIND(name) out.name = reinterpret_cast<decltype(out.name)>(find("rtc" #name));
    RL_EMBREE_FUNCTIONS(RL_FIND)
#undef RL_FIND
    return out;
}

}  // namespace

const EmbreeLibrary& embree() {
    static const EmbreeLibrary library = load();
    return library;
}

}  // namespace rakelight::raytrace
