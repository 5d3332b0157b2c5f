// SPDX-License-Identifier: Apache-2.0
// The message at the bottom of the picture, for a while.
#pragma once
#include <chrono>
#include <string>
#include <utility>

namespace rakelight::viewer {

class Message {
public:
    static constexpr double news_s = 8, error_s = 60;  ///< that it stays

    void say(std::string text) { set(std::move(text), false); }  ///< what was done
    void fail(std::string text) { set(std::move(text), true); }  ///< what could not be
    void clear() { text_.clear(); }
    const std::string& text() const { return text_; }
    bool is_error() const { return is_error_; }
    /// It was there long enough.
    bool is_over() const {
        const std::chrono::duration<double> age = Clock::now() - since_;
        return !text_.empty() && age.count() > (is_error_ ? error_s : news_s);
    }

private:
    using Clock = std::chrono::steady_clock;
    void set(std::string text, bool is_error) { text_ = std::move(text), is_error_ = is_error, since_ = Clock::now(); }

    std::string text_;
    bool is_error_ = false;
    Clock::time_point since_{};
};

}  // namespace rakelight::viewer
