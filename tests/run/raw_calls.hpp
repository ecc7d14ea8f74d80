#pragma once

#include <string>

namespace umbral::grader::test {

/// C++ for the head of a hostile sphere.cpp: system calls without the C library, and say(), which prints what a call
/// gave.
inline const std::string raw_calls = R"(
#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <netinet/in.h>

namespace {

template <class... Words>
long raw(long number, Words... words)
{
    const long w[6] = {(long)words...};
#if defined(__x86_64__)
    register long a3 asm("r10") = w[3];
    register long a4 asm("r8") = w[4];
    register long a5 asm("r9") = w[5];
    long result;
    asm volatile("syscall" : "=a"(result) : "a"(number), "D"(w[0]), "S"(w[1]), "d"(w[2]), "r"(a3), "r"(a4),
    "r"(a5) : "rcx", "r11", "memory");
    return result;
#elif defined(__aarch64__)
    register long x8 asm("x8") = number;
    register long x0 asm("x0") = w[0];
    register long x1 asm("x1") = w[1];
    register long x2 asm("x2") = w[2];
    register long x3 asm("x3") = w[3];
    register long x4 asm("x4") = w[4];
    register long x5 asm("x5") = w[5];
    asm volatile("svc 0" : "+r"(x0) : "r"(x8), "r"(x1), "r"(x2), "r"(x3), "r"(x4), "r"(x5) : "memory");
    return x0;
#endif
}

void say(const char* what, long got)
{
    std::printf("%s %ld\n", what, got);
    std::fflush(stdout);
}

}
)";

}
