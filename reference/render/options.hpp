#pragma once

#include <optional>
#include <stdexcept>
#include <string>

#include "render/budget/wish.hpp"
#include "render/film.hpp"
#include "render/rays/draw.hpp"

namespace umbral::render {

/// What umbral-render ends with; `umbral` uses the same numbers.
enum Exit : int {
    exit_ok = 0,
    exit_differ = 1,  ///< --compare: the renderers differ by more than is allowed
    exit_usage =
        2,  ///< the command cannot be carried out as given: options, scene, size, a file that cannot be read or written
    exit_fault = 3,  ///< a fault of Umbral's own, or of OpenGL
};

/// A mistake in how the program was called, or in what it was given.
class UsageError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

struct Size {
    int width = 0;
    int height = 0;
};

/// Sides of 1 to 8192 pixels, and all of them with their samples at most 2^25: a frame takes 24 bytes a pixel.
inline constexpr int maximum_side = 8192;
inline constexpr long long maximum_samples = 1LL << 25;

/// "512x384". Throws UsageError that says what was expected and what came.
[[nodiscard]] Size parse_size(const std::string& text);

struct Options {
    std::string scene;
    std::string renderer = "software";
    Size size{512, 512};
    int samples = 1;
    rays::Effort effort{};                            ///< of renderers that follow rays
    std::optional<budget::Wish> wish = std::nullopt;  ///< from which all else is chosen that costs time
    std::string out;                                  ///< empty: no picture
    std::string buffers;                              ///< empty: no buffers
    FilmOptions film{};
    bool progress = false;
    bool explain = false;
    bool json = false;
    bool compare = false;
    bool all_effects = false;
};

/// Nothing if help was printed, or a complaint; then `status` is what to end with.
[[nodiscard]] std::optional<Options> parse_options(int count, char** words, int& status);

}
