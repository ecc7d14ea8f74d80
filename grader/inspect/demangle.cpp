#include "inspect/demangle.hpp"

// libiberty declares basename() for C unless it is told that it is there.
#define HAVE_DECL_BASENAME 1
#include <libiberty/demangle.h>

#include <csetjmp>
#include <cstring>

namespace umbral::grader {
namespace {

struct Output {
    std::string text;
    std::size_t limit;
    std::jmp_buf enough;
};

/// The demangler keeps all it needs on the stack, so that it may be left by a jump.
void take(const char* piece, std::size_t size, void* opaque)
{
    auto& output = *static_cast<Output*>(opaque);
    output.text.append(piece, std::min(size, output.limit - output.text.size()));
    if (output.text.size() == output.limit) std::longjmp(output.enough, 1);
}

}

std::string demangled(const char* name, std::size_t limit)
{
    Output output{{}, limit, {}};
    output.text.reserve(limit);
    if (setjmp(output.enough) == 0 && cplus_demangle_v3_callback(name, DMGL_PARAMS | DMGL_ANSI, &take, &output) == 0)
        output.text.assign(name, strnlen(name, limit));
    return output.text;
}

}
