#pragma once

#include <cstdint>
#include <string>
#include <vector>

/// Messages between the three roles. Grader and spawner are joined by one SOCK_SEQPACKET socket; each run gets a socket
/// of its own, whose other end only the grader holds, so that the spawner never sees a seed, a recording or a path.
namespace umbral::grader::protocol {

inline constexpr int control_descriptor = 3;                        ///< in the spawner: its end of the control socket
inline constexpr std::size_t output_size = std::size_t{64} << 10U;  ///< what a run can print

/// Spawner to grader, once, when it is ready or cannot get ready. Texts are zero-terminated; protections are separated
/// by '\n'.
struct Hello {
    std::uint32_t version = 2;
    char protections[512] = {};
    char gl[256] = {};
    char trouble[512] = {};  ///< why it cannot get ready; empty if it is
};

/// Grader to spawner, with the run's end of the run socket as ancillary data.
struct Start {
    double wall_seconds = 0;  ///< from the moment when the run is confined
};

/// What our own part of a run may take, from the fork to "confined": far more than it ever does, and no part of the
/// student's time.
inline constexpr double seconds_to_confine = 60;

/// Spawner to grader when the run is over.
struct Ended {
    std::int32_t wait_status = 0;  ///< as waitpid gives it; meaningless if it could not start
    std::uint8_t timed_out = 0;
    std::int32_t could_not_start = 0;  ///< the errno value that kept it from starting, or 0
    std::uint8_t out_of_memory_kill =
        0;  ///< it was killed, and the kernel's killer for lack of memory has been at work
    std::int64_t peak_memory_kib = 0;
    double wall_seconds = 0;    ///< since it was confined
    double waited_seconds = 0;  ///< of these: ready to compute while others had the processors
    double cpu_seconds = 0;
};

/// Grader to run: one byte with these descriptors as ancillary data: the recording, the output, the job as JSON, in
/// which nothing is foreign, and the texts of the student's files that are not C++ (source_frame.hpp), which are read
/// in the sandbox only.
inline constexpr int job_descriptors = 4;

/// Run to grader, on the run's socket: it is in its sandbox and loads the student's library next. A run that never says
/// so failed by our fault; one that does answers for all that follows.
inline constexpr std::uint8_t confined = 1;

}
