#include "run/outcome.hpp"

#include <fmt/format.h>
#include <sys/wait.h>

#include <csignal>
#include <cstring>
#include <set>

#include "run/sandbox.hpp"

namespace umbral::grader {
namespace {

struct End {
    Verdict verdict;
    std::string message;
};

std::string refused_text(const std::vector<std::string>& names) { return fmt::format("the sandbox refused: {}", fmt::join(names, ", ")); }

/// A library that a student's sources were made into may be one that cannot be loaded, or claim so. A driver that cannot be loaded shows
/// in the reference's run of the same case.
End load_failure(const std::string& text, const Limits& limits)
{
    for (const char* const sign : {"Cannot allocate memory", "cannot map zero-fill pages", "failed to map segment", "cannot allocate memory"})
        if (text.find(sign) != std::string::npos)
            return {Verdict::out_of_memory, fmt::format("your variables outside functions take more than {} MiB of memory", limits.memory_mib)};
    return {Verdict::crashed, "your code could not be loaded: " + text};
}

/// What the run noted about itself before it ended.
End from_note(const Recording& recording, const Limits& limits)
{
    switch (recording.note) {
        case wire::Note::out_of_memory:
            return {Verdict::out_of_memory, fmt::format("your code asked for more than {} MiB of memory ({})", limits.memory_mib, recording.text)};
        case wire::Note::compile_error: return {Verdict::compile_error, recording.text};
        case wire::Note::interface_mismatch: return {Verdict::interface_mismatch, recording.text};
        case wire::Note::stack_overflow: return {Verdict::crashed, "the stack overflowed: does a function call itself without end?"};
        case wire::Note::uncaught_exception: return {Verdict::crashed, recording.text};
        case wire::Note::signal: return {Verdict::crashed, fmt::format("signal {} ({})", recording.signal, strsignal(static_cast<int>(recording.signal)))};
        case wire::Note::load_failure: return load_failure(recording.text, limits);
        case wire::Note::driver_fault:
        case wire::Note::none: break;
    }
    return {Verdict::crashed, "the run ended early: does your code call exit?"};
}

/// What assert() or the C++ library printed before it aborted: "Assertion `length(d) < 1' failed."; empty if there is no such line.
std::string assertion_in(const std::string& output)
{
    const std::size_t at = output.rfind("Assertion ");
    return at == std::string::npos ? "" : output.substr(at, output.find('\n', at) - at);
}

RunOutcome not_confined(const protocol::Ended& ended, const std::string& text)
{
    RunOutcome outcome;
    outcome.verdict = Verdict::grader_fault;
    outcome.message = ended.could_not_start != 0 ? "the operating system could not start another process" : "the run did not reach its sandbox";
    if (!text.empty()) outcome.message += ": " + text;
    return outcome;
}

End ended_early(const protocol::Ended& ended, const Recording& recording, const Limits& limits)
{
    if (ended.timed_out != 0) return {Verdict::timeout, fmt::format("stopped after {:g} s: is there a loop that never ends?", limits.wall_seconds)};
    if (WIFSIGNALED(ended.wait_status)) {
        const int signal = WTERMSIG(ended.wait_status);
        if (signal == SIGXCPU || (signal == SIGKILL && ended.cpu_seconds >= limits.wall_seconds))
            return {Verdict::timeout, fmt::format("stopped after {:.1f} s of computing", ended.cpu_seconds)};
        if (signal == SIGSYS)
            return {Verdict::blocked,
                    "the sandbox stopped a system call that was made with all signals blocked, as starting a thread does: a unit runs in one thread"};
        if (recording.note == wire::Note::none) return {Verdict::crashed, fmt::format("signal {} ({})", signal, strsignal(signal))};
    }
    return from_note(recording, limits);
}

}

RunOutcome judge_end(const protocol::Ended& ended, bool confined, std::span<const std::byte> bytes, std::string_view printed, const Limits& limits)
{
    RunOutcome outcome;
    outcome.wall_seconds = ended.wall_seconds;
    outcome.cpu_seconds = ended.cpu_seconds;
    outcome.output = printable(printed, protocol::output_size);
    try {
        outcome.recording = parse_recording(bytes);
    } catch (const DamagedRecording& damage) {
        outcome.verdict = ended.timed_out != 0 ? Verdict::timeout : Verdict::crashed;
        outcome.message = fmt::format("the recording of this run was overwritten by your code ({})", damage.what());
        if (!confined) outcome = not_confined(ended, "");
        return outcome;
    }
    if (!confined) return not_confined(ended, outcome.recording.text);
    std::set<std::string> names;
    for (const unsigned call : outcome.recording.refused) names.insert(sandbox::call_name(call));
    outcome.refused.assign(names.begin(), names.end());

    const bool finished = outcome.recording.stage == wire::Stage::finished && WIFEXITED(ended.wait_status) && WEXITSTATUS(ended.wait_status) == 0;
    if (finished && ended.timed_out == 0) {
        outcome.verdict = Verdict::ok;
        return outcome;
    }
    End end = ended_early(ended, outcome.recording, limits);
    if (const std::string assertion = assertion_in(outcome.output);
        end.verdict == Verdict::crashed && outcome.recording.signal == SIGABRT && !assertion.empty())
        end.message = assertion;
    // A crash after a refused call is the refusal's consequence: naming it helps more than the signal does.
    if (end.verdict == Verdict::crashed && !outcome.refused.empty()) end = {Verdict::blocked, refused_text(outcome.refused) + "; then " + end.message};
    outcome.verdict = end.verdict;
    outcome.message = printable(end.message, sizeof(wire::Header::text));
    return outcome;
}

}
