// SPDX-License-Identifier: Apache-2.0
// What displacement makes of the meshes: the base beside the cut and moved surface, and how far each triangle moved.
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/format_text.h"
#include "engines/raster/raster_engine.h"
#include "math/linear.h"
#include "prepare/refine/displace.h"
#include "prepare/refine/displace_parts.h"
#include "render/asked_scenes.h"
#include "render/prepared_scene.h"
#include "render/shot.h"
#include "scene/placement.h"
#include "tools/object_title.h"
#include "tools/stages/paint.h"
#include "tools/stages/plot.h"

namespace rakelight::stages {
namespace {

constexpr Code still{70, 72, 78};  ///< of what is not displaced
constexpr int enlarged = 12;       ///< times

/// One placement of a mesh before and after.
struct Moved {
    bool is_displaced = false;
    std::uint64_t before = 0, after = 0;  ///< triangles
    std::vector<float> height;            ///< [triangles after] m, mean of the corners
    double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();
};

/// Of a mesh in its placement [m].
double longest_edge(const Mesh& mesh, const dmat4& to_world) {
    double longest = 0;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
        for (std::size_t k = 0; k < 3; ++k) {
            const auto at = [&](std::size_t c) {
                return transform_point(to_world, cast<double>(mesh.positions[mesh.indices[i + c % 3]]));
            };
            longest = std::max(longest, length(at(k + 1) - at(k)));
        }
    return longest;
}

/// @param flat  the same mesh, cut but not moved
Moved moved(const Mesh& fine, const Mesh& flat, const dmat4& to_world) {
    Moved out{.is_displaced = true, .after = fine.triangle_count()};
    if (flat.indices.size() != fine.indices.size()) return out;
    const dmat3 linear = upper_left(to_world);
    for (std::size_t i = 0; i < fine.indices.size(); ++i) {
        const std::uint32_t v = flat.indices[i];
        const dvec3 way = cast<double>(fine.positions[fine.indices[i]]) - cast<double>(flat.positions[v]);
        const bool is_down = !flat.normals.empty() && dot(way, cast<double>(flat.normals[v])) < 0;
        const double height = (is_down ? -1 : 1) * length(linear * way);
        out.low = std::min(out.low, height), out.high = std::max(out.high, height);
        if (i % 3 == 0) out.height.push_back(0);
        out.height.back() += float(height / 3);
    }
    return out;
}

/// The mesh that corresponds to that of a draw in another scene.
const Mesh& same_place(const Scene& scene, const Scene& of, const shading::Draw& draw) {
    const std::vector<std::uint32_t>& meshes = of.nodes[draw.node].meshes;
    const auto slot = std::find(meshes.begin(), meshes.end(), draw.mesh) - meshes.begin();
    return scene.meshes[scene.nodes[draw.node].meshes[std::size_t(slot)]];
}

struct Base {
    Scene scene;  ///< as engines get it
    Camera camera;
};

/// A requested scene that is not displaced, or with `is_cut` is cut but not moved.
Base without_relief(Scene scene, PictureRequest& request, bool is_cut, Context& context) {
    for (Material& m : scene.materials) {
        if (is_cut) m.height_scale = 0;
        if (!is_cut && m.bump == Bump::displacement) m.bump = Bump::none;
    }
    if (!is_cut && request.settings.bump == Bump::displacement) request.settings.bump = Bump::none;
    if (!is_cut) request.prepare.displacement.is_on = false;
    Session session("soft");
    const Scene& shown = session.set_single(std::move(scene), request.prepare);
    const Shot shot = decide_shown(session, shown, request, {}, {.without_adjusting = true}, context);
    return {drawn_scene(*session.prepared_for(shot, context), shot, context), shot.camera};
}

/// The part of the picture, small enough to be enlarged so often, whose heights differ most from pixel to pixel.
Window liveliest(const Sources& of, const std::vector<float>& height, int times) {
    const int w = of.engine.settings().width, h = of.engine.settings().height;
    const int across = std::max(1, w / times), down = std::max(1, h / times);
    Window best{(w - across) / 2, (h - down) / 2, across, down};
    double most = 0;
    for (int y = 0; y + down <= h; y += std::max(1, down / 2))
        for (int x = 0; x + across <= w; x += std::max(1, across / 2)) {
            double sum = 0;
            for (int j = y; j < y + down; ++j)
                for (int i = x; i + 1 < x + across; ++i) {
                    const std::size_t p = std::size_t(j) * std::size_t(w) + std::size_t(i);
                    if (std::isfinite(height[p]) && std::isfinite(height[p + 1]))
                        sum += std::fabs(double(height[p + 1]) - double(height[p]));
                }
            if (sum > most) most = sum, best = {x, y, across, down};
        }
    return best;
}

/// What `rakelight render` draws.
Canvas drawn(const Sources& of, const Scene& scene, const Camera& camera, const RenderSettings& settings,
             Context& context) {
    const auto engine = raster::make_engine();
    engine->prepare(scene, context);
    Frame frame;
    engine->render(camera, settings, frame, context);
    Canvas canvas(frame.window.width, frame.window.height, backdrop);
    for (int y = 0; y < canvas.height(); ++y)
        for (int x = 0; x < canvas.width(); ++x)
            canvas.set(x, y,
                       displayed_code(of, frame.color[std::size_t(y) * std::size_t(canvas.width()) + std::size_t(x)]));
    return canvas;
}

class DisplacementStage {
public:
    explicit DisplacementStage(const Sources& of)
        : of_(of),
          scene_(of.engine.list().scene),
          fine_request_(of.request),
          base_request_(of.request),
          context_(of.context),
          quiet_(options()),
          requested_(requested(of.loaded)),
          base_(without_relief(requested_, base_request_, false, quiet_)) {
        PictureRequest flat = of.request;
        context_.throw_if_cancelled();
        compare(without_relief(std::move(requested_), flat, true, quiet_).scene);
    }

    Stage make() {
        stage_.id = "displacement";
        stage_.title = "Displacement: height maps become geometry";
        stage_.text =
            "Before anything is drawn, triangles of displaced materials are split until no edge is longer than the "
            "setting displacement-edge, and their corners are moved along the normal by the value of the height map. "
            "All later stages see only these triangles.";
        add_numbers();
        add_pictures();
        add_rows();
        return std::move(stage_);
    }

private:
    Scene requested(const Scene& loaded) {
        const std::vector<ClipTime> clips = clips_of(loaded, fine_request_.motion);
        PictureRequest request = fine_request_;
        return asked_single(at_moment(loaded, clips, quiet_), request, quiet_);
    }
    /// Stops with the whole run, and has the memory that it leaves.
    ContextOptions options() {
        const std::uint64_t limit = context_.memory().limit(), charged = context_.memory().charged();
        return {
            .threads = context_.threads(), .max_memory = limit > charged ? limit - charged : 1, .parent = &context_};
    }

    void compare(const Scene& flat) {
        const Displacement& options = options_for(fine_request_.prepare, fine_request_.settings, scene_).displacement;
        for (const shading::Draw& draw : of_.engine.list().draws) {
            const Mesh& fine = scene_.meshes[draw.mesh];
            const Mesh& coarse = same_place(base_.scene, scene_, draw);
            Moved m;
            if (displaced_material(scene_, fine, options))
                m = moved(fine, same_place(flat, scene_, draw), draw.to_world);
            m.before = coarse.triangle_count(), m.after = fine.triangle_count();
            if (m.is_displaced) {
                low_ = std::min(low_, m.low), high_ = std::max(high_, m.high);
                before_ += m.before, after_ += m.after;
                edge_before_ = std::max(edge_before_, longest_edge(coarse, draw.to_world));
                edge_after_ = std::max(edge_after_, longest_edge(fine, draw.to_world));
            }
            moved_.push_back(std::move(m));
        }
    }

    /// [m] of each pixel's triangle; nan where nothing is displaced.
    std::vector<float> heights() const {
        std::vector<float> out(of_.pixels.draw.size(), std::numeric_limits<float>::quiet_NaN());
        for (std::size_t p = 0; p < out.size(); ++p) {
            const std::uint32_t d = of_.pixels.draw[p], t = of_.pixels.triangle[p];
            if (d != no_index && t < moved_[d].height.size()) out[p] = moved_[d].height[t];
        }
        return out;
    }

    void add_numbers() {
        stage_.numbers = {{"triangles before, of displaced meshes", before_},
                          {"triangles after", after_},
                          {"longest edge before [m]", edge_before_},
                          {"longest edge after, moved [m]", edge_after_}};
        if (low_ <= high_) stage_.numbers["lowest, from the base [m]"] = low_;
        if (low_ <= high_) stage_.numbers["highest, from the base [m]"] = high_;
    }

    void add_pictures() {
        const std::vector<float> height = heights();
        const RenderSettings& s = of_.engine.settings();
        const auto picture = [&](const std::vector<vec4>& color) {
            return paint(of_, [&](std::size_t p) { return displayed_code(of_, color[p]); });
        };
        RenderSettings base = base_request_.settings;
        base.channels = 0, base.window = {};
        base.edges = before_ < height.size() / 100;
        stage_.pictures.push_back({"displacement-base",
                                   base.edges ? "The base mesh, with its triangles." : "The base mesh.",
                                   drawn(of_, base_.scene, base_.camera, base, quiet_)});
        stage_.pictures.push_back({"displacement",
                                   format_text("Split and moved: {} triangles instead of {}.", after_, before_),
                                   picture(of_.pixels.color)});
        const int times = std::min(enlarged, 65536 / std::max(s.width, s.height));
        const Window part = liveliest(of_, height, times);
        const std::string where = format_text("{} times as large, about pixel {}, {}", times, part.x + part.width / 2,
                                              part.y + part.height / 2);
        stage_.pictures.push_back({"displacement-base-enlarged", "The triangles of the base, " + where + ".",
                                   close_up(base_.scene, base_request_.settings, part, times)});
        stage_.pictures.push_back({"displacement-enlarged", "The triangles after splitting, at the same place.",
                                   close_up(scene_, fine_request_.settings, part, times)});
        stage_.pictures.push_back({"displacement-heights", heights_caption(), paint(of_, [&](std::size_t p) {
                                       if (of_.pixels.draw[p] == no_index) return backdrop;
                                       return std::isfinite(height[p]) ? heat(place_of(double(height[p]))) : still;
                                   })});
    }

    Canvas close_up(const Scene& scene, RenderSettings settings, Window part, int times) {
        const Window whole{0, 0, settings.width, settings.height};
        settings.width *= times, settings.height *= times;
        settings.window = {std::min(part.x * times, settings.width - whole.width),
                           std::min(part.y * times, settings.height - whole.height), whole.width, whole.height};
        settings.edges = true;
        settings.channels = 0;
        context_.throw_if_cancelled();
        return drawn(of_, scene, base_.camera, settings, quiet_);
    }

    double place_of(double height) const { return high_ > low_ ? (height - low_) / (high_ - low_) : 0.5; }

    std::string heights_caption() const {
        if (!(low_ < high_)) return "How far each triangle moved: nothing moved.";
        return "How far each triangle moved along the normal: dark blue " + digits(low_) +
               " m, over green and yellow to white " + digits(high_) + " m. Gray: not displaced.";
    }

    void add_rows() {
        stage_.columns = {"object", "triangles before", "triangles after", "lowest [m]", "highest [m]"};
        for (std::size_t d = 0; d < moved_.size() && stage_.rows.size() < listed_rows; ++d) {
            const Moved& m = moved_[d];
            if (!m.is_displaced) continue;
            stage_.rows.push_back(
                {object_title(scene_, of_.engine.list().draws[d].node), m.before, m.after, cell(m.low), cell(m.high)});
        }
        stage_.rows_note = "Heights of each object's vertices over the surface before";
    }

    const Sources& of_;
    const Scene& scene_;
    const PictureRequest& fine_request_;
    PictureRequest base_request_;
    Context& context_;
    Context quiet_;  ///< what is made only for this stage makes no remarks
    Scene requested_;
    Base base_;
    std::vector<Moved> moved_;  ///< [draws]
    std::uint64_t before_ = 0, after_ = 0;
    double low_ = std::numeric_limits<double>::infinity(), high_ = -std::numeric_limits<double>::infinity();
    double edge_before_ = 0, edge_after_ = 0;
    Stage stage_;
};

bool has_displacement(const Sources& of) {
    const Scene& scene = of.engine.list().scene;
    return wants_displacement(scene, options_for(of.request.prepare, of.request.settings, scene).displacement);
}

/// Prepares the scene twice more: without displacement, and cut but not moved.
Stage make_displacement_stage(const Sources& of) {
    try {
        return DisplacementStage(of).make();
    } catch (const Error& e) {
        of.context.throw_if_cancelled();
        if (e.code() != ErrorCode::bad_file) throw;
        Stage none_made;  // the scene as it is was drawn: what fails is the memory for its base beside it
        none_made.id = "displacement";
        none_made.title = "Displacement: height maps become geometry";
        none_made.text = std::string("Left out: ") + e.what();
        return none_made;
    }
}

}  // namespace

constinit const StageKind displacement_stage{make_displacement_stage, has_displacement};

}  // namespace rakelight::stages
