#include <malloc.h>

#include "cli/commands.hpp"
#include "cli/run_program.hpp"

namespace {

/// Tables and pictures of megabytes come and go by the hundred. Memory that was used for one is kept for the next,
/// since new pages from the system cost more than what is done with them.
void keep_freed_memory()
{
    constexpr int table = 32 << 20;
    constexpr int kept = 128 << 20;
    mallopt(M_MMAP_THRESHOLD, table);
    mallopt(M_TRIM_THRESHOLD, kept);
}

}

int main(int count, char** words)
{
    keep_freed_memory();
    return umbral::grader::run_program({words, static_cast<std::size_t>(count)}, umbral::grader::all_commands);
}
