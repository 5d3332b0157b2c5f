// SPDX-License-Identifier: Apache-2.0
// Visibility at samples, and shading: whole pixels as without samples, the others fragment by fragment.
#include "engines/raster/multisample.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "engines/empty_pixel.h"
#include "engines/raster/occlusion/occlusion.h"
#include "engines/raster/shade/channels_tile.h"
#include "engines/raster/shade/shade_tile.h"
#include "engines/raster/shade/sky.h"
#include "image/srgb_encoder.h"
#include "image/tone.h"

namespace rakelight::raster {
namespace {

/// [1 << samples] means of the positions of some samples. [px]
struct Middles {
    float x[1 << shading::most_samples], y[1 << shading::most_samples];

    explicit Middles(int samples) {
        const auto positions = sample_positions(samples);
        x[0] = y[0] = 0;
        for (std::uint32_t sample_mask = 1; sample_mask < 1u << samples; ++sample_mask) {
            SamplePosition sum{0, 0};
            for (std::size_t s = 0; s < positions.size(); ++s)
                if (sample_mask >> s & 1u) sum.x += positions[s].x, sum.y += positions[s].y;
            const float scale = float(16 * std::popcount(sample_mask));
            x[sample_mask] = float(sum.x) / scale;
            y[sample_mask] = float(sum.y) / scale;
        }
    }
};

const Middles& middles(int samples) {
    static const Middles of_4(4), of_8(8);
    return samples == 8 ? of_8 : of_4;
}

constexpr std::size_t most_passes = 24;  ///< over the tile, one per draw; with more draws all pixels are opened

/// One tile.
class MultisampledTile {
public:
    MultisampledTile(const TileJob& job, std::size_t tile, TileScratch& scratch)
        : job_(job),
          tile_(tile),
          s_(scratch),
          m_(*scratch.samples),
          samples_(std::size_t(job.front.settings.samples)),
          is_direct_(job.to_srgb8 && !has_marks(job, tile)) {}

    void shade() {
        std::vector<DrawRun> runs;
        find_runs(job_, tile_, runs);
        m_.blends = has_blended(job_, runs);
        split(m_.blends || runs.size() > most_passes);
        fill_background();
        for (std::size_t n = 0; n < m_.open_pixels.size(); ++n) open(n, std::size_t(m_.open_pixels[n]));
        sort_fragments();
        s_.record.assign(job_.binned.offsets[tile_ + 1] - job_.binned.offsets[tile_], -1);
        for (const DrawRun& run : runs) shade_draw(run);
    }

private:
    void fill_background() {
        const vec4 background = empty_pixel(job_.front.settings);
        if (has_sky(job_.front.list)) {
            if (is_direct_) put_sky(job_, tile_, m_.whole.data(), s_);
            if (!is_direct_ || !m_.open_pixels.empty()) fill_sky(job_, tile_, s_.color, s_);
            return;
        }
        if (!is_direct_) return std::fill(s_.color.begin(), s_.color.end(), background);
        const std::uint32_t value = display_value(background);
        for (std::size_t y = 0; y < tile_size; ++y)
            std::fill_n(s_.display.first + y * s_.display.stride, tile_size, value);
    }

    /// Which pixels are one triangle's, or the background's.
    void split(bool open_all) {
        std::uint32_t differs[tile_pixels] = {};
        const std::int32_t* const first = m_.visible.data();
        for (std::size_t s = 1; s < samples_; ++s) {
            const std::int32_t* const other = first + s * tile_pixels;
            for (std::size_t p = 0; p < tile_pixels; ++p) differs[p] |= std::uint32_t(first[p] ^ other[p]);
        }
        m_.found.clear();
        m_.open_pixels.clear();
        std::uint64_t covered = 0;
        for (std::size_t p = 0; p < tile_pixels; ++p) {
            const bool opens = open_all || differs[p] != 0;
            m_.whole[p] = opens ? is_open : first[p];
            covered += std::uint64_t(!opens && first[p] >= 0);
            if (opens) m_.open_pixels.push_back(std::int32_t(p));
        }
        s_.covered += covered;
        s_.samples_covered += covered * samples_;
        m_.color.resize(std::max(m_.color.size(), m_.open_pixels.size() * samples_));
    }

    /// The fragments of a pixel that is not.
    void open(std::size_t number, std::size_t p) {
        m_.number[p] = std::int32_t(number);
        std::uint32_t left = (1u << samples_) - 1;
        const std::size_t before = m_.found.size();
        while (left != 0) {
            const std::int32_t position = m_.visible[std::size_t(std::countr_zero(left)) * tile_pixels + p];
            std::uint32_t sample_mask = 0;
            for (std::size_t s = 0; s < samples_; ++s)
                sample_mask |= std::uint32_t(m_.visible[s * tile_pixels + p] == position) << s;
            left &= ~sample_mask;
            if (position >= 0) {
                m_.found.push_back({position, std::uint16_t(p), std::uint16_t(sample_mask)});
                s_.samples_covered += std::uint64_t(std::popcount(sample_mask));
            } else {
                put(number, sample_mask, has_sky(job_.front.list) ? s_.color[p] : empty_pixel(job_.front.settings));
            }
        }
        s_.covered += std::uint64_t(m_.found.size() > before);
    }

    void put(std::size_t number, std::uint32_t sample_mask, vec4 color) {
        vec4* const to = &m_.color[number * samples_];
        for (; sample_mask != 0; sample_mask &= sample_mask - 1) to[std::countr_zero(sample_mask)] = color;
    }

    /// By position in the tile's list, so also draw by draw; those of one triangle in the order of the pixels.
    void sort_fragments() {
        const std::size_t list = job_.binned.offsets[tile_ + 1] - job_.binned.offsets[tile_];
        m_.first.assign(list + 2, 0);
        for (const Fragment& f : m_.found) ++m_.first[std::size_t(f.position) + 2];
        for (std::size_t i = 2; i < list + 2; ++i) m_.first[i] += m_.first[i - 1];
        m_.fragments.resize(m_.found.size());
        for (const Fragment& f : m_.found) m_.fragments[m_.first[std::size_t(f.position) + 1]++] = f;
    }

    void shade_draw(const DrawRun& run) {
        const std::size_t begin = m_.first[std::size_t(run.begin)], end = m_.first[std::size_t(run.end)];
        const bool has_whole = m_.open_pixels.size() < tile_pixels;
        const auto count = has_whole ? std::size_t(job_.front.kernels.collect(m_.whole.data(), run.begin, run.end,
                                                                              s_.pixel.data(), s_.list_position.data()))
                                     : 0;
        if (count == 0 && begin == end) return;
        s_.wanted.clear();
        if (count > 0) find_wanted(job_, tile_, count, s_);
        for (std::size_t i = begin; i < end; ++i) record_of(m_.fragments[i].position);
        make_records(job_, run.draw, s_.wanted, job_.grid.origin_x(tile_), job_.grid.origin_y(tile_), s_);
        if (count > 0) shade_whole(run.draw, count);
        for (std::size_t i = begin; i < end; i += tile_pixels)
            shade_fragments(run.draw, i, std::min(end - i, std::size_t(tile_pixels)));
    }

    std::int32_t record_of(std::int32_t position) {
        std::int32_t& record = s_.record[std::size_t(position)];
        if (record < 0) {
            record = std::int32_t(s_.wanted.size());
            s_.wanted.push_back(job_.binned.items[job_.binned.offsets[tile_] + std::size_t(position)]);
        }
        return record;
    }

    ShadeJob batch_of(std::uint32_t draw, std::size_t count) {
        const ShadeJob batch = make_job(job_, draw, job_.grid.origin_x(tile_), job_.grid.origin_y(tile_), count, s_);
        s_.shaded += count;
        if (!batch.unlit && !batch.lit) s_.lit_pixels += count;
        return batch;
    }

    void shade_whole(std::uint32_t draw, std::size_t count) {
        ShadeJob batch = batch_of(draw, count);
        if (is_direct_) batch.display = display_pixels(s_);
        if (job_.occlusion) job_.occlusion->give(batch, s_);
        s_.not_finite += std::uint64_t(shade_with_lists(job_.kernels, job_.reach, batch, s_));
        for (std::size_t i = 0; i < count && !is_direct_; ++i)
            s_.color[std::size_t(s_.pixel[i])] = {s_.red[i], s_.green[i], s_.blue[i], 1.0f};
    }

    void shade_fragments(std::uint32_t draw, std::size_t first, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) {
            const Fragment& f = m_.fragments[first + i];
            s_.pixel[i] = f.pixel;
            s_.batch_triangle[i] = s_.record[std::size_t(f.position)];
            move_to_middle(int(samples_), f.samples, i, s_);
        }
        ShadeJob batch = batch_of(draw, count);
        use_offsets(batch, s_);
        if (job_.occlusion)
            job_.occlusion->give_to_fragments(batch, job_.grid.origin_x(tile_), job_.grid.origin_y(tile_), s_);
        s_.not_finite += std::uint64_t(shade_with_lists(job_.kernels, job_.reach, batch, s_));
        for (std::size_t i = 0; i < count; ++i)
            put(std::size_t(m_.number[std::size_t(s_.pixel[i])]), m_.fragments[first + i].samples,
                {s_.red[i], s_.green[i], s_.blue[i], 1.0f});
    }

    const TileJob& job_;
    const std::size_t tile_;
    TileScratch& s_;
    SampleScratch& m_;
    const std::size_t samples_;
    const bool is_direct_;  ///< whole pixels come out of the kernel as sRGB
};

}  // namespace

void use_offsets(ShadeJob& batch, TileScratch& s) {
    batch.offset_x = s.offset_x.data(), batch.offset_y = s.offset_y.data();
}

void move_to(SamplePosition at, std::size_t count, ShadeJob& batch, TileScratch& s) {
    std::fill_n(s.offset_x.begin(), count, float(at.x) / 16);
    std::fill_n(s.offset_y.begin(), count, float(at.y) / 16);
    use_offsets(batch, s);
}

vec2 middle_of(int samples, std::uint32_t sample_mask) {
    const Middles& m = middles(samples);
    return {m.x[sample_mask], m.y[sample_mask]};
}

void move_to_middle(int samples, std::uint32_t sample_mask, std::size_t i, TileScratch& s) {
    s.offset_x[i] = middles(samples).x[sample_mask];
    s.offset_y[i] = middles(samples).y[sample_mask];
}

void find_visible_samples(const TileJob& job, std::size_t tile, TileScratch& s) {
    if (job.front.settings.channels != 0 || has_marks(job, tile)) find_visible(job, tile, s);
    s.depth_passes = 0;
    if (!s.samples) s.samples = std::make_shared<SampleScratch>();
    SampleScratch& m = *s.samples;
    const auto positions = sample_positions(job.front.settings.samples);
    m.depth.resize(positions.size() * tile_pixels);
    m.visible.resize(positions.size() * tile_pixels);
    for (std::size_t i = 0; i < positions.size(); ++i)
        find_visible_at({positions[i], &m.depth[i * tile_pixels], &m.visible[i * tile_pixels]}, job, tile, s);
}

void shade_samples(const TileJob& job, std::size_t tile, TileScratch& s) {
    if (job.front.settings.channels & ~std::uint32_t(channel_depth))
        shade_opaque(job, tile, s);
    else if (job.occlusion)
        job.occlusion->find(job, tile, s);
    if (job.front.settings.channels & channel_overdraw) count_overdraw(job, tile, s);
    s.covered = s.samples_covered = s.shaded = s.lit_pixels = s.not_finite = 0;  // counted in the picture alone
    MultisampledTile(job, tile, s).shade();
}

}  // namespace rakelight::raster
