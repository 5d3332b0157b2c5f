// SPDX-License-Identifier: Apache-2.0
#include "render/sequence/sequence_writer.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "base/apart.h"
#include "io/pictures/image_io.h"
#include "render/output/picture_files.h"
#include "render/stopwatch.h"

namespace rakelight {
namespace {

constexpr int most_at_once = 4;  ///< each has a whole picture in memory

}  // namespace

SequenceWriter::SequenceWriter(int threads, std::function<void(const SequenceFrame&)> done)
    : most_(threads > 1 ? std::size_t(std::min(threads, most_at_once)) : 0), done_(std::move(done)) {}

void SequenceWriter::add(SequenceFrame frame) {
    pending_.push_back({std::move(frame), {}});
    while (!pending_.empty() && !pending_.front().write_ms.valid()) take_first();
}

void SequenceWriter::write(SequenceFrame frame, Pixels pixels, const RenderSettings& settings) {
    io::OutputTarget target(frame.picture.output);
    target.comment = comment_of(settings);
    target.place = place_of(settings);
    auto work = [target = std::move(target), pixels = std::make_shared<const Pixels>(std::move(pixels))] {
        const Stopwatch watch;
        io::write_image(target, *pixels);
        return watch.ms();
    };
    pending_.push_back({std::move(frame), start_apart(std::move(work))});
    while (pending_.size() > most_) take_first();
}

void SequenceWriter::take_first() {
    Pending first = std::move(pending_.front());
    pending_.pop_front();
    if (first.write_ms.valid()) first.frame.picture.write_ms = first.write_ms.get();
    if (done_) done_(first.frame);
}

void SequenceWriter::finish() {
    while (!pending_.empty()) take_first();
}

void SequenceWriter::settle() noexcept {
    while (!pending_.empty()) try {
            take_first();
        } catch (...) {  // the first fault is the one that is told
        }
}

}  // namespace rakelight
