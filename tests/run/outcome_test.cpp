#include <gtest/gtest.h>
#include <signal.h>

#include <cstring>

#include "run/outcome.hpp"

namespace umbral::grader {
namespace {

/// A recording as a run would leave it, changed by `change`.
template <class Change>
std::vector<std::byte> recording(Change change)
{
    wire::Header header{};
    header.magic = wire::magic;
    header.stage = static_cast<std::uint32_t>(wire::Stage::running);
    change(header);
    std::vector<std::byte> bytes(wire::tensors_offset + 4096);
    std::memcpy(bytes.data(), &header, sizeof header);
    return bytes;
}

protocol::Ended exited(int status)
{
    protocol::Ended ended;
    ended.wait_status = status << 8;
    return ended;
}
protocol::Ended killed(int signal)
{
    protocol::Ended ended;
    ended.wait_status = signal;
    return ended;
}

Verdict verdict(const protocol::Ended& ended, bool confined, const std::vector<std::byte>& bytes) { return judge_end(ended, confined, bytes, "", {}).verdict; }

void finished(wire::Header& header) { header.stage = static_cast<std::uint32_t>(wire::Stage::finished); }
void nothing(wire::Header&) {}

TEST(Outcome, only_a_finished_run_with_status_0_is_ok)
{
    EXPECT_EQ(verdict(exited(0), true, recording(finished)), Verdict::ok);
    EXPECT_EQ(verdict(exited(1), true, recording(finished)), Verdict::crashed);
    EXPECT_EQ(verdict(killed(SIGSEGV), true, recording(finished)), Verdict::crashed);
    EXPECT_EQ(verdict(exited(0), true, recording(nothing)), Verdict::crashed);
    protocol::Ended late = exited(0);
    late.timed_out = 1;
    EXPECT_EQ(verdict(late, true, recording(finished)), Verdict::timeout);
}

TEST(Outcome, only_a_run_that_never_reached_its_sandbox_is_our_fault)
{
    for (std::uint32_t stage = 0; stage <= 5; ++stage) {
        for (std::uint32_t note = 0; note <= 9; ++note) {
            const auto bytes = recording([&](wire::Header& header) {
                header.stage = stage;
                header.note = note;
            });
            for (const auto& ended : {exited(0), exited(71), killed(SIGKILL), killed(SIGSYS)}) {
                EXPECT_NE(verdict(ended, true, bytes), Verdict::grader_fault) << stage << ' ' << note;
                EXPECT_EQ(verdict(ended, false, bytes), Verdict::grader_fault) << stage << ' ' << note;
            }
        }
    }
    protocol::Ended none;
    none.could_not_start = 1;
    EXPECT_EQ(verdict(none, false, recording(nothing)), Verdict::grader_fault);
}

TEST(Outcome, tells_signals_apart)
{
    EXPECT_EQ(verdict(killed(SIGXCPU), true, recording(nothing)), Verdict::timeout);
    EXPECT_EQ(verdict(killed(SIGSYS), true, recording(nothing)), Verdict::blocked);
    EXPECT_EQ(verdict(killed(SIGSEGV), true, recording(nothing)), Verdict::crashed);
    protocol::Ended busy = killed(SIGKILL);
    EXPECT_EQ(verdict(busy, true, recording(nothing)), Verdict::crashed);
    busy.cpu_seconds = 6;
    EXPECT_EQ(verdict(busy, true, recording(nothing)), Verdict::timeout);
}

TEST(Outcome, a_crash_after_a_refused_call_is_blocked_and_names_it_once)
{
    const auto bytes = recording([](wire::Header& header) {
        header.note = static_cast<std::uint32_t>(wire::Note::signal);
        header.signal = SIGSEGV;
        header.refused_count = 2;
        header.refused[0] = header.refused[1] = 1000000;
    });
    const RunOutcome outcome = judge_end(exited(70), true, bytes, "", {});
    EXPECT_EQ(outcome.verdict, Verdict::blocked);
    EXPECT_EQ(outcome.refused, std::vector<std::string>{"call 1000000"});
}

TEST(Outcome, libraries_too_large_to_load_are_out_of_memory)
{
    const auto bytes = recording([](wire::Header& header) {
        header.note = static_cast<std::uint32_t>(wire::Note::load_failure);
        std::strcpy(header.text, "student.so: cannot map zero-fill pages");
    });
    EXPECT_EQ(verdict(exited(71), true, bytes), Verdict::out_of_memory);
}

TEST(Outcome, damage_is_never_a_result)
{
    EXPECT_EQ(verdict(exited(0), true, {}), Verdict::crashed);
    EXPECT_EQ(verdict(exited(0), true, std::vector<std::byte>(wire::tensors_offset)), Verdict::crashed);
    EXPECT_EQ(verdict(exited(0), false, {}), Verdict::grader_fault);
}

}
}
