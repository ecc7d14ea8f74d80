#include "run/machine_trouble.hpp"

#include <cerrno>
#include <cstring>

namespace umbral::grader {
namespace {

/// What is short, and what to do about it; empty for what is no shortage.
const char* shortage(int error)
{
    switch (error) {
        case EAGAIN:
            return "the machine has no process left: end other programs, raise `ulimit -u`, or grade with fewer --jobs";
        case ENOMEM: return "the machine has no memory left: end other programs, or grade with fewer --jobs";
        case EMFILE: return "this program has no open file left: raise `ulimit -n`, or grade with fewer --jobs";
        case ENFILE: return "the machine has no open file left: end other programs";
        case ENOSPC: return "there is no space left for memory files: end other programs, or grade with fewer --jobs";
        default: return "";
    }
}

std::string in_words(int error, std::string_view said)
{
    const std::string_view cause = shortage(error);
    if (cause.empty()) return "the operating system refused: " + std::string(said);
    return std::string(cause) + " (" + std::string(said) + ")";
}

}

std::string machine_trouble(int error, std::string_view tried)
{
    return in_words(error, std::string(tried) + ": " + std::strerror(error));
}

std::string machine_trouble(const std::system_error& error) { return in_words(error.code().value(), error.what()); }

}
