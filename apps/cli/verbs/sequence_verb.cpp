// SPDX-License-Identifier: Apache-2.0
#include "sequence_verb.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <memory>
#include <set>

#include <rakelight/io/movie.h>
#include <rakelight/render/sequence.h>
#include <rakelight/tools/rows.h>
#include <rakelight/world/values.h>
#include <rakelight_internal/base/file_ending.h>
#include <rakelight_internal/io/folder_lock.h>

#include "../../common/interrupt.h"
#include "../output_names.h"
#include "../run_file.h"
#include "../stats_text.h"

namespace rakelight::cli {

std::vector<Option> sequence_options() {
    constexpr const char* group = "Sequences";
    return {{"frames", group, "A:B[:STEP]",
             "Draw frames A to B of a clip (--animation-name; default: the first) or of --turntable, numbered from 0 "
             "(default: all; A: ends with the last)"},
            {"fps", group, "F", "Frames per second of the clip and of movies (default 30)"},
            {"turntable", group, "N", "N frames of one turn of the model, to the right; a named clip plays meanwhile"},
            {"movie", group, "FILE",
             "Also make a movie of the frames: .mp4 .webm .gif (by the program ffmpeg), .apng .webp (lossless)",
             apps::Form::list},
            {"skip-existing", group, "", "Skip frames whose pictures exist and are whole: continues an interrupted run",
             apps::Form::flag},
            {"keep-frames", group, "", "If -o is a movie, keep its frames in FILE.frames/", apps::Form::flag}};
}

namespace {

namespace fs = std::filesystem;

constexpr double least_fps = 0.01;  ///< of movies

/// The sequence of one input, and its outputs.
struct Job {
    InputRequest input;
    SequenceRequest sequence;
    std::vector<std::string> movies;
    bool is_numbered_anew = false;  ///< the output had no number
};

/// -o names a movie, not pictures.
bool is_movie_output(const Run& run) { return is_movie(run.picture.output) && !has_frame_number(run.picture.output); }

std::int64_t number_of(std::string_view word) {
    std::int64_t number = -1;
    const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (fault != std::errc{} || end != word.data() + word.size() || number < 0 || number >= max_frames)
        throw values::wrong("frames", "must be A:B or A:B:STEP, numbers from 0 to " + std::to_string(max_frames - 1),
                            "write for example 0:59");
    return number;
}

FrameRange range_of(const std::string& text) {
    const std::vector<std::string_view> words = values::split(text, ':');
    FrameRange range;
    range.first = number_of(words[0]);
    if (words.size() == 1) range.last = range.first;
    if (words.size() > 1 && !words[1].empty()) range.last = number_of(words[1]);
    if (words.size() > 2) range.step = number_of(words[2]);
    if (words.size() > 3) number_of("");
    return range;
}

/// "out.png" -> "out.{frame:4}.png"
std::string with_number(const std::string& output) {
    const fs::path path(output);
    return (path.parent_path() / (path.stem().string() + ".{frame:4}" + path.extension().string())).string();
}

void refuse_others(const Run& run) {
    for (const char* const other : {"watch", "ref", "reference", "keep-partial"})
        if (run.given.has(other))
            throw Error(ErrorCode::usage, "applies to single pictures, but a sequence is requested").about(other);
    for (const std::string& movie : run.given.words("movie"))
        if (has_frame_number(movie))
            throw Error(ErrorCode::usage, "a movie has all pictures, so its name has no {frame}").about("movie");
    if (is_standard_output(run.picture.output))
        throw Error(ErrorCode::usage, "a sequence needs output files", {},
                    "write -o 'out/{frame:4}.png' or -o FILE.mp4");
}

void check_movies(const Job& job) {
    const RenderSettings& s = job.sequence.picture.settings;
    const bool has_window = s.window.width > 0;
    std::set<std::string> names;
    for (const std::string& movie : job.movies) {
        check_movie(movie, {has_window ? s.window.width : s.width, has_window ? s.window.height : s.height,
                            s.background.w < 1});
        if (!names.insert(fs::path(movie).lexically_normal().string()).second)
            throw Error(ErrorCode::usage, "the movie is named twice").with_file(movie);
    }
    if (const double fps = job.sequence.fps / double(std::max<std::int64_t>(job.sequence.frames.step, 1));
        !job.movies.empty() && fps < least_fps)
        throw Error(ErrorCode::usage, "leaves a movie with fewer than 0.01 frames per second").about("frames", {"fps"});
    if (!job.movies.empty() && file_ending(job.sequence.picture.output) != "png")
        throw Error(ErrorCode::usage, "movies are made of PNG pictures", {},
                    "let -o end in .png, or name the movie there")
            .about("movie", {"output"});
}

std::vector<Job> jobs_of(const Run& run) {
    std::vector<Job> jobs;
    std::vector<OutputNames> movie_names;
    for (const std::string& movie : run.given.words("movie")) movie_names.emplace_back(run, run.inputs.size(), movie);
    for (InputRequest& input : picture_requests(run, {})) {
        Job& job = jobs.emplace_back();
        PictureRequest& picture = input.picture;
        if (is_movie_output(run)) {
            job.movies.push_back(frame_name(picture.output, 0));  // which has no number
            picture.output += ".frames/{frame:4}.png";
        } else if (!has_frame_number(picture.output)) {
            picture.output = with_number(picture.output);
            job.is_numbered_anew = true;
        }
        for (OutputNames& names : movie_names)
            job.movies.push_back(names.of(picture.input, {.camera = camera_of(picture)}));
        SequenceRequest& sequence = job.sequence;
        sequence.picture = picture;
        if (run.given.has("frames")) sequence.frames = range_of(run.given.word("frames"));
        if (run.given.has("fps")) sequence.fps = values::number("fps", run.given.word("fps"), 0.01, 1000);
        if (run.given.has("turntable"))
            sequence.turntable = values::integer("turntable", run.given.word("turntable"), 1, int(max_frames));
        sequence.skip_existing = run.given.has("skip-existing");
        job.input = std::move(input);
        if (job.input.error) continue;
        check_sequence(sequence);
        check_movies(job);
    }
    return jobs;
}

/// The pictures of a movie that is whole, and their folder where nothing else is in it.
void remove_frames(const std::vector<PictureRow>& rows) {
    std::error_code ignored;
    for (const PictureRow& row : rows) fs::remove(row.result.output, ignored);
    if (!rows.empty()) fs::remove(fs::path(rows[0].result.output).parent_path(), ignored);
}

/// The pictures of a movie go into a folder of their own, and are removed with it in the end: no other process may work there.
std::unique_ptr<FolderLock> lock_frames(const Run& run, const Job& job) {
    if (!is_movie_output(run)) return {};
    const fs::path first = frame_name(job.sequence.picture.output, 0);
    try {
        return std::make_unique<FolderLock>(first.parent_path().string());
    } catch (const Error& error) {
        throw error.advising("wait for its end, or give -o another name");
    }
}

/// The pictures and movies of one job.
struct Made {
    std::vector<PictureRow> pictures, movies;
};

void draw(const Run& run, const Job& job, Made& made, Context& context) {
    const auto keep = [&](const SequenceFrame& frame) {
        PictureRow& row = made.pictures.emplace_back();
        row.result = frame.picture;
        row.frame = FrameRow{frame.frame, frame.time_s, frame.is_skipped};
        if (frame.is_skipped) return;
        print_note(summary(frame.picture), run.loudness);
        if (run.given.has("stats") && !run.is_json) print_text(stats_text(frame.picture));
    };
    try {
        render_sequence(job.sequence, context, keep);
    } catch (const Error& error) {
        if (!context.cancelled() || made.pictures.empty()) throw;
        throw Error(ErrorCode::failed, "cancelled: " + std::to_string(made.pictures.size()) + " pictures are complete",
                    {}, "repeat the command with --skip-existing to continue");
    }
}

void make_movies(const Run& run, const Job& job, Made& made, Context& context) {
    std::vector<std::string> files;
    for (const PictureRow& row : made.pictures) files.push_back(row.result.output);
    context.set_progress_range(0, 1);
    for (const std::string& movie : job.movies) {
        try {
            // Every second picture stands twice as long.
            write_movie(movie, files, job.sequence.fps / double(job.sequence.frames.step), context);
        } catch (const Error& error) {
            throw error.advising((error.advice().empty() ? "" : "; ") + std::string("the pictures are complete: ") +
                                 files[0]);
        }
        PictureRow& row = made.movies.emplace_back();
        row.result.file = job.sequence.picture.input, row.result.output = movie;
        row.movie_pictures = files.size();
        print_note(movie + ": " + std::to_string(files.size()) + " pictures", run.loudness);
    }
    if (is_movie_output(run) && !run.given.has("keep-frames")) remove_frames(made.pictures);
}

/// The rows of one job: pictures, movies, and what went wrong.
void add_rows(std::vector<PictureRow>& rows, Made made, PictureRow whole) {
    std::vector<PictureRow>& all = made.pictures;
    all.insert(all.end(), made.movies.begin(), made.movies.end());
    if (!all.empty() && !whole.error) all[0].remarks = whole.remarks, all[0].remarks_left_out = whole.remarks_left_out;
    if (whole.error) all.push_back(std::move(whole));
    rows.insert(rows.end(), all.begin(), all.end());
}

}  // namespace

bool asks_sequence(const Run& run) {
    const bool plays_clip = !run.given.first_of({"animation-name", "animation-index"}).empty() &&
                            run.given.first_of({"animation-time", "watch"}).empty();
    const bool is_asked = !run.given.first_of({"frames", "fps", "turntable", "movie"}).empty() ||
                          (plays_clip && has_frame_number(run.picture.output));
    const bool is_webp = file_ending(run.picture.output) == "webp";  // alone it is a picture
    if (is_asked || (is_movie_output(run) && !is_webp)) return true;
    if (const std::string_view how = run.given.first_of({"skip-existing", "keep-frames"}); !how.empty())
        throw Error(ErrorCode::usage, "applies to sequences, but none is requested", {},
                    "add 'frames', 'turntable' or 'movie'")
            .about(std::string(how), {"frames", "turntable", "movie"});
    if (has_frame_number(run.picture.output) && !run.given.has("watch"))
        throw Error(ErrorCode::usage, "{frame} numbers the pictures of a sequence, but none is requested", {},
                    "name a clip, or add --turntable, --frames or --watch")
            .about("output", {"turntable", "frames"});
    return false;
}

int run_sequence(const Run& run) {
    refuse_others(run);
    std::vector<PictureRow> rows;
    int worst = 0;
    for (const Job& job : jobs_of(run)) {
        PictureRow whole;
        whole.result.file = job.sequence.picture.input, whole.result.output = job.sequence.picture.output;
        if (CancelOnInterrupt::happened()) {
            whole.error = Error(ErrorCode::failed, "cancelled").with_file(whole.result.file);
            rows.push_back(std::move(whole));
            continue;
        }
        Made made;
        const int code = run_input(run, job.input, whole, [&](Context& context) {
            if (job.is_numbered_anew)
                context.report().add(
                    Remark::note, job.sequence.picture.input, "",
                    "the pictures are numbered: " + frame_name(job.sequence.picture.output, job.sequence.frames.first) +
                        " and so on");
            const auto lock = lock_frames(run, job);
            draw(run, job, made, context);
            make_movies(run, job, made, context);
        });
        worst = std::max(worst, code);
        add_rows(rows, std::move(made), std::move(whole));
    }
    if (run.is_json) print_data(to_json(rows));
    return worst;
}

}  // namespace rakelight::cli
