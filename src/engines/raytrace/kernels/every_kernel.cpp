// SPDX-License-Identifier: Apache-2.0
// The kernel of all that a job can ask for. Compiled once per instruction set.
#include "cpu_shading/kernels/channels.h"
#include "engines/raytrace/kernels/shade_hits.h"

namespace rakelight::raytrace::RL_ISA {

int32_t shade_every(const HitJob& job) { return shade_hits<cpu::EveryMaterial, 1>(job); }

void alpha(const HitJob* job) {
    const cpu::Job<cpu::EveryMaterial> material{*job};
    for (int32_t i = 0; i < job->count; i += lanes) {
        HitSource<1> source(*job, i);
        cpu::Points<cpu::EveryMaterial, 1> b;
        b.count = 1;
        cpu::find_places(material, source, b);
        const real alpha = cpu::find_base_color(material, source, 0, b.of[0].point).color.w;
        store(job->alpha + i, cpu::alpha_in_silhouette(material, b.of[0].bumps, alpha));
    }
}

void through(const HitJob* job) {
    const EveryJob material{*job};
    for (int32_t i = 0; i < job->count; i += lanes) {
        HitSource<1> source(*job, i);
        cpu::Points<cpu::EveryMaterial, 1> b;
        b.count = 1;
        cpu::find_places(material, source, b);
        EveryPoint& s = b.of[0];
        s.base = cpu::find_base_color(material, source, 0, s.point);
        const vec3 share = straight_through(material, *job, source.hits[0], s);
        store(job->red + i, share.x), store(job->green + i, share.y), store(job->blue + i, share.z);
    }
}

/// One vector of hits with all that is known of it.
struct WholeHits : cpu::WholePoints<HitSource<1>> {
    using WholePoints::WholePoints;
    SeenByRays<cpu::EveryMaterial, 1> seen() const { return {source.job, source}; }
};

static void put3(float* const (&to)[3], int32_t i, vec3 v) {
    store(to[0] + i, v.x);
    store(to[1] + i, v.y);
    store(to[2] + i, v.z);
}

void channels(const ChannelJob* job) {
    if (job->needs_values != 0) cpu::find_channels<WholeHits, HitSource<1>>(*job->hits, *job);
    for (int32_t i = 0; i < job->hits->count; i += lanes) {
        Hits h;
        h.find(*job->hits, i);
        store(job->depth + i, h.t);
        if (job->face_normal[0] != nullptr) put3(job->face_normal, i, HitSource<1>::face_normal(h));
        if (job->normal[0] == nullptr) continue;
        const WholeHits p(*job->hits, i);
        put3(job->normal, i, p.state().surface.base.n);
    }
}

}  // namespace rakelight::raytrace::RL_ISA
