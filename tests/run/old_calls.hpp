#pragma once

#include <sys/wait.h>
#include <unistd.h>

namespace umbral::grader::test {

/// Does this kernel take 32-bit calls (int 0x80)? If not, it ends whoever makes one by a signal, before any filter is
/// asked.
inline bool takes_old_calls()
{
#if defined(__x86_64__)
    const pid_t child = fork();
    if (child == 0) {
        long number = 20;  // getpid
        asm volatile("int $0x80" : "+a"(number) : : "memory", "r8", "r9", "r10", "r11");
        _exit(0);
    }
    int status = 0;
    return child > 0 && waitpid(child, &status, 0) == child && WIFEXITED(status);
#else
    return false;
#endif
}

}
