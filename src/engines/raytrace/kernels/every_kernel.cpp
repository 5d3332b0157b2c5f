// SPDX-License-Identifier: Apache-2.0
// The kernel of all that a job can ask for. Compiled once per instruction set.
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
        store(job->alpha + i, cpu::shown_alpha(material, b.of[0].bumps, alpha));
    }
}

}  // namespace rakelight::raytrace::RL_ISA
