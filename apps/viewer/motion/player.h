// SPDX-License-Identifier: Apache-2.0
// Plays what moves in a look: clips of the model, recorded keys, the camera around the model. Numbers in, a look out; its clock
// is the caller's.
#pragma once
#include <optional>
#include <string>

#include "../document/document.h"
#include "../document/keys.h"

namespace rakelight::viewer {

struct Player {
    bool is_playing = false;  ///< clips and keys
    bool is_turning = false;  ///< the camera goes around the model
    bool loops = true;
    double speed = 1;     ///< [seconds of the look in a second] > 0
    double turn_s = 12;   ///< [s] once around
    double length_s = 5;  ///< [s] of a look without a clip, for keys

    bool moves() const { return is_playing || is_turning; }
    /// [s] Since the call before; 0 at the first one after stop(). @param now_s  of a clock that never goes back
    double elapsed(double now_s);
    /// Time stands still until elapsed() is called again.
    void stop_clock() { last_s_.reset(); }

private:
    std::optional<double> last_s_;
};

inline constexpr double frame_s = 1.0 / 30;  // that a step of one picture goes

/// The moments that a look goes through: those of its clips and keys, and the length where it shows no clip.
ClipSpan span_of(const Look& look, const Model& model, const Player& player);
/// [s] The moment that it shows.
double time_of(const Look& look, const Model& model, const Player& player);
/// Shows another moment, within its span. A view that is fitted to the model stays where it is, and what has keys goes where they say.
void set_time(Look& look, const Model& model, const Player& player, int width, int height, double time_s);
/// Something but the camera's turn can be played.
bool has_motion(const Look& look);

/// The clip by its number, from its beginning; -1: all; none: the model stands as the file has it.
void choose_clip(Look& look, std::optional<int> clip);
/// none: no clip, or all (-1)
std::optional<int> chosen_clip(const Look& look, const Model& model);

/// Continues by so much of the clock's time. @return false: it has come to its end, and nothing is left to be played
bool advance(Look& look, const Model& model, const Player& player, int width, int height, double elapsed_s);

/// Applies a command to the player and to the look that it plays; false: it is not about them.
bool apply(Command command, Player& player, Look& look, const Model& model, int width, int height);
/// The effect of the command, for people; empty if the effect is visible anyway.
std::string effect_of(Command command, const Player& player, const Look& look, const Model& model);

/// "2: walk, 1.33 s", "all clips", "at rest"
std::string clip_title(const Model& model, std::optional<int> clip);

}  // namespace rakelight::viewer
