// SPDX-License-Identifier: Apache-2.0
// Lines and points between the surfaces that the rays of a wave meet.
#include <algorithm>

#include "engines/raytrace/trace_wave.h"
#include "math/linear.h"

namespace rakelight::raytrace {
namespace {

/// The next line or point behind those that the ray has met.
MarkMeeting next_mark(const TracePicture& picture, MarkQuery query, const MarkProgress& progress, MarkLimit to) {
    query.after = progress.last, query.left_out = progress.run;
    query.from = progress.from.points, query.to = to.points;
    const MarkMeeting point = picture.points.first(query);
    query.from = progress.from.lines, query.to = to.lines;
    if (point.mark != no_index) query.to = std::min(query.to, point.depth);
    const MarkMeeting line = picture.lines.first(query);
    const bool is_line = line.mark != no_index && (point.mark == no_index || query.is_before(line, point));
    return is_line ? line : point;
}

/// Up to where marks are in front of a surface or on it. On a blended one lies only what no farther surface is in front of, as in
/// soft: seen at a slant it reaches behind others.
MarkLimit limit_of(const TracePicture& picture, const WaveScratch& s, std::size_t ray, Meeting surface,
                   const MarkQuery& query) {
    MarkLimit to = picture.mark_limit(surface, query.origin, query.direction, query.is_primary);
    while (surface.draw != no_index && picture.is_blended(surface.draw)) {
        const float from = surface.t * step_behind, reach = std::max(to.points, to.lines);
        if (!(from < reach)) break;
        surface = find_surface(picture, s, ray, query.with_blended, from, reach);
        if (surface.draw == no_index) break;
        const MarkLimit next = picture.mark_limit(surface, query.origin, query.direction, query.is_primary);
        to = {std::min(to.points, next.points), std::min(to.lines, next.lines)};
    }
    return to;
}

}  // namespace

void begin_rays(const TracePicture& picture, float from, WaveScratch& s) {
    s.from.assign(s.wave.count, from);
    s.marks.clear();
    if (picture.points.is_empty() && picture.lines.is_empty()) return;
    s.marks.resize(s.wave.count);
    for (std::size_t i = 0; i < s.wave.count; ++i) {
        const float begin = s.wave.is_primary() ? from : std::max(from, s.wave.marks_from[i]);
        s.marks[i].from = {begin, begin};
    }
}

Meeting find_first(const TracePicture& picture, WaveScratch& s, std::size_t ray, bool with_blended) {
    const Meeting surface = find_surface(picture, s, ray, with_blended);
    if (s.marks.empty()) return surface;
    MarkProgress& progress = s.marks[ray];
    const MarkQuery query{.origin = s.wave.vector(ray_o, ray),
                          .direction = s.wave.vector(ray_d, ray),
                          .after = {},
                          .is_primary = s.wave.is_primary(),
                          .with_blended = with_blended};
    const MarkLimit to = limit_of(picture, s, ray, surface, query);
    MarkMeeting mark = next_mark(picture, query, progress, to);
    while (mark.mark != no_index && mark.mark == progress.last.mark &&
           picture.marks[mark.mark].are_joined(mark.number, progress.last.number)) {
        progress.last = mark;
        mark = next_mark(picture, query, progress, to);
    }
    if (mark.mark != no_index) {
        progress.last = mark, progress.run = picture.marks[mark.mark].run;
        return {std::uint32_t(picture.list.draws.size()) + mark.mark, mark.number, mark.t, false, mark.part};
    }
    progress = {
        .from = to, .last = {}, .on_surface = (std::max(to.points, to.lines) - surface.t) * length(query.direction)};
    return surface;
}

}  // namespace rakelight::raytrace
