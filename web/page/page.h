// SPDX-License-Identifier: Apache-2.0
// The page's two pictures of one canvas, left and right of a line: a model before and after, or by two settings.
#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <rakelight/render/gl_view.h>
#include <rakelight/tools/explain.h>
#include <rakelight/tools/smooth_file.h>

#include "../../apps/viewer/view/studio.h"
#include "examined_model.h"

namespace rakelight::web {

enum class Version : std::uint8_t { original, fixed };

/// One of the two pictures.
struct Half {
    Version version = Version::original;
    std::vector<WorldValue> settings;  ///< keys of [render] beyond those that were chosen for the model
    std::uint32_t channel = 0;         ///< Channel bit that is shown instead of the colors; 0: colors
    viewer::Look look;
    viewer::Studio studio;
    std::optional<GlView> view;  ///< absent: not needed yet, or there is no OpenGL
    std::vector<Line> hard_edges;
    std::shared_ptr<const PreparedScene> hard_edges_of;
};

/// What is drawn over the surfaces.
struct Marks {
    bool seams = false, hard_edges = false;
    bool any() const { return seams || hard_edges; }
};

/// sRGB codes, R in the low byte. Smaller than it is shown while the picture moves.
struct SoftPicture {
    int width = 0, height = 0;         ///< [px]
    std::vector<std::uint32_t> codes;  ///< [width * height]
};

class Page {
public:
    /// Draws by OpenGL from now on, in the current context; after a lost one, too.
    void start_gl();
    void end_gl();
    /// GL_RENDERER; empty: the engine soft draws.
    std::string renderer() const;

    /// The model of the page from now on. @throws Error as examine(); then the page keeps its model
    const Inspection& open(const std::string& file, Context& context);
    /// The seams of the same model by the settings of now; the eye stays. A fixed version is forgotten.
    const Inspection& examine_again(Context& context);
    /// A file that smooth() wrote of it.
    const Inspection& open_fixed(const std::string& file, Context& context);
    bool has(Version version) const { return models_[std::size_t(version)] != nullptr; }
    /// The file that the program's `smooth` would write by the settings of the left half.
    SmoothedFile smooth(const std::string& output, Context& context) const;

    /// @throws Error usage: a key or value that is wrong; then nothing is changed
    /// @param channel  its word, shown instead of the colors; "": colors
    void set(std::size_t half, Version version, const std::string& channel, std::vector<WorldValue> settings);

    /// Into the framebuffer and viewport that are bound; without OpenGL see soft_picture().
    /// @param line  [px] from the left: where the right half begins; the width: there is none
    /// @return false: a coarse picture, since the programs of OpenGL may take seconds to compile; the next one is whole
    bool draw(int width, int height, int line, Marks marks, bool is_moving, Context& context);
    /// The last draw() without OpenGL.
    const SoftPicture& soft_picture() const { return soft_picture_; }

    /// @param dx,dy  of the picture's smaller side, y down: half a turn for all of it
    void turn(double dx, double dy);
    /// @param dx,dy  of the picture's height, y down
    void pan(double dx, double dy);
    void dolly(double factor);
    void show_whole();
    /// A light grazes the surface across a seam, and fly() leads to it. @throws Error usage: there is no such border
    void fly_to_border(std::size_t border);
    /// @param share  0..1 of the way
    void fly(double share);
    /// The light of the settings again.
    void end_raking_light();

    /// @param width,height  [px] of the picture  @param x,y  [px] in it
    std::shared_ptr<const ExplainedPixel> explain(std::size_t half, int width, int height, int x, int y,
                                                  Context& context);

private:
    const ExaminedModel& shown_in(const Half& half) const { return *models_[std::size_t(half.version)]; }
    viewer::Look look_of(Version version, std::span<const WorldValue> settings) const;
    void update_looks();
    void forget_right();
    viewer::Eye& moving_eye();
    std::vector<Line> lines_of(Half& half, Marks marks, const Scene& prepared) const;
    Shot plan(Half& half, PictureRequest& request, Context& context) const;
    bool draw_gl(int line, Marks marks, bool is_moving, Context& context);
    void draw_soft(int line, Marks marks, bool is_moving, Context& context);
    void draw_by_gl(Half& half, Marks marks, bool is_moving, Context& context);
    void show_soft(Half& half, Marks marks, bool is_moving, Context& context);
    void draw_right_by_gl(int line, Marks marks, bool is_moving, Context& context);
    SoftPicture drawn_by_soft(Half& half, Marks marks, bool is_moving, Context& context) const;

    std::array<std::shared_ptr<const ExaminedModel>, 2> models_;  ///< by Version
    std::array<Half, 2> halves_;
    std::optional<viewer::Eye> eye_;  ///< absent: as the model says
    viewer::Eye flight_begin_, flight_end_;
    std::optional<Light> raking_;
    int width_ = 640, height_ = 480;
    bool has_gl_ = false;
    /// What comes next of a model: a coarse picture, the one whose programs are compiled, or any other.
    enum class Next : std::uint8_t { coarse, compiled, other } next_ = Next::coarse;
    bool compiles_slowly_ = true;  ///< programs of OpenGL, as far as is known
    SoftPicture soft_picture_;
};

}  // namespace rakelight::web
