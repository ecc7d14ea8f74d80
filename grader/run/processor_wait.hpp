#pragma once

#include "run/descriptor.hpp"

namespace umbral::grader {

/// How long a process of one thread has been ready to compute while others had the processors, as the kernel counts it
/// (proc(5), schedstat). Who sleeps or computes does not wait.
class ProcessorWait {
public:
    /// `process` is the pidfd of a process that has not been waited for.
    explicit ProcessorWait(int process);

    /// 0 if the kernel does not count it, or the process is over.
    [[nodiscard]] double seconds() const;

private:
    Descriptor statistics_;
};

}
