// SPDX-License-Identifier: Apache-2.0
#include "engines/opengl/picture/shadow_atlas.h"

#include <algorithm>
#include <string>

#include <rakelight/base/error.h>

#include "base/format_text.h"
#include "shading/lights/shadow_factors.h"

namespace rakelight::opengl {
namespace {

constexpr int cube_columns = 2, cube_rows = 3;

/// Cells of a light after the other in rows of cells, cubes first.
struct Shelves {
    int most;  ///< [maps] a side
    int x = 0, y = 0, height = 0, columns = 0;

    ShadowAtlas::Place put(int wide, int high) {
        if (x + wide > most || high != height) y += x > 0 ? height : 0, x = 0, height = high;
        const ShadowAtlas::Place place{x, y};
        x += wide, columns = std::max(columns, x);
        return place;
    }
    int rows() const { return y + height; }
};

}  // namespace

std::vector<ShadowAtlas::Place> ShadowAtlas::reserve(const std::vector<int>& faces, int size) {
    Shelves shelves{driver_.picture_size / size};
    std::vector<Place> places(faces.size());
    for (const int kind : {6, 1})
        for (std::size_t i = 0; i < faces.size(); ++i)
            if (faces[i] == kind) places[i] = kind == 6 ? shelves.put(cube_columns, cube_rows) : shelves.put(1, 1);
    if (shelves.columns > shelves.most || shelves.rows() > shelves.most)
        throw Error(ErrorCode::failed,
                    format_text("shadow maps of {} x {} texels for {} lights do not fit into a texture of this OpenGL "
                                "driver, {} per side",
                                size, size, faces.size(), driver_.picture_size),
                    {}, "make them smaller")
            .about("shadow-size");
    allocate(shelves.columns, shelves.rows(), size);
    for (Place& p : places) p = {p.x * size, p.y * size};
    return places;
}

void ShadowAtlas::allocate(int columns, int rows, int size) {
    if (texels_ && columns == columns_ && rows == rows_ && size == size_) return;
    forget();
    columns_ = columns, rows_ = rows, size_ = size;
    glActiveTexture(GL_TEXTURE0);
    set_texels(texels_, GL_RG32UI, GL_RG_INTEGER, GL_UNSIGNED_INT, columns * size, rows * size);
    glBindRenderbuffer(GL_RENDERBUFFER, depth_.get());
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT32F, columns * size, rows * size);
    glBindFramebuffer(GL_FRAMEBUFFER, frame_.get());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texels_.name(), 0);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_.name());
    check_gl("the shadow maps");
}

void ShadowAtlas::forget() {
    texels_.reset(), depth_.reset(), frame_.reset();
    size_ = 0;
}

void ShadowAtlas::begin(Place light, int face, std::uint32_t nothing, float far_depth) {
    const GLint x = light.x + face / cube_rows * size_, y = light.y + face % cube_rows * size_;
    constexpr auto zero = GLuint(shading::steepest_slope_on_map * shading::slope_codes);
    constexpr GLuint flat = zero | zero << 16;
    const GLuint empty[4] = {nothing, flat, 0, 0};
    glBindFramebuffer(GL_FRAMEBUFFER, frame_.name());
    glViewport(x, y, size_, size_);
    glScissor(x, y, size_, size_);
    glEnable(GL_SCISSOR_TEST);
    glClearBufferuiv(GL_COLOR, 0, empty);
    glClearBufferfv(GL_DEPTH, 0, &far_depth);
    glDisable(GL_SCISSOR_TEST);
}

}  // namespace rakelight::opengl
