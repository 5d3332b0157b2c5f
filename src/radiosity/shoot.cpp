// SPDX-License-Identifier: Apache-2.0
#include "radiosity/shoot.h"

#include <algorithm>

#include "math/linear.h"
#include "shading/lights/luminance.h"

namespace rakelight::radiosity {
namespace {

using shading::luminance_of;

constexpr std::size_t max_shots_a_patch = 50;
constexpr std::size_t receivers_a_task = 64;
/// Weight of emitting patches relative to reflecting ones.
constexpr double emitter_weight = 64;

dvec3 reflected(dvec3 albedo, dvec3 light) { return albedo * light; }

class Shooter {
public:
    Shooter(const Elements& elements, const Patches& patches, const FormFactors& form_factors,
            const DirectLight& direct, Context& context)
        : elements_(elements),
          patches_(patches),
          form_factors_(form_factors),
          context_(context),
          charge_(context.memory()),
          rows_(patches.list.size()) {
        for (const Patch& patch : patches.list) add_receivers(patch);
        received_.resize(patches.list.size());
        unshot_.resize(patches.list.size());
        context.parallel_for(patches.list.size(), [&](std::size_t p) {
            unshot_[p] = patches_.list[p].emission;
            if (!direct.empty()) received_[p] = mean_direct(patches_.list[p], direct);
            unshot_[p] += reflected(albedo_[p], received_[p]);
        });
    }

    std::vector<dvec3> run(double share, RadiosityReport& report) {
        for (std::size_t p = 0; p < unshot_.size(); ++p)
            report.emitted += power(p, patches_.list[p].emission) + power(p, received_[p]);
        double left = sum_of_unshot();
        const double first = left;
        for (; report.shots < max_shots_a_patch * unshot_.size() && left > share * report.emitted; ++report.shots) {
            context_.throw_if_cancelled();
            report.escaped += shoot(brightest());
            left = sum_of_unshot();
            if (report.shots % 64 == 0 && first > 0) context_.progress("radiosity: shots", 1 - left / first);
        }
        std::vector<dvec3> radiance(unshot_.size());
        report.unshot = left;
        for (std::size_t p = 0; p < radiance.size(); ++p) {
            const dvec3 back = reflected(albedo_[p], received_[p]);
            radiance[p] = patches_.list[p].emission + back;
            report.absorbed += power(p, received_[p]) - power(p, back);
        }
        return radiance;
    }

private:
    struct Range {
        std::uint32_t begin, end;
    };

    /// Four points on a triangle, as in DirectLight; for several triangles the centers of four.
    void add_receivers(const Patch& patch) {
        const std::span<const std::uint32_t> members = patches_.of(patch);
        const auto begin = std::uint32_t(receivers_.size());
        dvec3 albedo{};
        for (const std::uint32_t i : members) albedo += elements_.list[i].albedo * elements_.list[i].area;
        albedo_.push_back(albedo / patch.area);
        const Element& e = elements_.list[members[0]];
        if (members.size() == 1) {
            receivers_.push_back(receiver_of(e));
            for (const dvec3 corner : e.corner)
                receivers_.push_back({e.center + (corner - e.center) * 0.5, e.normal, e.face_normal});
        } else {
            const std::size_t count = std::min<std::size_t>(members.size(), 4);
            for (std::size_t k = 0; k < count; ++k)
                receivers_.push_back(receiver_of(elements_.list[members[(2 * k + 1) * members.size() / (2 * count)]]));
        }
        ranges_.push_back({begin, std::uint32_t(receivers_.size())});
    }

    dvec3 mean_direct(const Patch& patch, const DirectLight& direct) const {
        dvec3 sum{};
        for (const std::uint32_t i : patches_.of(patch)) sum += direct(elements_.list[i]) * elements_.list[i].area;
        return sum / patch.area;
    }

    double power(std::size_t patch, dvec3 radiance) const {
        return pi * patches_.list[patch].area * luminance_of(radiance);
    }

    double sum_of_unshot() const {
        double sum = 0;
        for (std::size_t p = 0; p < unshot_.size(); ++p) sum += power(p, unshot_[p]);
        return sum;
    }

    std::uint32_t brightest() const {
        std::uint32_t best = 0;
        double most = -1;
        for (std::uint32_t p = 0; p < unshot_.size(); ++p)
            if (const double here = power(p, unshot_[p]); here > most) most = here, best = p;
        return best;
    }

    /// [receivers] form factors from each to a patch; computed at its first shot.
    const std::vector<float>& row(std::uint32_t patch) {
        std::vector<float>& row = rows_[patch];
        if (!row.empty()) return row;
        charge_.grow(receivers_.size() * sizeof(float), "form factors");
        row.resize(receivers_.size());
        const double weight = patches_.list[patch].emission == dvec3{} ? 1 : emitter_weight;
        context_.parallel_for((row.size() + receivers_a_task - 1) / receivers_a_task, [&](std::size_t task) {
            const std::size_t end = std::min(row.size(), (task + 1) * receivers_a_task);
            for (std::size_t r = task * receivers_a_task; r < end; ++r)
                row[r] = float(form_factors_(receivers_[r], patch, weight));
        });
        return row;
    }

    /// @return the escaped power
    double shoot(std::uint32_t shooter) {
        const std::vector<float>& factors = row(shooter);
        const dvec3 light = unshot_[shooter];
        double left = power(shooter, light);
        unshot_[shooter] = {};
        for (std::size_t p = 0; p < ranges_.size(); ++p) {
            double sum = 0;
            for (std::uint32_t r = ranges_[p].begin; r < ranges_[p].end; ++r) sum += double(factors[r]);
            if (!(sum > 0)) continue;
            const dvec3 arrives = light * (sum / (ranges_[p].end - ranges_[p].begin));
            received_[p] += arrives;
            unshot_[p] += reflected(albedo_[p], arrives);
            left -= power(p, arrives);
        }
        return left;
    }

    const Elements& elements_;
    const Patches& patches_;
    const FormFactors& form_factors_;
    Context& context_;
    MemoryCharge charge_;                   ///< of the rows
    std::vector<std::vector<float>> rows_;  ///< [patches], empty: has not shot
    std::vector<Receiver> receivers_;
    std::vector<Range> ranges_;             ///< [patches] of receivers
    std::vector<dvec3> albedo_;             ///< [patches]
    std::vector<dvec3> received_, unshot_;  ///< [patches] irradiance / pi; radiance
};

}  // namespace

std::vector<dvec3> shoot(const Elements& elements, const Patches& patches, const FormFactors& form_factors,
                         const DirectLight& direct, double unshot, RadiosityReport& report, Context& context) {
    return Shooter(elements, patches, form_factors, direct, context).run(unshot, report);
}

}  // namespace rakelight::radiosity
