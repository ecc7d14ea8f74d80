#pragma once

#include <cstdint>
#include <string>
#include <vector>

/// Messages between the three roles. Grader and spawner are joined by one SOCK_SEQPACKET socket; each run gets a socket of its
/// own, whose other end only the grader holds, so that the spawner never sees a seed, a recording or a path.
namespace umbral::grader::protocol {

inline constexpr int control_descriptor = 3;                        ///< in the spawner: its end of the control socket
inline constexpr std::size_t output_size = std::size_t{64} << 10U;  ///< what a run can print

/// Spawner to grader, once, when it is ready. `protections` and `gl` are zero-terminated; protections are separated by '\n'.
struct Hello {
    std::uint32_t version = 1;
    char protections[512] = {};
    char gl[256] = {};
};

/// Grader to spawner, with the run's end of the run socket as ancillary data.
struct Start {
    double wall_seconds = 0;
};

/// Spawner to grader when the run is over.
struct Ended {
    std::int32_t wait_status = 0;  ///< as waitpid gives it; meaningless if could_not_start
    std::uint8_t timed_out = 0;
    std::uint8_t could_not_start = 0;
    std::int64_t peak_memory_kib = 0;
    double wall_seconds = 0;
    double cpu_seconds = 0;
};

/// Grader to run: one byte with three descriptors as ancillary data: the recording, the output, and the job as JSON.
inline constexpr int job_descriptors = 3;

/// Run to grader, on the run's socket: it is in its sandbox and loads the student's library next. A run that never says so failed by
/// our fault; one that does answers for all that follows.
inline constexpr std::uint8_t confined = 1;

}
