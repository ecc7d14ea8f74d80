#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <fstream>
#include <functional>
#include <string_view>

#include "support/workbench.hpp"

// What a run costs, beside a bare fork of a process that holds as many pages: median and minimum of 200, with --quick
// of
// 20. The last line is that of the README.
namespace {

using namespace umbral::grader;

int rounds = 200;

/// Prints median and minimum, and returns the median, in milliseconds.
double measure(const std::string& what, const std::function<void()>& once)
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
    return times[times.size() / 2];
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

double measure_fork_of(const std::string& what, std::size_t bytes)
{
    void* memory = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) return 0;
    std::memset(memory, 1, bytes);
    const double median = measure(fmt::format("bare fork and wait, {} MiB ({})", bytes >> 20U, what), fork_once);
    munmap(memory, bytes);
    return median;
}

}

int main(int count, char** words)
{
    if (count > 1 && std::string_view(words[1]) == "--quick") rounds = 20;
    const test::Workbench bench;
    const auto reference = [&](const char* unit) { return unit_folder(bench.tools(), unit) / "reference.so"; };
    double plain = 0;
    double plain_fork = 0;
    {
        Spawner spawner(bench.spawner());
        const RunRequest sphere = bench.sphere_run(reference("raytracing/sphere"));
        plain = measure("run, sphere, head-on", [&] { run(spawner, sphere); });
        plain_fork = measure_fork_of("as the spawner", std::max<std::size_t>(resident(bench.spawner()), 1));
    }
    const std::filesystem::path with_gl = bench.tools().programs / "umbral-spawner-gl";
    Spawner spawner(with_gl);
    const auto driver = unit_folder(bench.tools(), "projections/view-matrix") / "driver.so";
    RunRequest view{driver, reference("projections/view-matrix"), {}, "known", 1, {}};
    const double gl = measure("run with GL, view-matrix, known", [&] { run(spawner, view); });
    view.case_name = "picture";
    const double picture = measure("run with GL, view-matrix, picture", [&] { run(spawner, view); });
    const double gl_fork = measure_fork_of("as the spawner with GL", std::max<std::size_t>(resident(with_gl), 1));
    fmt::print(
        "\n{:.1f} ms in all, {:.1f} ms with OpenGL (a bare fork: {:.1f} ms and {:.1f} ms); the first draw of a shader "
        "adds about {:.0f} ms\n",
        plain, gl, plain_fork, gl_fork, picture - gl);
    return 0;
}
