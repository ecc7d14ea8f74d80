#pragma once

#include <ucontext.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <umbral/record/driver.hpp>

namespace umbral::grader {

/// A case that is run once more beside the first, in the same process and with other inputs: before each question of
/// the first one it asks its own next one, and nobody looks at the answers. The two ask the same functions in the same
/// order, mostly about things of the same size. Code that answers each call from its arguments does not notice; code
/// that keeps something from one call to the next does (RunRequest::beside).
///
/// Some questions ahead, it sets what belongs to all objects at other times than the first case, between where that one
/// sets and where it reads. With nearly the same inputs and none ahead, it asks of nearly the same: so who looks at a
/// part of the arguments only, to see whether an answer is known, is wrong.
///
/// It has a stack of its own, and runs only while the first one waits in take_turn(): there is no second thread.
class Companion {
public:
    /// Stays `ahead` questions ahead. `one` must live as long. Throws std::bad_alloc if there is no memory for a stack.
    Companion(const DriverCase& one, Case what, unsigned ahead);
    Companion(const Companion&) = delete;
    Companion& operator=(const Companion&) = delete;
    ~Companion();

    /// Asks one question more, unless all are asked. The first turn also comes to the first question. What work that is
    /// is not counted (blocks_executed()).
    void take_turn();

private:
    static void enter(unsigned high, unsigned low) noexcept;
    void go_on();

    const DriverCase& one_;
    Case what_;
    void* stack_;
    ucontext_t first_{};    ///< where the first case waits
    ucontext_t own_{};      ///< where this one waits
    unsigned to_catch_up_;  ///< turns to take before the first one: one to begin, and those that it is ahead
    bool has_ended_ = false;
    std::uint32_t asked_ = 0;
    std::array<char, 128> function_{};
    Progress progress_;
    Recorder recorder_;
};

}
