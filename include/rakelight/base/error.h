// SPDX-License-Identifier: Apache-2.0
// The exception type of the library: bad input, or a missing part of the environment.
#pragma once
#include <exception>
#include <string>
#include <vector>

#include <rakelight/base/export.h>

namespace rakelight {

/// Classes of errors, with the exit codes of the program.
enum class ErrorCode {
    failed,        ///< 1: the work could not be done (disk full, out of memory, cancelled)
    usage,         ///< 2: a wrong option or argument
    not_found,     ///< 3: input not found or unreadable
    bad_file,      ///< 4: format not supported, file broken or nothing to draw
    check_failed,  ///< 5: a check found problems
};

/// Bad input or environment. `what()` is one printable line of at most 600 bytes: "FILE: PLACE: SETTING: REASON;
/// ADVICE". Absent parts are left out, and control characters are replaced. Programming errors cause failed assertions
/// instead.
class RL_API Error : public std::exception {
public:
    /// @param reason  for people, one sentence without a full stop: "accessor 7 reads past the end of buffer 0 (needs
    ///        1200 bytes, has 960)"
    /// @param place   where in the file: "line 12", "accessor 7", "node 3"; may be empty
    /// @param advice  what to do: "export FBX or glTF instead"; may be empty
    explicit Error(ErrorCode code, std::string reason, std::string place = {}, std::string advice = {});

    /// The class of the error, which also decides the exit code.
    ErrorCode code() const noexcept { return code_; }
    /// For people, without file and place.
    const std::string& reason() const noexcept { return reason_; }
    /// Where in the file; may be empty.
    const std::string& place() const noexcept { return place_; }
    /// The file; may be empty.
    const std::string& file() const noexcept { return file_; }
    /// What to do; may be empty.
    const std::string& advice() const noexcept { return advice_; }
    /// The setting that the error is about, as a key of [render] in world files: "crease-angle". The name of a part may
    /// follow: "light color". Empty: no setting.
    const std::string& setting() const noexcept { return setting_; }
    /// Other settings that take part in the error, or that help.
    const std::vector<std::string>& related() const noexcept { return related_; }
    /// The whole line.
    const char* what() const noexcept override { return text_.c_str(); }

    /// The same error with a file name, unless it already has one.
    Error with_file(const std::string& file) const;
    /// The same error with a place in the file.
    Error at(const std::string& place) const;
    /// The same error with another code.
    Error as(ErrorCode code) const;
    /// The same error with `advice` appended to its advice.
    Error advising(const std::string& advice) const;
    /// The same error about another setting.
    Error about(const std::string& setting, std::vector<std::string> related = {}) const;
    /// The same error with the list of settings that its text quotes.
    Error naming(std::vector<std::string> settings) const;

private:
    void compose();
    ErrorCode code_;
    std::string reason_, place_, advice_, file_, setting_, text_;
    std::vector<std::string> related_;
};

/// Text made safe for one line of a terminal: control characters and invalid UTF-8 become '?', and the text is cut to
/// `max_bytes` with "...".
RL_API std::string one_line(const std::string& text, std::size_t max_bytes = 240);

}  // namespace rakelight
