// SPDX-License-Identifier: Apache-2.0
// Text that grows at its end, without the zeros that a string writes first.
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstring>
#include <memory>
#include <string_view>

namespace rakelight::io::obj {

class TextBuffer {
public:
    /// Where the text continues, with room for `bytes`; end_at() says where it ends then.
    char* room(std::size_t bytes) {
        if (capacity_ - size_ < bytes) grow(bytes);
        return text_.get() + size_;
    }
    void end_at(const char* end) { size_ = std::size_t(end - text_.get()); }
    void append(std::string_view text) {
        if (text.empty()) return;
        std::memcpy(room(text.size()), text.data(), text.size());
        size_ += text.size();
    }
    std::string_view text() const { return {text_.get(), size_}; }
    void clear() { size_ = 0; }  ///< keeps the room

private:
    void grow(std::size_t bytes) {
        capacity_ = std::max({2 * capacity_, size_ + bytes, std::size_t(4096)});
        std::unique_ptr<char[]> larger(new char[capacity_]);
        if (size_ > 0) std::memcpy(larger.get(), text_.get(), size_);
        text_ = std::move(larger);
    }
    std::unique_ptr<char[]> text_;
    std::size_t size_ = 0, capacity_ = 0;
};

}  // namespace rakelight::io::obj
