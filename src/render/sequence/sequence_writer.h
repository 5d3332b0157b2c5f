// SPDX-License-Identifier: Apache-2.0
// The pictures of a sequence on their way to files: PNG files are written while the next pictures are drawn.
#pragma once
#include <deque>
#include <functional>
#include <future>
#include <string>

#include <rakelight/render/sequence.h>

namespace rakelight {

class SequenceWriter {
public:
    /// @param threads  with one thread a picture is written before the next is drawn
    /// @param done  told of each picture when its file is whole, in order; may be empty
    SequenceWriter(int threads, std::function<void(const SequenceFrame&)> done);
    ~SequenceWriter() { settle(); }
    SequenceWriter(const SequenceWriter&) = delete;
    SequenceWriter& operator=(const SequenceWriter&) = delete;

    /// A picture whose file exists.
    void add(SequenceFrame frame);
    /// @param settings  that it was drawn by: which part of the whole it is @throws Error failed: this or an earlier one cannot be
    ///                  written
    void write(SequenceFrame frame, Pixels pixels, const RenderSettings& settings);
    /// Waits until all pictures are complete. @throws Error as write()
    void finish();
    /// The same where something else has failed already.
    void settle() noexcept;

private:
    struct Pending {
        SequenceFrame frame;
        std::future<double> write_ms;  ///< not valid: it is there
    };
    void take_first();

    std::size_t most_;  ///< pictures that are written at once
    std::function<void(const SequenceFrame&)> done_;
    std::deque<Pending> pending_;
};

}  // namespace rakelight
