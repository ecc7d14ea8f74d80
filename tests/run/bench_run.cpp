#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <fstream>
#include <functional>

#include "support/workbench.hpp"

// What a run costs, beside a bare fork of a process that holds as many pages: median and minimum of 200.
namespace {

using namespace umbral::grader;

constexpr int rounds = 200;

void measure(const std::string& what, const std::function<void()>& once)
{
    std::vector<double> times;
    for (int i = 0; i < rounds + 10; ++i) {
        const auto start = std::chrono::steady_clock::now();
        once();
        times.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
    }
    times.erase(times.begin(), times.begin() + 10);
    std::sort(times.begin(), times.end());
    fmt::print("{:44} median {:6.2f} ms   minimum {:6.2f} ms\n", what, times[times.size() / 2], times.front());
}

void run(Spawner& spawner, const RunRequest& request)
{
    const RunOutcome outcome = spawner.run(request);
    if (outcome.verdict != Verdict::ok) throw std::runtime_error(outcome.message);
}

void fork_once()
{
    const pid_t child = fork();
    if (child == 0) _exit(0);
    waitpid(child, nullptr, 0);
}

/// Resident pages of the last child that runs `program`, in bytes.
std::size_t resident(const std::filesystem::path& program)
{
    std::size_t largest = 0;
    for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
        std::error_code none;
        if (std::filesystem::read_symlink(entry.path() / "exe", none) != program) continue;
        std::ifstream statm(entry.path() / "statm");
        std::size_t total = 0;
        std::size_t pages = 0;
        statm >> total >> pages;
        largest = std::max(largest, pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE)));
    }
    return largest;
}

void measure_fork_of(const std::string& what, std::size_t bytes)
{
    void* memory = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) return;
    std::memset(memory, 1, bytes);
    measure(fmt::format("bare fork and wait, {} MiB ({})", bytes >> 20U, what), fork_once);
    munmap(memory, bytes);
}

}

int main()
{
    const test::Workbench bench;
    const auto reference = [&](const char* unit) { return unit_folder(bench.tools(), unit) / "reference.so"; };
    {
        Spawner spawner(bench.spawner());
        const RunRequest sphere = bench.sphere_run(reference("raytracing/sphere"));
        measure("run, sphere, head-on", [&] { run(spawner, sphere); });
        measure_fork_of("as the spawner", std::max<std::size_t>(resident(bench.spawner()), 1));
    }
    const std::filesystem::path with_gl = bench.tools().programs / "umbral-spawner-gl";
    Spawner spawner(with_gl);
    RunRequest view{unit_folder(bench.tools(), "projections/view-matrix") / "driver.so", reference("projections/view-matrix"), {}, "known", 1, {}};
    measure("run with GL, view-matrix, known", [&] { run(spawner, view); });
    view.case_name = "picture";
    measure("run with GL, view-matrix, picture", [&] { run(spawner, view); });
    measure_fork_of("as the spawner with GL", std::max<std::size_t>(resident(with_gl), 1));
    return 0;
}
