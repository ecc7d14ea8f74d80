#pragma once

#include <sys/wait.h>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string>

namespace umbral::test {

/// What a command line of the real program printed (both streams), and its exit status.
struct Printed {
    int status = -1;
    std::string text;
};

/// Runs `umbral ARGUMENTS` through the shell; `before` may set limits or variables.
inline Printed umbral(const std::string& arguments, const std::string& before = "")
{
    const std::string command = before + " exec " UMBRAL_PROGRAM " " + arguments + " 2>&1";
    const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "re"), [](FILE*) { return 0; });
    if (!pipe) throw std::runtime_error("popen failed");
    Printed printed;
    std::array<char, 4096> buffer{};
    for (std::size_t got = 0; (got = fread(buffer.data(), 1, buffer.size(), pipe.get())) > 0;) printed.text.append(buffer.data(), got);
    const int status = pclose(pipe.get());
    printed.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return printed;
}

inline std::string read(const std::filesystem::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

}
