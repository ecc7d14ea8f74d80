#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <vector>

#include "run/sandbox.hpp"

// umbral-confine MEMORY_MIB CPU_SECONDS DIRECTORY [TREE…] -- PROGRAM [ARGUMENT…]
// Runs a program that may write DIRECTORY (and works there), read and execute /usr and the TREEs, and nothing else: no network.
int main(int count, char** words)
{
    using namespace umbral::grader;
    try {
        int at = 4;
        if (count < at + 2) throw std::runtime_error("usage: umbral-confine MEMORY_MIB CPU_SECONDS DIRECTORY [TREE…] -- PROGRAM [ARGUMENT…]");
        std::vector<sandbox::FileRule> files{{words[3], true, false}, {"/usr", false, true}, {"/etc/ld.so.cache"}, {"/dev/null", true}};
        for (; at < count && std::strcmp(words[at], "--") != 0; ++at) files.push_back({words[at], false, true});
        if (at + 1 >= count) throw std::runtime_error("umbral-confine: no program after --");
        if (chdir(words[3]) != 0) throw std::runtime_error(std::string("umbral-confine: cannot enter ") + words[3]);
        sandbox::limit_resources({.address_space = std::strtoull(words[1], nullptr, 10) << 20U,
                                  .cpu_seconds = std::strtoull(words[2], nullptr, 10),
                                  .file_size = std::uint64_t{256} << 20U,
                                  .descriptors = 256,
                                  .no_children = false});
        sandbox::enter_namespaces(false);
        sandbox::drop_privileges();
        sandbox::confine_files(files);
        sandbox::install(sandbox::compiler_filter());
        execvp(words[at + 1], words + at + 1);
        throw std::runtime_error(std::string("umbral-confine: cannot run ") + words[at + 1] + ": " + std::strerror(errno));
    } catch (const std::exception& error) {
        (void)std::fprintf(stderr, "%s\n", error.what());
        return 126;
    }
}
