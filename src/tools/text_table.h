// SPDX-License-Identifier: Apache-2.0
// Columns for people.
#pragma once
#include <string>
#include <vector>

namespace rakelight {

/// Rows of cells with their columns lined up; columns that begin with '>' in the head are aligned to the right.
class TextTable {
public:
    explicit TextTable(std::vector<std::string> head);
    void add(
        std::vector<std::string> cells);  ///< as many as the head has; foreign text must have gone through one_line()
    bool empty() const { return rows_.size() == 1; }
    std::string text(const std::string& indent) const;
    const std::vector<std::vector<std::string>>& rows() const { return rows_; }  ///< the head first
    bool is_to_the_right(std::size_t column) const { return to_the_right_[column]; }

private:
    std::vector<bool> to_the_right_;
    std::vector<std::vector<std::string>> rows_;
};

}  // namespace rakelight
