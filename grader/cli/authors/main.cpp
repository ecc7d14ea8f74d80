#include "cli/authors/commands.hpp"
#include "cli/run_program.hpp"

// umbral-authors: the commands that students and graders do without, so that they need not be built for them. umbral
// starts it.
int main(int count, char** words)
{
    return umbral::grader::run_program({words, static_cast<std::size_t>(count)}, umbral::grader::authors_commands);
}
