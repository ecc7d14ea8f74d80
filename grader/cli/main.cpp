#include "cli/commands.hpp"
#include "cli/run_program.hpp"

int main(int count, char** words)
{
    return umbral::grader::run_program({words, static_cast<std::size_t>(count)}, umbral::grader::all_commands);
}
