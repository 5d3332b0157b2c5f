// SPDX-License-Identifier: Apache-2.0
// The scene of `rakelight bench render`, drawn by OpenGL as a careful program does it: one vertex array, one draw call
// an object, a shader made for the case.
#pragma once
#include <vector>

#include <rakelight/base/context.h>
#include <rakelight/engines/engine.h>
#include <rakelight/scene/scene.h>

namespace rakelight::bench {

class GlScene {
public:
    /// @param scene  as make_bench_scene() makes it: classical materials, point lights, two textures or none, uniform
    ///               scales
    GlScene(const Scene& scene, Shading shading, Bump bump, double aspect, Context& context);
    void draw() const;  ///< on its head, see GlTarget

private:
    void upload_vertices(const Scene& scene);
    void make_program(const Scene& scene, Shading shading, Bump bump);
    struct Object {
        int indices, base_vertex;
        std::size_t first_index;
        float model[16], rotation[9], base_color[3];
    };
    std::vector<Object> objects_;
    unsigned vertex_array_ = 0, program_ = 0;
    int model_ = -1, rotation_ = -1, base_color_ = -1;
};

}  // namespace rakelight::bench
