// SPDX-License-Identifier: Apache-2.0
// A context of OpenGL 3.3 core or ES 3.0 without a window, and programs that compute numbers in a fragment shader.
#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace rakelight::test {

enum class GlFlavour { core_33, es_30 };

/// Numbers of a texture, four floats a texel, and the uniform that samples it.
struct GlTexture {
    std::string sampler;
    int width, height;
    std::span<const float> texels;  ///< [width * height * 4]
};

class GlContext {
public:
    /// Surfaceless by EGL. Null where this machine has none; `why` then says it in words.
    static std::unique_ptr<GlContext> make(GlFlavour flavour, std::string& why);
    ~GlContext();
    GlContext(const GlContext&) = delete;
    GlContext& operator=(const GlContext&) = delete;

    /// What draws, as GL_RENDERER says.
    std::string renderer() const;

    void set_textures(const std::vector<GlTexture>& textures);
    /// A texture of two whole numbers a texel. @param texels  [width * height * 2]
    void set_whole_texture(const std::string& sampler, int width, int height, const std::vector<std::uint32_t>& texels);
    void set_whole(const std::string& uniform, int number);
    /// A uniform array of vec3. @param numbers  [3 * length]
    void set_vectors(const std::string& uniform, std::vector<float> numbers);

    /// Four floats for each pixel of a picture: `result` of the fragment shader. `text` stands between the lines of the
    /// version and of `out vec4 result;` and the function main(), which `text` has, too.
    /// @throws std::runtime_error with the compiler's words
    std::vector<float> run(const std::string& text, int width, int height);

private:
    struct State;
    explicit GlContext(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

}  // namespace rakelight::test
