#include "run/outcome.hpp"

#include <fmt/format.h>
#include <sys/wait.h>

#include <array>
#include <csignal>
#include <cstring>
#include <set>

#include "model/caps.hpp"
#include "run/machine_trouble.hpp"
#include "run/run_text.hpp"
#include "run/sandbox.hpp"
#include "text/printable.hpp"

namespace umbral::grader {
namespace {

struct End {
    Verdict verdict;
    std::string message;
};

std::string refused_text(const std::vector<std::string>& names) { return "the sandbox refused: " + listed(names); }

/// What the C and C++ libraries print before they end a process, and what it means.
struct LastPrinted {
    const char* sign;
    Verdict verdict;
    const char* meaning;
};
constexpr std::array last_printed{
    LastPrinted{"cannot allocate memory for thread-local data", Verdict::out_of_memory,
                "your thread_local variables take more memory than the run may have"},
    LastPrinted{"*** stack smashing detected ***", Verdict::crashed,
                "an array on the stack was written beyond its end (stack smashing detected)"},
    LastPrinted{"*** buffer overflow detected ***", Verdict::crashed,
                "an array was written beyond its end (buffer overflow detected)"},
    LastPrinted{"free(): ", Verdict::crashed,
                "memory was freed twice, or an array on the heap was written beyond its end"},
    LastPrinted{"double free or corruption", Verdict::crashed,
                "memory was freed twice, or an array on the heap was written beyond its end"},
    LastPrinted{"malloc(): ", Verdict::crashed, "an array on the heap was written beyond its end"},
    LastPrinted{"corrupted size vs. prev_size", Verdict::crashed, "an array on the heap was written beyond its end"},
};

/// The last line of what was printed, if that is one of these.
const LastPrinted* last_words_of_a_library(std::string_view output)
{
    while (!output.empty() && output.back() == '\n') output.remove_suffix(1);
    const std::string_view line =
        output.substr(output.rfind('\n') == std::string_view::npos ? 0 : output.rfind('\n') + 1);
    for (const LastPrinted& one : last_printed)
        if (line.starts_with(one.sign) ||
            (one.verdict == Verdict::out_of_memory && line.find(one.sign) != std::string_view::npos))
            return &one;
    return nullptr;
}

/// A library that a student's sources were made into may be one that cannot be loaded, or claim so. A driver that
/// cannot be loaded shows in the reference's run of the same case.
End load_failure(const std::string& text, const Limits& limits)
{
    for (const char* const sign :
         {"Cannot allocate memory", "cannot map zero-fill pages", "failed to map segment", "cannot allocate memory"})
        if (text.find(sign) != std::string::npos)
            return {Verdict::out_of_memory,
                    fmt::format("your variables outside functions take more than {} MiB of memory", limits.memory_mib)};
    return {Verdict::crashed, "your code could not be loaded: " + text};
}

/// What the run noted about itself before it ended.
End from_note(const Recording& recording, const Limits& limits)
{
    switch (recording.note) {
        case wire::Note::out_of_memory:
            return {Verdict::out_of_memory, fmt::format("your code asked for more than {} MiB of memory ({})",
                                                        limits.memory_mib, recording.text)};
        case wire::Note::compile_error: return {Verdict::compile_error, recording.text};
        case wire::Note::interface_mismatch: return {Verdict::interface_mismatch, recording.text};
        case wire::Note::stack_overflow:
            return {Verdict::crashed, "the stack overflowed: does a function call itself without end?"};
        case wire::Note::uncaught_exception: return {Verdict::crashed, recording.text};
        case wire::Note::signal: {
            const std::string signal =
                fmt::format("signal {} ({})", recording.signal, strsignal(static_cast<int>(recording.signal)));
            // What ended a program on purpose has said why: the signal's name ("Illegal instruction") would mislead.
            if (recording.signal == SIGILL || recording.signal == SIGTRAP)
                return {Verdict::crashed, recording.text.empty() ? signal : recording.text};
            return {Verdict::crashed, recording.text.empty() ? signal : signal + ": " + recording.text};
        }
        case wire::Note::load_failure: return load_failure(recording.text, limits);
        case wire::Note::driver_fault:
        case wire::Note::none: break;
    }
    return {Verdict::crashed, "the run ended early: does your code call exit?"};
}

/// What assert() or the C++ library printed before it aborted: "Assertion `length(d) < 1' failed."; empty if there is
/// no such line.
std::string assertion_in(const std::string& output)
{
    const std::size_t at = output.rfind("Assertion ");
    return at == std::string::npos ? "" : output.substr(at, output.find('\n', at) - at);
}

RunOutcome not_confined(const protocol::Ended& ended, const std::string& text)
{
    RunOutcome outcome;
    outcome.verdict = Verdict::grader_fault;
    if (ended.could_not_start != 0)
        outcome.message = machine_trouble(ended.could_not_start, "starting a run");
    else if (ended.timed_out != 0)
        outcome.message = fmt::format(
            "the run did not reach its sandbox within {:g} s: the machine is overloaded; grade with fewer --jobs",
            protocol::seconds_to_confine);
    else
        outcome.message = "the run did not reach its sandbox";
    if (!text.empty()) outcome.message += ": " + text;
    return outcome;
}

/// A run that the kernel killed because memory had run out, twice. A run that has taken little is not to blame: the
/// machine is too small for what it does, which is our fault and no zero. One that has taken more than half of what it
/// may is told that it ran out of memory, although the machine could not give it all of it: otherwise whoever takes as
/// much as possible, on a machine that is nearly full, would get a unit that does not count instead of one that earns
/// nothing.
End killed_for_memory(const protocol::Ended& ended, const Limits& limits)
{
    const std::int64_t mib = ended.peak_memory_kib >> 10;
    if (2 * mib > limits.memory_mib)
        return {Verdict::out_of_memory,
                fmt::format("your code took {} MiB of memory, more than there was; {} MiB are the limit", mib,
                            limits.memory_mib)};
    return {Verdict::grader_fault, fmt::format("the machine has no memory left: the operating system killed a run that "
                                               "had taken {} MiB; end other programs, or grade with fewer --jobs",
                                               mib)};
}

bool killed_from_outside(const protocol::Ended& ended, const Limits& limits)
{
    return ended.timed_out == 0 && WIFSIGNALED(ended.wait_status) && WTERMSIG(ended.wait_status) == SIGKILL &&
           ended.cpu_seconds < limits.wall_seconds;
}

/// Of a run that took all its time. Says nothing that another run of the same code might say otherwise: whether its
/// limit of computing or that of all its time ended a loop is chance.
End too_late(const Limits& limits, bool waited)
{
    return {Verdict::timeout,
            fmt::format("stopped after {:g} s{}", limits.wall_seconds,
                        waited ? ", in which it hardly computed: does it wait for a lock, an input, or a time to pass?"
                               : ": is there a loop that never ends, or far more work than is needed?")};
}

End ended_early(const protocol::Ended& ended, const Recording& recording, const Limits& limits)
{
    if (ended.timed_out != 0) return too_late(limits, 2 * ended.cpu_seconds < limits.wall_seconds);
    if (WIFSIGNALED(ended.wait_status)) {
        const int signal = WTERMSIG(ended.wait_status);
        if (killed_from_outside(ended, limits) && ended.out_of_memory_kill != 0)
            return killed_for_memory(ended, limits);
        if (signal == SIGXCPU || (signal == SIGKILL && ended.cpu_seconds >= limits.wall_seconds))
            return too_late(limits, false);
        if (signal == SIGSYS)
            return {Verdict::blocked,
                    "the sandbox stopped a system call that was made with all signals blocked, as starting a thread "
                    "does: a unit runs in one thread"};
        if (recording.note == wire::Note::none)
            return {Verdict::crashed, fmt::format("signal {} ({})", signal, strsignal(signal))};
    }
    return from_note(recording, limits);
}

/// How a run ended that did reach its sandbox.
RunOutcome judge_confined(const protocol::Ended& ended, std::span<const std::byte> bytes, std::string_view output,
                          const RunRequest& request)
{
    RunOutcome outcome;
    outcome.recording = parse_recording(bytes, request.wanted);
    std::set<std::string> names;
    for (const unsigned call : outcome.recording.refused) names.insert(sandbox::call_name(call));
    outcome.refused.assign(names.begin(), names.end());

    const bool finished = outcome.recording.stage == wire::Stage::finished && WIFEXITED(ended.wait_status) &&
                          WEXITSTATUS(ended.wait_status) == 0;
    if (finished && ended.timed_out == 0) {
        outcome.verdict = Verdict::ok;
        return outcome;
    }
    End end = ended_early(ended, outcome.recording, request.limits);
    if (end.verdict == Verdict::crashed) {
        const std::string assertion = assertion_in(std::string(output));
        if (const LastPrinted* said = last_words_of_a_library(output))
            end = {said->verdict, said->meaning};
        else if (outcome.recording.signal == SIGABRT && !assertion.empty())
            end.message = assertion;
    }
    // A crash after a refused call is the refusal's consequence: naming it helps more than the signal does.
    if (end.verdict == Verdict::crashed && !outcome.refused.empty())
        end = {Verdict::blocked, refused_text(outcome.refused) + "; then " + end.message};
    outcome.verdict = end.verdict;
    outcome.message = end.message;
    return outcome;
}

RunOutcome judged(const protocol::Ended& ended, bool confined, std::span<const std::byte> bytes,
                  std::string_view output, const RunRequest& request)
{
    try {
        if (!confined) return not_confined(ended, parse_recording(bytes, request.wanted).text);
        return judge_confined(ended, bytes, output, request);
    } catch (const DamagedRecording& damage) {
        if (!confined) return not_confined(ended, "");
        RunOutcome outcome;
        outcome.verdict = ended.timed_out != 0 ? Verdict::timeout : Verdict::crashed;
        outcome.message = fmt::format("the recording of this run was overwritten by your code ({})", damage.what());
        return outcome;
    }
}

}

RunOutcome judge_end(const protocol::Ended& ended, bool confined, std::span<const std::byte> bytes,
                     std::string_view printed, const RunRequest& request)
{
    const auto clean = [&](std::string_view text, std::size_t limit) {
        return printable(without_roots(text, request.roots), limit);
    };
    std::string output = clean(printed, protocol::output_size);
    RunOutcome outcome = judged(ended, confined, bytes, output, request);
    outcome.wall_seconds = ended.wall_seconds;
    outcome.waited_seconds = ended.waited_seconds;
    outcome.cpu_seconds = ended.cpu_seconds;
    outcome.peak_memory_kib = ended.peak_memory_kib;
    outcome.killed_from_outside = confined && killed_from_outside(ended, request.limits);
    outcome.output = std::move(output);
    // What keeps us from running anything is for whoever runs the machine: there the paths are the point.
    outcome.message = outcome.verdict == Verdict::grader_fault ? printable(outcome.message, caps::message)
                                                               : clean(outcome.message, caps::message);
    outcome.recording.text = clean(outcome.recording.text, caps::message);
    return outcome;
}

}
