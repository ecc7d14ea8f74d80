#pragma once

#include <chrono>
#include <string>

#include "scene/scene.hpp"

/// Scenes that move: pictures with numbers, and a film made of them.
namespace umbral::render {

/// How many pictures --animate may ask for.
inline constexpr int most_pictures = 10000;

struct FilmOptions {
    int pictures = 0;   ///< 0: a single picture, of the scene at time 0
    float seconds = 0;  ///< what they show, from time 0 on; 0: as long as the scene says
    std::string film;   ///< a file that ffmpeg makes of them; empty: none
};

/// The file of picture `number`: "walk.png" becomes "walk-0007.png".
[[nodiscard]] std::string numbered(const std::string& out, int number);

/// How long the film of a scene is. Throws std::runtime_error if neither the options nor the scene say.
[[nodiscard]] float film_seconds(const FilmOptions& options, const scene::Scene& scene);

/// Is there an ffmpeg among the programs that this process can start?
[[nodiscard]] bool has_ffmpeg();

/// Joins the pictures to a film of so many seconds. Throws std::runtime_error if ffmpeg is missing or fails.
void join_pictures(const FilmOptions& options, float seconds, const std::string& out);

/// Says on standard error how much is done, and how long the rest takes if it goes on like that.
class Progress {
public:
    explicit Progress(bool shown) : shown_(shown) {}
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// `done` is a share of all, 0 to 1. At most ten lines a second, each in the place of the one before.
    void tell(double done);

private:
    using Clock = std::chrono::steady_clock;
    bool shown_;
    bool told_ = false;
    Clock::time_point begin_ = Clock::now();
    Clock::time_point last_{};
};

/// "37 %, 12 s left"; without an end while nothing is done. `seconds` is what has passed.
[[nodiscard]] std::string progress_text(double done, double seconds);

}
