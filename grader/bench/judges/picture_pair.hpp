#pragma once

#include <functional>
#include <string>
#include <umbral/core/grid.hpp>

#include "judge/picture/picture.hpp"

namespace umbral::grader {

/// One picture as it should be and one made from it or beside it, of which is known whether a teacher would accept it.
struct PicturePair {
    std::string scene;   ///< "thin lines", "lighting/shaders: balls/picture"
    std::string change;  ///< what makes the second picture another one: "missing edge", "mistake: no_normalize"
    bool harmful = false;
    bool noise = false;    ///< Monte Carlo estimates of one light: no two are equal
    bool made_up = false;  ///< by an operator on pixels (picture_operators.hpp), not by rendering again
    Picture expected;
    Picture student;
};

/// Is handed the pairs one after another: all of them together take gigabytes.
using VisitPair = std::function<void(const PicturePair&)>;

/// Of three channels, or of four where alpha says something.
[[nodiscard]] Picture to_picture(const Image& image);
[[nodiscard]] Image to_image(const Picture& picture);

/// Is there no pixel at which a channel differs by more than two levels? Nobody sees such a difference, and no picture
/// can be judged by it.
[[nodiscard]] bool looks_the_same(const Picture& a, const Picture& b);

}
