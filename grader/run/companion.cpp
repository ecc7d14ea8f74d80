#include "run/companion.hpp"

#include <sys/mman.h>

#include <new>
#include <umbral/record/cost.hpp>
#include <utility>

#include "run/sandbox.hpp"

namespace umbral::grader {
namespace {

/// As much as the run itself has; taken page by page, when it is used.
constexpr std::size_t stack_size = sandbox::ResourceLimits::stack;
/// At its end: what grows into it crashes.
constexpr std::size_t guard_size = std::size_t{64} << 10U;

void* new_stack()
{
    void* const stack = mmap(nullptr, stack_size, PROT_READ | PROT_WRITE,
                             MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE | MAP_STACK, -1, 0);
    if (stack == MAP_FAILED) throw std::bad_alloc();
    mprotect(stack, guard_size, PROT_NONE);
    return stack;
}

}

Companion::Companion(const DriverCase& one, Case what, unsigned ahead)
    : one_(one),
      what_(std::move(what)),
      stack_(new_stack()),
      to_catch_up_(1 + ahead),
      progress_(asked_, function_, {}, [] {}),
      recorder_(progress_)
{
    progress_.at_each_question([this] { swapcontext(&own_, &first_); });
    getcontext(&own_);
    own_.uc_stack.ss_sp = stack_;
    own_.uc_stack.ss_size = stack_size;
    own_.uc_link = &first_;
    // makecontext hands on nothing larger than an int.
    const auto address = reinterpret_cast<std::uintptr_t>(this);
    makecontext(&own_, reinterpret_cast<void (*)()>(&Companion::enter), 2, static_cast<unsigned>(address >> 32U),
                static_cast<unsigned>(address));
}

Companion::~Companion() { munmap(stack_, stack_size); }

void Companion::enter(unsigned high, unsigned low) noexcept
{
    auto* const self = reinterpret_cast<Companion*>(std::uintptr_t{high} << 32U | low);
    self->one_.run(self->what_, self->recorder_);
    self->has_ended_ = true;
}

void Companion::go_on()
{
    if (!has_ended_) swapcontext(&first_, &own_);
}

void Companion::take_turn()
{
    const std::uint64_t before = blocks_executed();
    for (; to_catch_up_ > 0; --to_catch_up_) go_on();
    go_on();
    count_blocks(before - blocks_executed());
}

}
