#include "run/spawner.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>
#include <system_error>

#include "run/inquiry_json.hpp"
#include "run/machine_trouble.hpp"
#include "run/outcome.hpp"
#include "run/protocol.hpp"
#include "run/source_frame.hpp"

namespace umbral::grader {
namespace {

/// A file of this size mapped to be read; unmapped at the end.
class ReadOnlyMap {
public:
    ReadOnlyMap(int file, std::size_t size) : memory_(mmap(nullptr, size, PROT_READ, MAP_SHARED, file, 0)), size_(size)
    {
        if (memory_ == MAP_FAILED) throw std::system_error(errno, std::generic_category(), "mmap of a recording");
    }
    ReadOnlyMap(const ReadOnlyMap&) = delete;
    ReadOnlyMap& operator=(const ReadOnlyMap&) = delete;
    ~ReadOnlyMap() { munmap(memory_, size_); }
    [[nodiscard]] std::span<const std::byte> bytes() const { return {static_cast<const std::byte*>(memory_), size_}; }

private:
    void* memory_;
    std::size_t size_;
};

Descriptor memory_of(const char* name, std::string_view text)
{
    Descriptor file = sealed_memory(name, text.size());
    if (pwrite(file.get(), text.data(), text.size(), 0) != static_cast<ssize_t>(text.size()))
        throw std::system_error(errno, std::generic_category(), std::string("writing the memory file '") + name + "'");
    return file;
}

/// What a run parses before it is confined: names and numbers of ours, nothing that a student wrote.
std::string job_text(const RunRequest& request)
{
    const nlohmann::json job = {
        {"case", request.case_name},
        {"stream", request.stream},
        {"driver", request.driver.string()},
        {"solution", request.solution.string()},
        {"used", request.used.string()},
        {"counted_table", request.costs.table},
        {"counted_sizes", request.costs.sizes},
        {"inquiry", to_json(request.inquiry)},
        {"passed_over", request.passed_over.questions},
        {"passed_over_functions", request.passed_over.functions},
        {"end", request.passed_over.end},
        {"asked_only", request.passed_over.only},
        {"beside", request.beside ? nlohmann::json(*request.beside) : nlohmann::json()},
        {"mutant", request.mutant},
        {"fresh_memory", static_cast<int>(request.fresh_memory)},
        {"memory", static_cast<std::uint64_t>(request.limits.memory_mib) << 20U},
        {"cpu_seconds", static_cast<std::uint64_t>(std::ceil(request.limits.wall_seconds)) + 1}};
    return job.dump();
}

/// What was written to the bounded output: up to the file's position, or to its last non-zero byte if a hostile run
/// moved that.
std::string printed(int file)
{
    std::string text(protocol::output_size, '\0');
    text.resize(static_cast<std::size_t>(std::max<ssize_t>(0, pread(file, text.data(), text.size(), 0))));
    text.resize(text.find_last_not_of('\0') + 1);
    return text;
}

/// Did a run that is over say that it reached its sandbox?
bool said_confined(int socket)
{
    std::uint8_t said = 0;
    return recv(socket, &said, sizeof said, MSG_DONTWAIT) == sizeof said && said == protocol::confined;
}

/// Does `work`; a std::system_error becomes one that says what the machine lacks.
template <class Work>
auto with_cause(Work work)
{
    try {
        return work();
    } catch (const std::system_error& error) {
        throw std::runtime_error(machine_trouble(error));
    }
}

/// The libraries of a run that are not there: our fault, not the student's.
std::string missing_libraries(const RunRequest& request)
{
    for (const std::filesystem::path& library : {request.driver, request.solution, request.used})
        if (!library.empty() && access(library.c_str(), R_OK) != 0)
            return library.string() + " cannot be read; is the project built?";
    return "";
}

}

Spawner::Spawner(std::filesystem::path program, const std::string& gl_backend) : program_(std::move(program))
{
    const char* const environment = std::getenv("UMBRAL_GL");
    gl_choice_ = "UMBRAL_GL=" + (gl_backend.empty() && environment != nullptr ? environment : gl_backend);
    with_cause([&] { start(); });
}
Spawner::~Spawner() { stop(); }

void Spawner::start()
{
    auto [ours, theirs] = socket_pair();
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, theirs.get(), protocol::control_descriptor);
    posix_spawn_file_actions_addclosefrom_np(&actions, protocol::control_descriptor + 1);
    // No thread beside the first: fork after others have started hangs, and the sandbox forbids them. No disk cache of
    // shaders: it would be shared between students. Pictures here are small: optimising a shader takes longer than
    // drawing with it as it is.
    std::array environment{gl_choice_.data(),
                           const_cast<char*>("LP_NUM_THREADS=0"),
                           const_cast<char*>("MESA_SHADER_CACHE_DISABLE=true"),
                           const_cast<char*>("GALLIUM_DRIVER=llvmpipe"),
                           const_cast<char*>("GALLIVM_PERF=nopt"),
                           const_cast<char*>("LC_ALL=C.UTF-8"),
                           static_cast<char*>(nullptr)};
    std::array arguments{const_cast<char*>(program_.c_str()), static_cast<char*>(nullptr)};
    const int failed =
        posix_spawn(&process_, program_.c_str(), &actions, nullptr, arguments.data(), environment.data());
    posix_spawn_file_actions_destroy(&actions);
    if (failed != 0) {
        process_ = -1;
        throw std::system_error(failed, std::generic_category(), "starting " + program_.filename().string());
    }
    control_ = std::move(ours);
    theirs.reset();

    protocol::Hello hello;
    const Packet packet = receive_packet(control_.get(), writable_bytes_of(hello));
    if (packet.size == sizeof hello && hello.trouble[0] != 0) {
        stop();
        throw std::runtime_error(program_.filename().string() + " did not get ready: " +
                                 std::string(hello.trouble, strnlen(hello.trouble, sizeof hello.trouble)));
    }
    if (packet.size != sizeof hello || hello.version != protocol::Hello{}.version) {
        stop();
        throw std::runtime_error(program_.string() + " did not get ready; `umbral doctor` says what is missing");
    }
    protections_.clear();
    std::istringstream lines(std::string(hello.protections, strnlen(hello.protections, sizeof hello.protections)));
    for (std::string line; std::getline(lines, line);) protections_.push_back(line);
    gl_.assign(hello.gl, strnlen(hello.gl, sizeof hello.gl));
}

void Spawner::stop() noexcept
{
    control_.reset();
    if (process_ <= 0) return;
    kill(process_, SIGKILL);
    while (waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
    }
    process_ = -1;
}

RunOutcome Spawner::run(const RunRequest& request)
{
    if (std::string missing = missing_libraries(request); !missing.empty()) {
        RunOutcome outcome;
        outcome.message = std::move(missing);
        return outcome;
    }
    return with_cause([&] {
        RunOutcome outcome = run_once(request);
        // Whoever killed it (see outcome.cpp) may have found room meanwhile.
        if (outcome.killed_from_outside) outcome = run_once(request);
        return outcome;
    });
}

RunOutcome Spawner::run_once(const RunRequest& request)
{
    const Descriptor recording = sealed_memory("recording", wire::maximum_size);
    const Descriptor output = sealed_memory("output", protocol::output_size);
    const Descriptor job = memory_of("job", job_text(request));
    const Descriptor texts = memory_of("texts", framed(request.sources));
    for (int attempt = 0; attempt < 2; ++attempt) {
        auto [ours, theirs] = socket_pair();
        try {
            const std::array theirs_only{theirs.get()};
            send_packet(control_.get(), bytes_of(protocol::Start{request.limits.wall_seconds}), theirs_only);
            theirs.reset();
            const std::array given{recording.get(), output.get(), job.get(), texts.get()};
            const std::byte byte{};
            send_packet(ours.get(), {&byte, 1}, given);
            protocol::Ended ended;
            const Packet packet = receive_packet(control_.get(), writable_bytes_of(ended));
            if (packet.size == sizeof ended) {
                const ReadOnlyMap map(recording.get(), wire::maximum_size);
                return judge_end(ended, said_confined(ours.get()), map.bytes(), printed(output.get()), request);
            }
        } catch (const std::system_error&) {
            if (attempt == 1) throw;
        }
        stop();
        start();
    }
    RunOutcome outcome;
    outcome.message = "the spawner died twice on this case";
    return outcome;
}

}
