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
/// It has a stack of its own, and runs only while the first one waits in take_turn(): there is no second thread.
class Companion {
public:
    /// `one` must live as long. Throws std::bad_alloc if there is no memory for a stack.
    Companion(const DriverCase& one, Case what);
    Companion(const Companion&) = delete;
    Companion& operator=(const Companion&) = delete;
    ~Companion();

    /// Asks one question more, unless all are asked. The first turn also comes to the first question.
    void take_turn();

private:
    static void enter(unsigned high, unsigned low) noexcept;
    void go_on();

    const DriverCase& one_;
    Case what_;
    void* stack_;
    ucontext_t first_{};  ///< where the first case waits
    ucontext_t own_{};    ///< where this one waits
    bool has_begun_ = false;
    bool has_ended_ = false;
    std::uint32_t asked_ = 0;
    std::array<char, 128> function_{};
    Progress progress_;
    Recorder recorder_;
};

}
