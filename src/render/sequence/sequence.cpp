// SPDX-License-Identifier: Apache-2.0
// The way of a sequence: load -> which pictures -> look and camera for all -> each picture: scene at its moment, camera, engine, file.
#include <rakelight/render/sequence.h>

#include <algorithm>
#include <new>

#include <rakelight/render/shot.h>
#include <rakelight_internal/base/file_ending.h>

#include "render/draw_shot.h"
#include "render/prepared_scene.h"
#include "render/remarks/too_dark_or_bright.h"
#include "render/sequence/frames_there.h"
#include "render/sequence/sequence_plan.h"
#include "render/sequence/sequence_views.h"
#include "render/sequence/sequence_writer.h"
#include "render/stopwatch.h"

namespace rakelight {
namespace {

class Sequence {
public:
    Sequence(const SequenceRequest& request, Session& session, Context& context)
        : context_(context),
          quiet_({.threads = context.threads(), .max_memory = context.memory().limit(), .parent = &context}),
          session_(session),
          request_(request.picture),
          skips_existing_(request.skip_existing),
          loaded_(std::make_shared<const Scene>(load(request_.input, request_.load, context))),
          plan_(*loaded_, request) {
        load_ms_ = clock_.lap_ms();
    }

    void draw(const std::function<void(const SequenceFrame&)>& done) {
        const std::vector<std::int64_t> frames = plan_.frames();
        check_frame_names(request_, frames);
        const std::vector<char> there =
            skips_existing_ ? frames_there(request_, frames, context_) : std::vector<char>(frames.size());
        SequenceWriter writer(context_.threads(), done);
        for (std::size_t i = 0; i < frames.size(); ++i) {
            context_.throw_if_cancelled();
            context_.set_progress_range(double(i) / double(frames.size()), double(i + 1) / double(frames.size()));
            draw_frame(frames[i], there[i], writer);
        }
        writer.finish();
        if (drawn_ > 0 && !shows_model_ && request_.settings.colors)
            context_.report().add(Remark::warning, request_.input, "", "no pixel of the pictures shows the model");
    }
    std::int64_t count() const { return plan_.count(); }

private:
    void draw_frame(std::int64_t number, bool is_there, SequenceWriter& writer);
    void begin();
    void draw_picture(SequenceFrame frame, const PictureRequest& request, SequenceWriter& writer, Context& context);
    Shot shot_of(std::int64_t frame, const PictureRequest& request, Context& context);
    ShotOptions options() const { return {.is_linear = FileTarget(request_).is_linear()}; }

    Context& context_;
    Context quiet_;  ///< of all pictures but the first
    Session& session_;
    PictureRequest request_;  ///< with its look, once begun; without output
    bool skips_existing_;
    Stopwatch clock_;
    double load_ms_ = 0;
    std::shared_ptr<const Scene> loaded_;
    SequencePlan plan_;
    std::optional<SequenceViews> views_;  ///< absent: nothing was drawn yet
    std::size_t drawn_ = 0;
    bool shows_model_ = false;
};

/// What is chosen once for all pictures, by the begin of the clip and by the whole of it.
void Sequence::begin() {
    const auto camera = [&](const Scene& shown) {
        const auto at = [&](double time_s) {
            return session_.asked(loaded_, request_, plan_.clips_at(time_s), quiet_);
        };
        views_.emplace(plan_, request_, at, context_);
        return views_->camera(shown, plan_.angle_of(0));
    };
    decide(session_, loaded_, request_, plan_.clips_at(plan_.begin_s()), camera, options(), context_);
}

Shot Sequence::shot_of(std::int64_t frame, const PictureRequest& request, Context& context) {
    const Scene& shown = session_.show(loaded_, request, plan_.clips_at(plan_.time_of(frame)), context);
    return plan_shot(shown, request, views_->camera(shown, plan_.angle_of(frame)), options(), context);
}

void Sequence::draw_picture(SequenceFrame frame, const PictureRequest& request, SequenceWriter& writer,
                            Context& context) {
    PictureResult& result = frame.picture;
    const Shot shot = shot_of(frame.frame, request, context);
    result.prepare_ms = clock_.lap_ms();
    const bool is_color_alone = request.settings.channels == 0 && file_ending(request.output) == "png";
    Pixels color;
    PixelsTarget pixels(color);
    FileTarget files(request);
    PictureTarget& target = is_color_alone ? static_cast<PictureTarget&>(pixels) : files;
    const ChannelRange range = channel_range_of(views_->bounds(), shot.camera);
    draw_shot(session_, shot, request, target, &range, result, context);
    shows_model_ |= result.stats.pixels_shaded + result.stats.pixels_marked > 0;
    if (drawn_ == 0)
        remark_extremes(drawn_scene(*session_.prepared_for(shot, context), shot, context), request, result,
                        context.report());
    ++drawn_;
    if (is_color_alone)
        writer.write(std::move(frame), std::move(color), request.settings);
    else
        writer.add(std::move(frame));
}

void Sequence::draw_frame(std::int64_t number, bool is_there, SequenceWriter& writer) {
    SequenceFrame frame{.frame = number, .time_s = plan_.has_clip() ? plan_.time_of(number) : 0};
    PictureRequest request = request_;
    request.output = frame_name(request_.output, number);
    frame.picture.file = request.input, frame.picture.output = request.output;
    frame.is_skipped = is_there;
    if (frame.is_skipped) return writer.add(std::move(frame));
    clock_.lap_ms();
    if (!views_) {
        begin();
        request = request_;
        request.output = frame.picture.output;
    }
    request.settings.shader_time_s = plan_.shader_time_of(number);
    frame.picture.load_ms = drawn_ == 0 ? load_ms_ : 0;
    draw_picture(std::move(frame), request, writer, drawn_ == 0 ? context_ : quiet_);
}

/// A {frame} or {frame:N}.
struct NumberPart {
    std::size_t length = 0;  ///< 0: there is none
    int digits = 1;
};

NumberPart number_part(std::string_view name) {
    if (!name.starts_with("{frame")) return {};
    std::size_t end = 6;
    int digits = 0;
    if (end < name.size() && name[end] == ':')
        for (++end; end < name.size() && name[end] >= '0' && name[end] <= '9'; ++end)
            digits = std::min(9, 10 * digits + (name[end] - '0'));
    if (end < name.size() && name[end] == '}') return {end + 1, std::max(1, digits)};
    return {};
}

/// Calls text(character) and number(part) in their order.
template <class Text, class Number>
void walk_name(std::string_view name, const Text& text, const Number& number) {
    while (!name.empty()) {
        const bool is_doubled = name.starts_with("{{") || name.starts_with("}}");
        const NumberPart part = is_doubled ? NumberPart{} : number_part(name);
        part.length > 0 ? number(part) : text(name[0]);
        name.remove_prefix(part.length > 0 ? part.length : is_doubled ? 2 : 1);
    }
}

}  // namespace

bool has_frame_number(const std::string& output) {
    bool has_number = false;
    walk_name(
        output, [](char) {}, [&](const NumberPart&) { has_number = true; });
    return has_number;
}

std::string frame_name(const std::string& output, std::int64_t frame) {
    const std::string digits = std::to_string(frame);
    std::string name;
    const auto add_number = [&](const NumberPart& part) {
        name.append(std::size_t(std::max(0, part.digits - int(digits.size()))), '0') += digits;
    };
    walk_name(
        output, [&](char c) { name += c; }, add_number);
    return name;
}

void check_sequence(const SequenceRequest& request) {
    check_numbers(request);
    if (!has_frame_number(request.picture.output))
        throw Error(ErrorCode::usage, "the pictures of a sequence need a number in their name", {},
                    "write for example 'out/{frame:4}.png'")
            .with_file(request.picture.output);
    if (request.picture.keep_partial)
        throw Error(ErrorCode::usage, "is for single pictures: those of a sequence are whole").about("keep-partial");
    PictureRequest first = request.picture;
    first.output = frame_name(first.output, request.frames.first);
    check_request(first);
}

std::int64_t render_sequence(const SequenceRequest& request, Context& context,
                             const std::function<void(const SequenceFrame&)>& done) {
    check_sequence(request);
    try {
        Session session(request.picture.engine);
        Sequence sequence(request, session, context);
        sequence.draw(done);
        return sequence.count();
    } catch (const std::bad_alloc&) {
        throw Error(ErrorCode::failed, "out of memory").with_file(request.picture.input);
    } catch (const Error& error) {
        throw error.with_file(request.picture.input);
    }
}

}  // namespace rakelight
