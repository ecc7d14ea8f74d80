#include "run/child.hpp"

#include <alloca.h>
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <umbral/core/not_implemented_count.hpp>
#include <umbral/core/student_error.hpp>
#include <umbral/record/block_trace.hpp>
#include <umbral/record/cost.hpp>
#include <umbral/record/driver.hpp>
#include <umbral/record/questions.hpp>
#include <umbral/record/wire.hpp>

#include "model/nearest.hpp"
#include "run/answers_to_others.hpp"
#include "run/companion.hpp"
#include "run/descriptor.hpp"
#include "run/emulated_calls.hpp"
#include "run/fresh_memory.hpp"
#include "run/inquiry_json.hpp"
#include "run/job.hpp"
#include "run/last_words.hpp"
#include "run/protocol.hpp"
#include "run/source_frame.hpp"

namespace umbral::grader {
namespace {

constexpr int exit_load_failure = 71;
constexpr int exit_no_job = 72;
constexpr int exit_no_sandbox = 73;
/// The files of a run in its sandbox, beside standard input and output.
enum RunFile : int {
    socket_until_confined = 3,
    event_until_confined,
    texts_until_read,
    solution_until_loaded,
    driver_until_loaded,
    used_until_loaded,
    first_closed
};

std::string content_of(int file)
{
    struct stat status {};
    fstat(file, &status);
    std::string text(static_cast<std::size_t>(status.st_size), '\0');
    text.resize(static_cast<std::size_t>(std::max<ssize_t>(0, pread(file, text.data(), text.size(), 0))));
    return text;
}

/// Opens a library of the run. A file that is not there any more ends the run before any foreign code: a fault of ours.
int open_library(wire::Header& header, const std::string& path)
{
    const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (file >= 0) return file;
    std::snprintf(header.text, sizeof header.text, "opening %s: %s", path.c_str(), std::strerror(errno));
    _exit(exit_no_job);
}

/// Gives `files` the numbers from `first` on, in their order; a number whose file is -1 is closed.
void number_files(std::span<const int> files, int first)
{
    std::vector<int> apart;
    for (const int file : files)
        apart.push_back(file < 0 ? -1 : fcntl(file, F_DUPFD_CLOEXEC, first + static_cast<int>(files.size())));
    for (std::size_t i = 0; i < apart.size(); ++i) {
        const int number = first + static_cast<int>(i);
        // What had it before must not reach the student's code: the job, say.
        if (apart[i] >= 0)
            dup2(apart[i], number);
        else
            close(number);
    }
}

void note(wire::Header& header, wire::Note kind, const char* text)
{
    header.note = static_cast<std::uint32_t>(kind);
    std::snprintf(header.text, sizeof header.text, "%s", text);
}

/// Loads a library for all to see: the student's before the driver, which looks the unit's functions up in it.
void* load(wire::Header& header, const std::string& path)
{
    void* handle = dlopen(path.c_str(), RTLD_LAZY | RTLD_GLOBAL);
    if (handle != nullptr) return handle;
    note(header, wire::Note::load_failure, dlerror());
    _exit(exit_load_failure);
}

void confine(const ChildSetup& setup, const Job& job)
{
    sandbox::limit_resources({.address_space = setup.base_address_space + job.memory + wire::maximum_size,
                              .cpu_seconds = job.cpu_seconds,
                              .file_size = std::uint64_t{1} << 20U,
                              .descriptors = 16,
                              .no_children = true});
    sandbox::drop_privileges();
    sandbox::drop_capabilities();
    sandbox::confine_files({});
    sandbox::install(setup.filter);
}

const DriverCase* find_case(const Driver& driver, const std::string& name)
{
    const auto found = std::find_if(driver.cases.begin(), driver.cases.end(),
                                    [&](const DriverCase& candidate) { return name == candidate.name; });
    return found == driver.cases.end() ? nullptr : &*found;
}

/// Of interest to whoever wrote the manifest: what the case may have been meant to be called, and what there is.
std::string no_such_case(const Driver& driver, const std::string& name)
{
    std::vector<std::string> known;
    for (const DriverCase& one : driver.cases) known.emplace_back(one.name);
    std::string text = "the driver has no case '" + name + "'" + did_you_mean(nearest(name, known)) + " its cases:";
    for (const std::string& one : known) text += (&one == &known.front() ? " " : ", ") + one;
    return text;
}

// Exceptions of the student's code end in std::terminate on purpose: unwinding would lose the place where they were
// thrown. The stack goes on from a whole step, whatever lies at its end: the spawner's path, say, which is longer in
// one installation than in another, and would have a function that calls itself without end stop at another line.
[[gnu::noinline]] void run_case(const DriverCase& one, Case& what, Recorder& recorder) noexcept
{
    constexpr std::uintptr_t step = 1U << 16U;
    auto* const gap =
        static_cast<volatile char*>(alloca(reinterpret_cast<std::uintptr_t>(__builtin_frame_address(0)) % step + 1));
    *gap = 0;
    one.run(what, recorder);
}

/// Hands the recording over and ends the run.
[[noreturn]] void finish(wire::Header& header, const Recorder::Tensors& tensors)
{
    header.not_implemented = not_implemented_count();
    const std::span room(reinterpret_cast<std::byte*>(&header) + wire::tensors_offset,
                         wire::maximum_size - wire::tensors_offset);
    header.tensors_size = wire::write_tensors(tensors, room);
    header.tensor_count = tensors.size();
    (void)fflush(nullptr);
    header.stage = static_cast<std::uint32_t>(wire::Stage::finished);
    _exit(0);
}

/// The same with what was taken down of questions and, if there is a trace, of blocks.
[[noreturn]] void finish(wire::Header& header, Recorder& recorder, const std::optional<BlockTrace>& trace)
{
    recorder.finish();
    if (!trace) finish(header, recorder.tensors());
    Recorder::Tensors tensors = recorder.tensors();
    trace->write(tensors);
    finish(header, tensors);
}

/// Sets the number by which a library of mutants chooses (mutants/schemata.hpp). Asked for of trusted libraries only.
void choose_mutant(wire::Header& header, void* library, unsigned number)
{
    auto* const chosen = static_cast<int*>(dlsym(library, "umbral_mutant_chosen"));
    if (chosen == nullptr) {
        note(header, wire::Note::load_failure, "the library holds no mutants");
        _exit(exit_load_failure);
    }
    *chosen = static_cast<int>(number);
}

}

void live(const ChildSetup& setup, int run_socket, int confined) noexcept
{
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    std::byte byte{};
    Packet packet = receive_packet(run_socket, {&byte, 1});
    if (packet.closed || packet.descriptors.size() != protocol::job_descriptors) _exit(exit_no_job);
    const int recording = packet.descriptors[0].get();
    const int output = packet.descriptors[1].get();

    void* memory = mmap(nullptr, wire::maximum_size, PROT_READ | PROT_WRITE, MAP_SHARED, recording, 0);
    if (memory == MAP_FAILED) _exit(exit_no_job);
    auto& header = *static_cast<wire::Header*>(memory);
    header.magic = wire::magic;
    const Job job = job_from(content_of(packet.descriptors[2].get()));

    const int driver = open_library(header, job.driver);
    const int solution = job.solution.empty() ? -1 : open_library(header, job.solution);
    const int used = job.used.empty() ? -1 : open_library(header, job.used);
    const int nothing = open("/dev/null", O_RDONLY | O_CLOEXEC);
    dup2(nothing, 0);
    dup2(output, 1);
    dup2(output, 2);
    number_files(std::array{run_socket, confined, packet.descriptors[3].get(), solution, driver, used},
                 socket_until_confined);
    close_range(first_closed, ~0U, 0);
    for (Descriptor& given : packet.descriptors) given.release();
    if (solution >= 0) emulated_calls::hand_out_once(job.solution.c_str(), solution_until_loaded);
    emulated_calls::hand_out_once(job.driver.c_str(), driver_until_loaded);
    if (used >= 0) emulated_calls::hand_out_once(job.used.c_str(), used_until_loaded);

    last_words::listen(header);
    try {
        confine(setup, job);
    } catch (const std::exception& error) {
        note(header, wire::Note::driver_fault, error.what());
        _exit(exit_no_sandbox);
    }
    // The grader's own knowledge of where foreign code begins: from here on the recording may say anything. The
    // student's time begins here too.
    constexpr std::uint64_t one_event = 1;
    if (write(socket_until_confined, &protocol::confined, sizeof protocol::confined) != sizeof protocol::confined)
        _exit(exit_no_sandbox);
    if (write(event_until_confined, &one_event, sizeof one_event) != sizeof one_event) _exit(exit_no_sandbox);
    close(socket_until_confined);
    close(event_until_confined);
    header.stage = static_cast<std::uint32_t>(wire::Stage::confined);

    Case what{job.case_name, Random(job.stream, job.inquiry.grain), unframed(content_of(texts_until_read)),
              Variation(job.stream)};
    close(texts_until_read);
    // Line by line, so that what was printed before a crash is not lost.
    setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
    fill_fresh_memory(job.fresh_memory);
    if (!job.solution.empty()) {
        void* const solution_library = load(header, job.solution);
        last_words::set_library(header, solution_library);
        if (job.mutant != 0) choose_mutant(header, solution_library, job.mutant);
    }
    if (!job.used.empty()) (void)load(header, job.used);
    void* driver_library = load(header, job.driver);
    const auto* cases = static_cast<const Driver*>(dlsym(driver_library, "_ZN6umbral6driverE"));
    if (cases == nullptr) {
        note(header, wire::Note::load_failure, "the driver library defines no umbral::driver");
        _exit(exit_load_failure);
    }
    const DriverCase* one = find_case(*cases, what.name);
    if (one == nullptr) {
        note(header, wire::Note::load_failure, no_such_case(*cases, what.name).c_str());
        _exit(exit_load_failure);
    }
    header.stage = static_cast<std::uint32_t>(wire::Stage::loaded);
    header.stage = static_cast<std::uint32_t>(wire::Stage::running);

    if (!job.costs.table.empty()) limit_costs(job.costs);
    if (!job.inquiry.others.empty()) finish(header, answers_to_others(*one, what, job.inquiry.others));
    Questions questions(job.inquiry);
    Recorder* recorded = nullptr;
    std::optional<BlockTrace> trace;
    const auto end = [&] { finish(header, *recorded, trace); };
    Progress progress(header.asked, header.function, job.passed_over, end);
    Recorder recorder = asks_anything(job.inquiry) ? Recorder(questions) : Recorder(progress);
    recorded = &recorder;
    std::optional<Companion> other;
    std::optional<Companion> nearly_same;
    if (job.beside) {
        const std::uint64_t stream = *job.beside;
        other.emplace(*one, Case{what.name, Random(stream), what.sources, Variation(stream)}, 1);
        nearly_same.emplace(
            *one, Case{what.name, Random::with_slips(job.stream, stream | 1U), what.sources, Variation::of_few(stream)},
            0);
        progress.at_each_question([&] {
            other->take_turn();
            nearly_same->take_turn();
        });
    }
    if (job.inquiry.blocks) {
        trace.emplace(static_cast<std::uintptr_t>(header.library_base), end);
        questions.at_each_question([&] { trace->next_question(); });
        questions.at_each_exception([&] { trace->end_by_exception(); });
    }
    run_case(*one, what, recorder);
    finish(header, recorder, trace);
}

}
