// SPDX-License-Identifier: Apache-2.0
#include "radiosity/gather.h"

#include <algorithm>
#include <atomic>

#include "math/linear.h"
#include "shading/lights/luminance.h"

namespace rakelight::radiosity {

Gather::Gather(const Patches& patches, std::vector<dvec3> radiance, const FormFactors& form_factors,
               const DirectLight& direct)
    : radiance_(std::move(radiance)), form_factors_(form_factors), direct_(direct) {
    double area = 0, sum = 0;
    for (std::uint32_t p = 0; p < radiance_.size(); ++p) {
        area += patches.list[p].area;
        sum += patches.list[p].area * shading::luminance_of(radiance_[p]);
        if (!(radiance_[p] == dvec3{})) bright_.push_back(p);
    }
    mean_ = area > 0 ? sum / area : 0;
    for (const dvec3 light : radiance_) weight_.push_back(mean_ > 0 ? shading::luminance_of(light) / mean_ : 1);
}

dvec3 Gather::operator()(const Element& element) const {
    if (!(element.area > 0)) return {};
    dvec3 sum = direct_(element);
    const Receiver receiver = receiver_of(element);
    for (const std::uint32_t p : bright_) sum += radiance_[p] * form_factors_(receiver, p, weight_[p]);
    return sum;
}

void gather_all(const Elements& elements, const Gather& gather, std::vector<dvec3>& light,
                const std::vector<std::uint32_t>& wanted, Context& context) {
    constexpr std::size_t step = 16;
    const std::size_t tasks = (wanted.size() + step - 1) / step;
    std::atomic<std::size_t> done{0};
    context.parallel_for(tasks, [&](std::size_t task) {
        for (std::size_t i = task * step; i < std::min(wanted.size(), (task + 1) * step); ++i)
            light[wanted[i]] = gather(elements.list[wanted[i]]);
        if (const std::size_t n = ++done; n % 32 == 0) context.progress("radiosity: light", double(n) / double(tasks));
    });
}

}  // namespace rakelight::radiosity
