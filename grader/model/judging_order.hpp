#pragma once

#include "model/exercise.hpp"

namespace umbral::grader {

/// The place of a judge in the order from exact to vague: exact lists, then numbers, then intermediate buffers, then what is counted or
/// derived, and the colour picture last. What a student is shown first follows this, and checks of one place the manifest: a mistake
/// that a number names, a picture only hints at.
[[nodiscard]] constexpr int judging_place(JudgeKind kind) noexcept
{
    switch (kind) {
        case JudgeKind::fragments:
        case JudgeKind::events:
        case JudgeKind::trace: return 0;
        case JudgeKind::numbers:
        case JudgeKind::matrices: return 1;
        case JudgeKind::buffer: return 2;
        case JudgeKind::image: return 4;
        default: return 3;
    }
}

}
