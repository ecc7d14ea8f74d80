#include "attack/measured.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <exception>
#include <fstream>
#include <system_error>
#include <thread>

namespace umbral::grader::attack {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

std::vector<char*> pointers(const std::vector<std::string>& words)
{
    std::vector<char*> result;
    result.reserve(words.size() + 1);
    for (const std::string& word : words) result.push_back(const_cast<char*>(word.c_str()));
    result.push_back(nullptr);
    return result;
}

[[noreturn]] void replace_process(const Call& call)
{
    try {
        const int output = open(call.output.c_str(), O_WRONLY | O_CREAT | O_TRUNC, S_IRUSR | S_IWUSR);
        const int input = open("/dev/null", O_RDONLY);
        dup2(input, 0);
        dup2(output, 1);
        dup2(output, 2);
        close_range(3, ~0U, 0);
        setpgid(0, 0);
        if (call.before) call.before();
        std::vector<char*> words = pointers(call.words);
        std::vector<char*> environment = pointers(call.environment);
        execve(words.front(), words.data(), environment.data());
    } catch (const std::exception& error) {
        (void)std::fprintf(stderr, "%s\n", error.what());
    }
    _exit(127);
}

/// The peak of a living process's memory; 0 once it is dead.
double peak_mib(pid_t process)
{
    std::ifstream status("/proc/" + std::to_string(process) + "/status");
    for (std::string word; status >> word;) {
        double kib = 0;
        if (word == "VmHWM:" && status >> kib) return kib / 1024;
    }
    return 0;
}

}

Measured run_measured(const Call& call)
{
    const auto start = Clock::now();
    const pid_t process = fork();
    if (process < 0) throw std::system_error(errno, std::generic_category(), "fork");
    if (process == 0) replace_process(call);
    Measured measured;
    int status = 0;
    for (;;) {
        measured.peak_mib = std::max(measured.peak_mib, peak_mib(process));
        const pid_t ended = waitpid(process, &status, WNOHANG);
        if (ended == process || (ended < 0 && errno != EINTR)) break;
        measured.seconds = std::chrono::duration<double>(Clock::now() - start).count();
        if (!measured.timed_out && measured.seconds > call.seconds) {
            measured.timed_out = true;
            kill(-process, SIGKILL);
        }
        if (call.interrupt && call.interrupt()) kill(process, SIGKILL);
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    measured.seconds = std::chrono::duration<double>(Clock::now() - start).count();
    if (WIFEXITED(status)) measured.status = WEXITSTATUS(status);
    if (WIFSIGNALED(status)) measured.signal = WTERMSIG(status);
    measured.printed = bytes_of_file(call.output, std::size_t{4} << 20U);
    return measured;
}

double disk_kib(const fs::path& folder)
{
    double kib = 0;
    std::error_code error;
    const auto options = fs::directory_options::skip_permission_denied;
    for (fs::recursive_directory_iterator at(folder, options, error), end; !error && at != end; at.increment(error)) {
        struct stat status {};
        if (lstat(at->path().c_str(), &status) == 0 && S_ISREG(status.st_mode))
            kib += static_cast<double>(status.st_blocks) / 2;
    }
    return kib;
}

std::string bytes_of_file(const fs::path& file, std::size_t limit)
{
    std::ifstream stream(file, std::ios::binary);
    std::string bytes;
    char buffer[65536];
    while (bytes.size() < limit && (stream.read(buffer, sizeof buffer), stream.gcount() > 0))
        bytes.append(buffer, static_cast<std::size_t>(stream.gcount()));
    return bytes;
}

}
