// SPDX-License-Identifier: Apache-2.0
#include "bench_verb.h"

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>

#include "console.h"
#include "interrupt.h"
#include "options.h"
#include "values.h"

namespace rakelight::cli {
namespace {

// A whole number; k and M stand for thousands and millions.
int count(const char* option, std::string word, int low, int high) {
    std::string zeros;
    if (!word.empty() && (word.back() == 'k' || word.back() == 'K')) zeros = "000";
    if (!word.empty() && word.back() == 'M') zeros = "000000";
    if (!zeros.empty()) word.pop_back();
    return int(integer(option, word + zeros, low, high));
}

// Words separated by commas.
void add_rows(const std::string& words, SmoothBenchOptions& o) {
    for (std::size_t first = 0; first <= words.size();) {
        const std::size_t last = std::min(words.find(',', first), words.size());
        const int row = word<int>("--with", words.substr(first, last - first),
                                  {{"crease", 1}, {"tolerance", 2}, {"order", 4}, {"plan", 8}, {"all", 15}});
        o.crease |= (row & 1) != 0;
        o.tolerance |= (row & 2) != 0;
        o.order |= (row & 4) != 0;
        o.plan |= (row & 8) != 0;
        first = last + 1;
    }
}

// [bytes] All of it; as much as can be asked for where the system does not say.
std::uint64_t memory_of_machine() {
    const long pages = ::sysconf(_SC_PHYS_PAGES), size = ::sysconf(_SC_PAGE_SIZE);
    return pages > 0 && size > 0 ? std::uint64_t(pages) * std::uint64_t(size) : ~std::uint64_t(0);
}

}  // namespace

void add_bench_options(CLI::App& app, BenchWords& w) {
    const char* const group = "Measurement";
    const auto add = [&](const char* name, std::string& word, const char* type, const char* help) {
        app.add_option(name, word, help)->type_name(type)->group(group);
    };
    app.add_option("WHAT", w.what, "What to measure: smooth")->type_name("")->required();
    add("--triangles", w.triangles, "N", "Size of the model, a displaced sphere; 100k, 10M (default 1M)");
    add("--objects", w.objects, "N", "Objects that it is cut into (default 16)");
    add("--order", w.order, "ORDER", "coherent (default) or shuffled triangles and vertices");
    add("--weight", w.weight, "HOW", "uniform (default), area, angle, angle-area");
    add("--crease-angle,--crease", w.crease_angle, "DEG", "Edges bent more than this stay sharp (default 180)");
    add("--tolerance", w.tolerance, "X", "Weld within X edge lengths, up to 0.25 (default 0: exact)");
    add("--repetitions", w.repetitions, "N", "Counted runs of each row (default 10)");
    add("--with", w.with, "ROWS",
        "Also measure: crease (60 degrees), tolerance (0.1), order (the other one), plan (group, accumulate, regroup); all");
    app.add_flag("--brute-force", w.brute_force, "Also every vertex against every face, up to 50k triangles")
        ->group(group);
}

void apply(const BenchWords& w, SmoothBenchOptions& o) {
    if (w.what != "smooth") throw Error(ErrorCode::usage, "bench measures smooth, not '" + one_line(w.what, 80) + "'");
    o.triangles =
        w.triangles.empty() ? 1'000'000 : std::uint64_t(count("--triangles", w.triangles, 100, 1'000'000'000));
    if (!w.objects.empty()) o.objects = std::uint32_t(count("--objects", w.objects, 1, 100'000));
    if (!w.order.empty()) o.shuffled = word<bool>("--order", w.order, {{"coherent", false}, {"shuffled", true}});
    if (!w.weight.empty())
        o.weight = word<CornerWeight>("--weight", w.weight,
                                      {{"uniform", CornerWeight::uniform},
                                       {"area", CornerWeight::area},
                                       {"angle", CornerWeight::angle},
                                       {"angle-area", CornerWeight::angle_area}});
    if (!w.crease_angle.empty()) o.crease_angle_rad = radians(number("--crease-angle", w.crease_angle));
    if (!w.tolerance.empty()) o.weld_distance = number("--tolerance", w.tolerance);
    if (!w.repetitions.empty()) o.repetitions = std::uint32_t(count("--repetitions", w.repetitions, 1, 1000));
    if (!w.with.empty()) add_rows(w.with, o);
    o.brute_force = w.brute_force;
}

int run_bench(const Options& options) {
    ProgressLine progress("bench", options.loudness);
    // The model is the program's own: no file asks for memory here. What the machine has not is refused, for a model that is
    // too large is not told so by the system: the process is ended.
    const std::uint64_t wanted = options.bench.triangles * (options.bench.order ? 500 : 400) + (1u << 30);
    const std::uint64_t memory = options.max_memory != 0 ? options.max_memory : std::min(wanted, memory_of_machine());
    Context context({.threads = options.threads, .max_memory = memory, .progress = progress.callback()});
    const CancelOnInterrupt guard(context);
    const SmoothBenchReport report = bench_smooth(options.bench, context);
    progress.wipe();
    print_data(options.json ? to_json(report) : to_text(report));
    return 0;
}

}  // namespace rakelight::cli
