#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <functional>

namespace umbral::grader::test {

/// Calls `works` in a process of its own that has no privileges: nobody's if this one is root's. Did it return true,
/// without throwing and without a signal?
inline bool as_nobody(const std::function<bool()>& works)
{
    const pid_t child = fork();
    if (child == 0) {
        constexpr unsigned nobody = 65534;
        if (geteuid() == 0 && (setresgid(nobody, nobody, nobody) != 0 || setresuid(nobody, nobody, nobody) != 0))
            _exit(2);
        try {
            _exit(works() ? 0 : 1);
        } catch (...) {
            _exit(3);
        }
    }
    int status = -1;
    return child > 0 && waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}
