// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <filesystem>

#include <rakelight/tools/compare.h>
#include <rakelight/tools/rows.h>
#include <rakelight/world/values.h>
#include <rakelight/world/world_request.h>
#include <rakelight_internal/base/file_ending.h>
#include <rakelight_internal/render/draw_alike.h>
#include <rakelight_internal/tools/compare_page.h>

#include "../../common/interrupt.h"
#include "../../common/picture_options.h"
#include "../run_file.h"
#include "compare_pairs.h"
#include "help_texts.h"
#include "verbs.h"

namespace rakelight::cli {
namespace {

/// A limit: past it the exit code is 5.
struct Limit {
    const char *name, *type, *help;
    std::optional<double> CompareLimits::*limit;
};
constexpr Limit limits[] = {
    {"max-error", "V", "Largest allowed difference of a component, 0 to 1", &CompareLimits::max_error},
    {"max-rmse", "V", "Largest allowed root-mean-square difference", &CompareLimits::max_rmse},
    {"min-psnr", "DB", "Smallest allowed peak signal-to-noise ratio, in decibels", &CompareLimits::min_psnr_db},
    {"min-ssim", "V", "Smallest allowed mean structural similarity, -1 to 1 (equal)", &CompareLimits::min_ssim},
    {"max-flip", "V", "Largest allowed mean FLIP, 0 (equal) to 1", &CompareLimits::max_flip},
    {"max-differing", "V", "Largest allowed fraction of differing pixels, 0 to 1", &CompareLimits::max_differing_share},
};

constexpr Word<DifferenceKind> kinds[] = {{"flip", DifferenceKind::flip}, {"absolute", DifferenceKind::absolute}};

std::vector<Option> own_options() {
    std::vector<Option> options = {
        {.name = "output",
         .group = "Output",
         .type = "FILE",
         .help = "Picture of the difference, or .html: a page with wipe sliders. {model} stands for the name of B",
         .letter = 'o'},
        {.name = "difference",
         .group = "Output",
         .type = "WHAT",
         .help = "What the difference picture shows: flip (default; from 0, dark blue, through green and yellow to 1, "
                 "white) or absolute (|A - B| times the gain). EXR and HDR files hold the values themselves",
         .words = apps::names_of<kinds>},
        {"gain", "Output", "G", "Factor on absolute differences (default 10; EXR and HDR: 1)"},
        {.name = "engines",
         .group = "Compare",
         .type = "LIST",
         .help = "Draw each scene with these engines, such as soft,gl, and compare the first engine with each of the "
                 "others",
         .words = apps::engine_words,
         .takes_several_words = true},
        {"tolerance", "Compare", "T",
         "A pixel counts as differing if a component differs by more than this (default 0)"},
        {"pixels-per-degree", "Compare", "P",
         "FLIP: pixels per degree of the viewer's visual angle, 1 to 1000 (default 67)"},
    };
    for (const Limit& limit : limits)
        options.push_back({limit.name, "Limits (exit code 5 if one is exceeded)", limit.type, limit.help});
    return options;
}

/// "0.01" or "2/255".
double fraction(const std::string& name, const std::string& text) {
    const std::vector<std::string_view> parts = values::split(text, '/');
    if (parts.size() != 2) return values::number(name, text);
    const double divisor = values::number(name, parts[1]);
    if (!(divisor > 0)) throw values::wrong(name, "the divisor must be more than 0");
    return values::number(name, parts[0]) / divisor;
}

struct Settings {
    CompareOptions options;
    CompareLimits limits;
    DifferenceKind kind = DifferenceKind::flip;
    std::optional<double> gain;
    /// Numbers in files are not made larger unless asked for.
    double gain_for(const std::string& output) const {
        const std::string ending = file_ending(output);
        return gain.value_or(ending == "exr" || ending == "hdr" ? 1 : 10);
    }
};

Settings settings_of(const Run& run) {
    const Given& given = run.given;
    Settings s;
    if (given.has("tolerance")) s.options.tolerance = fraction("tolerance", given.word("tolerance"));
    if (!(s.options.tolerance >= 0)) throw values::wrong("tolerance", "must be 0 or more");
    if (given.has("pixels-per-degree"))
        s.options.pixels_per_degree = values::number("pixels-per-degree", given.word("pixels-per-degree"), 1, 1000);
    for (const Limit& limit : limits)
        if (given.has(limit.name)) s.limits.*limit.limit = fraction(limit.name, given.word(limit.name));
    if (given.has("difference")) s.kind = values::word("difference", given.word("difference"), kinds);
    if (given.has("gain")) s.gain = values::number("gain", given.word("gain"));
    if (s.gain && !(*s.gain > 0)) throw values::wrong("gain", "must be more than 0");
    const bool is_picture = !run.picture.output.empty() && !is_page(run.picture.output);
    if (given.has("difference") && !is_picture)
        throw Error(ErrorCode::usage, "applies to a difference picture; pages have both", {}, "write -o difference.png")
            .about("difference");
    if (s.gain && (run.picture.output.empty() || (is_picture && s.kind == DifferenceKind::flip)))
        throw Error(ErrorCode::usage, "applies to absolute differences", {}, "add -o FILE.png --difference absolute")
            .about("gain");
    return s;
}

Pixels pixels_of(const ComparedSide& side, Context& context) {
    if (!side.scene) return read_picture(side.name, context);
    if (side.scene->error) throw *side.scene->error;
    try {
        Pixels pixels;
        render_picture(side.scene->picture, pixels, context);
        return pixels;
    } catch (const Error& error) {
        if (!side.scene->world) throw;
        throw at_world_value(error, *side.scene->world);
    }
}

/// The size of the picture of a scene is not given.
bool has_free_size(const Run& run, const ComparedSide& side) {
    if (!side.scene || run.given.has("resolution") || run.given.has("window")) return false;
    const std::optional<WorldRequest>& world = side.scene->world;
    return !world || std::ranges::find(world->applied, "resolution", &WorldValue::key) == world->applied.end();
}

/// Both scenes in one look, as large as the side whose size is given.
std::pair<Pixels, Pixels> pixels_of_scenes(const Run& run, ComparedSide a, ComparedSide b, Context& context) {
    for (const ComparedSide* side : {&a, &b})
        if (side->scene->error) throw *side->scene->error;
    const auto resize = [](PictureRequest& to, const PictureRequest& from) {
        to.settings.width = from.settings.width, to.settings.height = from.settings.height;
    };
    if (has_free_size(run, a) && !has_free_size(run, b)) resize(a.scene->picture, b.scene->picture);
    if (has_free_size(run, b) && !has_free_size(run, a)) resize(b.scene->picture, a.scene->picture);
    try {
        return draw_alike(a.scene->picture, b.scene->picture, context);
    } catch (const Error& error) {
        for (const ComparedSide* side : {&a, &b}) {
            const bool is_of_side = error.file().empty() || error.file() == side->name;
            if (!is_of_side || !side->scene->world) continue;
            const Error placed = at_world_value(error, *side->scene->world);
            if (!placed.place().empty() && error.place().empty()) throw Error(placed);
        }
        throw;
    }
}

/// Both sides; a scene beside a picture is drawn as large as that.
std::pair<Pixels, Pixels> pixels_of(const Run& run, const ComparedPair& pair, Context& context) {
    const auto drawn_like = [&](ComparedSide side, const Pixels& picture) {
        if (has_free_size(run, side)) {
            side.scene->picture.settings.width = picture.width;
            side.scene->picture.settings.height = picture.height;
        }
        return pixels_of(side, context);
    };
    if (pair.a.scene && pair.b.scene && !run.given.has("engines"))
        return pixels_of_scenes(run, pair.a, pair.b, context);
    const bool draws_a = pair.a.scene && !pair.b.scene, draws_b = pair.b.scene && !pair.a.scene;
    if (draws_a) {
        Pixels b = pixels_of(pair.b, context), a = drawn_like(pair.a, b);
        return {std::move(a), std::move(b)};
    }
    Pixels a = pixels_of(pair.a, context), b = draws_b ? drawn_like(pair.b, a) : pixels_of(pair.b, context);
    return {std::move(a), std::move(b)};
}

/// The titles above two pictures of a page: names without folders, which are private, unless only the folders
/// distinguish them.
PageTitles titles_of(const ComparisonRow& row) {
    const std::string file_a = std::filesystem::path(row.a).filename().string(),
                      file_b = std::filesystem::path(row.b).filename().string();
    const bool needs_folder = file_a == file_b && row.a != row.b;
    const std::string a = title_of(needs_folder ? row.a : file_a, row.engine_a),
                      b = title_of(needs_folder ? row.b : file_b, row.engine_b);
    if (row.a == row.b && row.engine_a != row.engine_b)
        return {one_line(file_a) + ": " + row.engine_a + " and " + row.engine_b, row.engine_a, row.engine_b};
    return {a + " and " + b, a, b};
}

void compare_pair(const Run& run, const ComparedPair& pair, const Settings& settings, ComparisonRow& row,
                  ComparisonPage* page, Context& context) {
    if (pair.error) throw *pair.error;
    auto [a, b] = pixels_of(run, pair, context);
    context.progress("compare", 0);
    const ComparedPictures pictures(std::move(a), std::move(b), settings.options, context);
    if (page) page->add(titles_of(row), pictures, settings.options, settings.gain_for({}));
    if (!pair.output.empty()) {
        save_difference(pictures, settings.kind, settings.gain_for(pair.output), pair.output);
        row.output = pair.output;
    }
    row.comparison = pictures.comparison();
    row.failures = check_limits(*row.comparison, settings.limits);
}

/// One line a limit; returns the exit code.
int print_failures(const ComparisonRow& row) {
    for (const CheckFailure& failure : row.failures)
        print_error(Error(ErrorCode::check_failed, failure.limit + ": " + failure.message)
                        .with_file(title_of(row.b, row.engine_b)));
    return row.failures.empty() ? 0 : exit_code(ErrorCode::check_failed);
}

Command compare_command() {
    return {"compare",
            "Measure how much two pictures differ, or the pictures of two engines",
            compare_footer,
            {{"A B", "Two pictures, two folders of pictures, or two scenes to draw; with --engines, scenes"}},
            apps::joined({own_options(),
                          apps::without(apps::picture_options(), {"channels", "channel-files", "exr-colors"}),
                          {apps::shader_option()},
                          apps::common_options()})};
}

int run_compare(const Run& run) {
    const Settings settings = settings_of(run);
    const std::vector<ComparedPair> pairs = compared_pairs(run);
    run.files->of = pairs.size();
    const bool has_page = is_page(run.picture.output);
    ComparisonPage page;
    std::vector<ComparisonRow> rows;
    int worst = 0;
    for (const ComparedPair& pair : pairs) {
        ComparisonRow& row = rows.emplace_back();
        row.a = pair.a.name, row.b = pair.b.name, row.options = settings.options;
        row.engine_a = pair.a.engine(), row.engine_b = pair.b.engine();
        const std::string name = row.a == row.b ? row.a : row.a + ", " + row.b;
        if (CancelOnInterrupt::happened()) {
            row.error = Error(ErrorCode::failed, "cancelled").with_file(name);
            continue;
        }
        worst = std::max(worst, run_file(run, name, row, [&](Context& c) {
                             compare_pair(run, pair, settings, row, has_page ? &page : nullptr, c);
                         }));
        worst = std::max(worst, print_failures(row));
    }
    const bool has_any = std::ranges::any_of(rows, [](const ComparisonRow& row) { return row.comparison.has_value(); });
    if (has_page && has_any && !CancelOnInterrupt::happened()) {
        page.save(run.picture.output);
        for (ComparisonRow& row : rows) row.output = row.comparison ? run.picture.output : "";
    }
    if (run.is_json)
        print_data(to_json(rows));
    else
        print_text(to_text(rows));
    return worst;
}

}  // namespace

const Verb compare_verb = {compare_command, run_compare};

}  // namespace rakelight::cli
