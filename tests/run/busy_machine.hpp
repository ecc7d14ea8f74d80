#pragma once

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <thread>
#include <vector>

namespace umbral::grader::test {

/// Four programs for each processor that compute as long as this lives, so that all others wait for their turn.
class BusyMachine {
public:
    BusyMachine()
    {
        for (unsigned i = 0; i < 4 * std::thread::hardware_concurrency(); ++i) {
            const pid_t child = fork();
            if (child == 0)
                for (std::atomic<unsigned> turns = 0;;) ++turns;
            children_.push_back(child);
        }
    }
    BusyMachine(const BusyMachine&) = delete;
    BusyMachine& operator=(const BusyMachine&) = delete;
    ~BusyMachine()
    {
        for (const pid_t child : children_)
            if (child > 0) {
                kill(child, SIGKILL);
                waitpid(child, nullptr, 0);
            }
    }

private:
    std::vector<pid_t> children_;
};

}
