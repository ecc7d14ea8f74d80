#include "run/child.hpp"

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
#include <nlohmann/json.hpp>
#include <umbral/core/not_implemented_count.hpp>
#include <umbral/core/student_error.hpp>
#include <umbral/record/driver.hpp>
#include <umbral/record/wire.hpp>

#include "run/descriptor.hpp"
#include "run/last_words.hpp"
#include "run/protocol.hpp"

namespace umbral::grader {
namespace {

constexpr int exit_load_failure = 71;
constexpr int exit_no_job = 72;
constexpr int exit_no_sandbox = 73;
constexpr int socket_until_confined = 3;

struct Job {
    Case what;
    std::string driver;
    std::string tenant;  ///< empty for a unit without C++
    std::uint64_t memory = 0;
    std::uint64_t cpu_seconds = 0;
};

Job read_job(int file)
{
    struct stat status {};
    fstat(file, &status);
    std::string text(static_cast<std::size_t>(status.st_size), '\0');
    text.resize(static_cast<std::size_t>(std::max<ssize_t>(0, pread(file, text.data(), text.size(), 0))));
    const nlohmann::json json = nlohmann::json::parse(text.c_str());
    return {Case{json.at("case"), Random(json.at("seed").get<std::uint64_t>()), json.at("sources")}, json.at("driver"), json.at("tenant"), json.at("memory"),
            json.at("cpu_seconds")};
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
    std::vector<sandbox::FileRule> files{{job.driver}};
    if (!job.tenant.empty()) files.push_back({job.tenant});
    sandbox::confine_files(files);
    sandbox::install(setup.loading);
}

const DriverCase* find_case(const Driver& driver, const std::string& name)
{
    const auto found = std::find_if(driver.cases.begin(), driver.cases.end(), [&](const DriverCase& candidate) { return name == candidate.name; });
    return found == driver.cases.end() ? nullptr : &*found;
}

// Exceptions of the student's code end in std::terminate on purpose: unwinding would lose the place where they were thrown.
void run_case(const DriverCase& one, Case& what, Recorder& recorder) noexcept { one.run(what, recorder); }

}

void live(const ChildSetup& setup, int run_socket) noexcept
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
    Job job = read_job(packet.descriptors[2].get());

    const int nothing = open("/dev/null", O_RDONLY | O_CLOEXEC);
    dup2(nothing, 0);
    dup2(output, 1);
    dup2(output, 2);
    packet.descriptors.clear();
    dup2(run_socket, socket_until_confined);
    close_range(socket_until_confined + 1, ~0U, 0);

    last_words::listen(header);
    try {
        confine(setup, job);
    } catch (const std::exception& error) {
        note(header, wire::Note::driver_fault, error.what());
        _exit(exit_no_sandbox);
    }
    // The grader's own knowledge of where foreign code begins: from here on the recording may say anything.
    if (write(socket_until_confined, &protocol::confined, sizeof protocol::confined) != sizeof protocol::confined) _exit(exit_no_sandbox);
    close(socket_until_confined);
    header.stage = static_cast<std::uint32_t>(wire::Stage::confined);

    // Line by line, so that what was printed before a crash is not lost.
    setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
    if (!job.tenant.empty()) last_words::set_library(header, load(header, job.tenant));
    void* driver_library = load(header, job.driver);
    const auto* cases = static_cast<const Driver*>(dlsym(driver_library, "_ZN6umbral6driverE"));
    const DriverCase* one = cases == nullptr ? nullptr : find_case(*cases, job.what.name);
    if (one == nullptr) {
        note(header, wire::Note::load_failure, "the driver library defines no umbral::driver with this case");
        _exit(exit_load_failure);
    }
    header.stage = static_cast<std::uint32_t>(wire::Stage::loaded);
    sandbox::install(setup.running);
    header.stage = static_cast<std::uint32_t>(wire::Stage::running);

    Recorder recorder;
    run_case(*one, job.what, recorder);

    header.not_implemented = not_implemented_count();
    const std::span room(static_cast<std::byte*>(memory) + wire::tensors_offset, wire::maximum_size - wire::tensors_offset);
    header.tensors_size = wire::write_tensors(recorder.tensors(), room);
    header.tensor_count = recorder.tensors().size();
    (void)fflush(nullptr);
    header.stage = static_cast<std::uint32_t>(wire::Stage::finished);
    _exit(0);
}

}
