#pragma once

#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <string>

namespace umbral::test {

/// What a command printed (both streams), and its exit status.
struct Printed {
    int status = -1;
    std::string text;
};

/// Runs a command line through the shell.
inline Printed run(const std::string& command)
{
    const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen((command + " 2>&1").c_str(), "re"), [](FILE*) { return 0; });
    if (!pipe) throw std::runtime_error("popen failed");
    Printed printed;
    std::array<char, 4096> buffer{};
    for (std::size_t got = 0; (got = fread(buffer.data(), 1, buffer.size(), pipe.get())) > 0;)
        printed.text.append(buffer.data(), got);
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
