#include <signal.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "support/printed.hpp"
#include "support/temporary_folder.hpp"

// Prints how long a student waits for `umbral check` of one unit in C++: never built before, unchanged, and from a save
// to its verdict under --watch; not a test. The median, and for saves the range, of seven; with --quick of one.
namespace {

using namespace umbral::test;

double seconds_since(std::chrono::steady_clock::time_point start)
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double median(std::vector<double> times)
{
    std::ranges::sort(times);
    return times.at(times.size() / 2);
}

constexpr const char* student_file = "raytracing/sphere/sphere.cpp";

class Student {
public:
    Student() { save(0); }

    /// Saves the file with another comment in it: it has to be compiled anew.
    void save(int number) const { folder_.write(student_file, right_ + "// version " + std::to_string(number) + "\n"); }

    /// How `umbral check` is called, with a cache of this name.
    [[nodiscard]] std::string command(const std::string& cache) const
    {
        return "UMBRAL_CACHE='" + (folder_ / cache).string() + "' exec " UMBRAL_PROGRAM " check sphere --dir '" +
               folder_.path().string() + "'";
    }

    /// Seconds of one check.
    [[nodiscard]] double check(const std::string& cache) const
    {
        const auto start = std::chrono::steady_clock::now();
        const Printed printed = run(command(cache));
        const double seconds = seconds_since(start);
        if (printed.status != 0)
            throw std::runtime_error("expected that the right answer is right; umbral check said:\n" + printed.text);
        return seconds;
    }

private:
    TemporaryFolder folder_;
    std::string right_ = read(std::filesystem::path(UMBRAL_SOURCE) / "reference/raytracing/sphere.cpp");
};

/// Seconds from each save to the report about it.
std::vector<double> watch(const Student& student, int rounds)
{
    FILE* const pipe = popen(("echo $$; " + student.command("watched") + " --watch --json").c_str(), "re");
    if (pipe == nullptr) throw std::runtime_error("cannot start umbral check --watch");
    const auto line = [&] {
        std::string text;
        for (int c = 0; (c = std::fgetc(pipe)) != '\n' && c != EOF;) text += static_cast<char>(c);
        return text;
    };
    const pid_t process = std::stoi(line());
    (void)line();
    std::vector<double> times;
    for (int i = 0; i < rounds; ++i) {
        const auto start = std::chrono::steady_clock::now();
        student.save(1000 + i);
        if (line().empty()) break;
        times.push_back(seconds_since(start));
    }
    kill(process, SIGINT);
    (void)pclose(pipe);
    if (times.empty()) throw std::runtime_error("umbral check --watch ended before it had checked what was saved");
    return times;
}

}

int main(int count, char** words)
{
    try {
        const int rounds = count > 1 && std::string_view(words[1]) == "--quick" ? 1 : 7;
        const Student student;
        std::vector<double> first;
        std::vector<double> again;
        for (int i = 0; i < rounds; ++i) {
            first.push_back(student.check("cache" + std::to_string(i)));
            again.push_back(student.check("cache" + std::to_string(i)));
        }
        const std::vector<double> saved = watch(student, rounds);
        const auto [least, most] = std::ranges::minmax(saved);
        std::printf("check of one C++ unit, never built before   %.2f s\n", median(first));
        std::printf("check of one C++ unit, unchanged            %.2f s\n", median(again));
        std::printf("from a save to its verdict                  %.2f to %.2f s\n", least, most);
        return 0;
    } catch (const std::exception& error) {
        (void)std::fprintf(stderr, "bench-check: %s\n", error.what());
        return 1;
    }
}
