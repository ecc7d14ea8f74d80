#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>

#include "build/assembler_text.hpp"

// as ARGUMENT…
//
// What the compiler runs in place of the assembler (-B) on students' files: looks through the text that is to be
// assembled, and becomes the assembler if C++ alone led to it. Otherwise it ends with a line that says what is foreign.

using namespace umbral::grader;

namespace {

constexpr const char* assembler = "/usr/bin/as";

/// Looks through one file. False, with a word about it on stderr, if it is not to be assembled.
bool may_be_assembled(const char* file)
{
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    if (!stream) return std::fprintf(stderr, "umbral-as: cannot read %s\n", file), false;
    const auto foreign = find_foreign_assembler(text.view());
    if (foreign)
        std::fprintf(stderr, "%.*s%s\n", static_cast<int>(assembler_refused.size()), assembler_refused.data(),
                     foreign->c_str());
    return !foreign;
}

}

int main(int count, char** arguments)
{
    bool is_output = false;
    bool has_looked = false;
    for (int i = 1; i < count; ++i) {
        const std::string_view word = arguments[i];
        if (!is_output && word.ends_with(".s")) {
            if (!may_be_assembled(arguments[i])) return 1;
            has_looked = true;
        }
        is_output = word == "-o";
    }
    // Text that comes another way would not have been looked through.
    if (!has_looked) {
        std::fprintf(stderr, "umbral-as: expected a file that ends in .s\n");
        return 1;
    }
    execv(assembler, arguments);
    std::fprintf(stderr, "umbral-as: %s cannot be run: %s\n", assembler, std::strerror(errno));
    return 1;
}
