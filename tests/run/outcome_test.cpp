#include <gtest/gtest.h>
#include <signal.h>

#include <cerrno>
#include <cstring>

#include "model/caps.hpp"
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

Verdict verdict(const protocol::Ended& ended, bool confined, const std::vector<std::byte>& bytes)
{
    return judge_end(ended, confined, bytes, "", {}).verdict;
}

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

TEST(Outcome, a_run_that_waited_is_not_asked_for_an_endless_loop)
{
    protocol::Ended late = killed(SIGKILL);
    late.timed_out = 1;
    late.cpu_seconds = 4.9;
    EXPECT_EQ(judge_end(late, true, recording(nothing), "", {}).message,
              "stopped after 5 s: is there a loop that never ends, or far more work than is needed?");
    late.cpu_seconds = 0.2;
    EXPECT_EQ(judge_end(late, true, recording(nothing), "", {}).message,
              "stopped after 5 s, in which it hardly computed: does it wait for a lock, an input, or a time to pass?");
}

// Which of the two limits ends a loop is chance: the same work must be told the same.
TEST(Outcome, a_loop_is_told_the_same_whichever_limit_ended_it)
{
    protocol::Ended late = killed(SIGKILL);
    late.timed_out = 1;
    late.cpu_seconds = 4.7;
    protocol::Ended spent = killed(SIGXCPU);
    spent.cpu_seconds = 4.9;
    EXPECT_EQ(judge_end(late, true, recording(nothing), "", {}).message,
              judge_end(spent, true, recording(nothing), "", {}).message);
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

/// A run that ended by a signal that it caught, after this was printed.
RunOutcome aborted(std::string_view printed, const RunRequest& request = {})
{
    const auto bytes = recording([](wire::Header& header) {
        header.note = static_cast<std::uint32_t>(wire::Note::signal);
        header.signal = SIGABRT;
    });
    return judge_end(exited(70), true, bytes, printed, request);
}

TEST(Outcome, what_the_libraries_print_last_is_told_in_words)
{
    EXPECT_NE(aborted("1 2 3\n*** stack smashing detected ***: terminated\n").message.find("written beyond its end"),
              std::string::npos);
    EXPECT_NE(aborted("free(): invalid pointer\n").message.find("on the heap"), std::string::npos);
    EXPECT_EQ(aborted("free(): invalid pointer\nhello\n").message.find("on the heap"), std::string::npos)
        << "the last line only";
    EXPECT_NE(aborted("a: b.cpp:7: f: Assertion `x' failed.\n").message.find("Assertion `x' failed."),
              std::string::npos);
    // The loader ends the process by itself, with status 127.
    const RunOutcome outcome = judge_end(exited(127), true, recording(nothing),
                                         "student.so: cannot allocate memory for thread-local data: ABORT\n", {});
    EXPECT_EQ(outcome.verdict, Verdict::out_of_memory);
    EXPECT_NE(outcome.message.find("thread_local"), std::string::npos) << outcome.message;
}

TEST(Outcome, texts_show_no_paths_of_this_machine_and_are_bounded)
{
    RunRequest request;
    request.roots = {"/srv/umbral", "/srv/umbral/cache/ab"};
    const std::string path = "/srv/umbral/cache/ab/student.so";
    EXPECT_EQ(aborted("/srv/umbral/grid.hpp:7: f: Assertion `/srv/umbral/x' failed.\n", request).message,
              "Assertion `x' failed.");
    EXPECT_EQ(aborted(path + "\n", request).output, "student.so\n");
    for (const wire::Note kind :
         {wire::Note::uncaught_exception, wire::Note::load_failure, wire::Note::compile_error}) {
        const auto bytes = recording([&](wire::Header& header) {
            header.note = static_cast<std::uint32_t>(kind);
            std::strcpy(header.text, path.c_str());
            std::memset(header.text + path.size(), '\1', sizeof header.text - path.size() - 1);
        });
        const RunOutcome outcome = judge_end(exited(70), true, bytes, "", request);
        EXPECT_EQ(outcome.message.find("/srv"), std::string::npos);
        EXPECT_EQ(outcome.recording.text.find("/srv"), std::string::npos);
        EXPECT_NE(outcome.message.find("student.so"), std::string::npos);
        EXPECT_LE(outcome.message.size(), caps::message + 100);
    }
}

// A run within its limits that the kernel kills has met a machine that is too small; one that has taken most of what it
// may is told so, or taking much would be a way to a unit that does not count.
TEST(Outcome, a_run_killed_for_lack_of_memory_is_the_students_only_if_it_took_much)
{
    protocol::Ended ended = killed(SIGKILL);
    EXPECT_TRUE(judge_end(ended, true, recording(nothing), "", {}).killed_from_outside);
    ended.out_of_memory_kill = 1;
    ended.peak_memory_kib = 40 << 10;
    EXPECT_EQ(verdict(ended, true, recording(nothing)), Verdict::grader_fault);
    ended.peak_memory_kib = 300 << 10;
    EXPECT_EQ(verdict(ended, true, recording(nothing)), Verdict::out_of_memory);
    ended.timed_out = 1;
    EXPECT_EQ(verdict(ended, true, recording(nothing)), Verdict::timeout);
    EXPECT_FALSE(judge_end(ended, true, recording(nothing), "", {}).killed_from_outside);
}

TEST(Outcome, what_keeps_a_run_from_starting_is_named)
{
    protocol::Ended ended;
    ended.could_not_start = EAGAIN;
    const RunOutcome none = judge_end(ended, false, recording(nothing), "", {});
    EXPECT_EQ(none.verdict, Verdict::grader_fault);
    EXPECT_NE(none.message.find("no process left"), std::string::npos) << none.message;
    ended = killed(SIGKILL);
    ended.timed_out = 1;
    const RunOutcome late = judge_end(ended, false, recording(nothing), "", {});
    EXPECT_EQ(late.verdict, Verdict::grader_fault);
    EXPECT_NE(late.message.find("overloaded"), std::string::npos) << late.message;
}

TEST(Outcome, only_what_is_wanted_is_read_and_no_more_than_expected)
{
    std::vector<std::byte> bytes = recording(finished);
    Recorder recorder;
    for (int i = 0; i < 10; ++i) recorder.append("few", 1.0F);
    for (int i = 0; i < 100; ++i) recorder.append("many", 1.0F);
    recorder.append("other", 1.0F);
    wire::Header header{};
    std::memcpy(&header, bytes.data(), sizeof header);
    header.tensors_size = wire::write_tensors(recorder.tensors(), std::span(bytes).subspan(wire::tensors_offset));
    header.tensor_count = 3;
    std::memcpy(bytes.data(), &header, sizeof header);
    RunRequest request;
    EXPECT_EQ(judge_end(exited(0), true, bytes, "", request).recording.tensors.size(), 3U);
    request.wanted = {{"few", 50}, {"many", 50}};
    const RunOutcome outcome = judge_end(exited(0), true, bytes, "", request);
    EXPECT_EQ(outcome.verdict, Verdict::ok);
    ASSERT_EQ(outcome.recording.tensors.size(), 1U);
    EXPECT_EQ(outcome.recording.tensors.at("few").rows, 10U);
    ASSERT_EQ(outcome.recording.oversized.size(), 1U);
    EXPECT_EQ(outcome.recording.oversized.at("many").rows, 100U);
    EXPECT_EQ(outcome.recording.oversized.at("many").beginning.rows, 50U);
    EXPECT_EQ(outcome.recording.oversized.at("many").beginning.bytes.size(), 50 * sizeof(float));
}

TEST(Outcome, damage_is_never_a_result)
{
    EXPECT_EQ(verdict(exited(0), true, {}), Verdict::crashed);
    EXPECT_EQ(verdict(exited(0), true, std::vector<std::byte>(wire::tensors_offset)), Verdict::crashed);
    EXPECT_EQ(verdict(exited(0), false, {}), Verdict::grader_fault);
}

}
}
