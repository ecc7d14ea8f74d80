#pragma once

#include <array>
#include <string>

namespace umbral::grader {

/// A law that ties two values which a student's run recorded in one case: the check's value must be `to`, moved by
/// `shift` and multiplied by `scale`. What is expected comes from the student's own run, so such a check needs no right
/// answer; the reference only says how much there is to see. grader/judge/relation.hpp judges it.
struct Relation {
    std::string to;  ///< the recorded value that the check's own value follows from
    std::string
        unlike;  ///< one that must differ from `to`, since its inputs do; empty where shift or scale make a difference
    std::array<int, 2> shift{};  ///< whole pixels to the right and down; what comes in from outside is not compared
    double scale = 1;            ///< of every value: for linear light, lengths, areas
    std::string what;  ///< the law as a sentence without its full stop: "rotating scene and camera together must not
                       ///< change the picture"

    [[nodiscard]] bool moves() const noexcept { return shift[0] != 0 || shift[1] != 0; }
    [[nodiscard]] bool scales() const noexcept { return scale != 1; }
};

}
