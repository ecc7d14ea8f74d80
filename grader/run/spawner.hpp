#pragma once

#include <sys/types.h>

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "model/exercise.hpp"
#include "model/recording.hpp"
#include "model/verdict.hpp"
#include "run/descriptor.hpp"

namespace umbral::grader {

/// One case to run: which driver, whose library, which seed.
struct RunRequest {
    std::filesystem::path driver;                ///< absolute
    std::filesystem::path tenant;                ///< the student's (or another tenant's) library, absolute; empty for a unit without C++
    std::map<std::string, std::string> sources;  ///< texts of files that are not C++, by name
    std::string case_name;
    std::uint64_t seed = 0;
    Limits limits;
};

/// How a run ended, and what it left.
struct RunOutcome {
    Verdict verdict = Verdict::grader_fault;  ///< ok: it finished (right or wrong); else what stopped it
    std::string message;                      ///< what stopped it, for the student
    Recording recording;                      ///< complete if ok; else its notes
    std::string output;                       ///< printed text, made printable
    std::vector<std::string> refused;         ///< names of system calls that the sandbox refused, each once
    double wall_seconds = 0;
    double cpu_seconds = 0;
};

/// A spawner process and the talk with it. Serves one run at a time; for parallel work, have one for each thread.
class Spawner {
public:
    /// Starts `program` with an empty environment but for what OpenGL's back ends need, and which of them is to draw: `gl_backend`
    /// ("osmesa" or "egl"), else what UMBRAL_GL holds. Throws std::runtime_error if it does not get ready.
    explicit Spawner(std::filesystem::path program, const std::string& gl_backend = {});
    Spawner(const Spawner&) = delete;
    Spawner& operator=(const Spawner&) = delete;
    ~Spawner();

    /// Runs one case. Never throws for what the student's code does; a spawner that died is started again once.
    [[nodiscard]] RunOutcome run(const RunRequest& request);

    /// Protections that were seen to work, as "landlock 4"; complete after the constructor.
    [[nodiscard]] const std::vector<std::string>& protections() const noexcept { return protections_; }
    /// What draws, as "OSMesa: 4.5 (Compatibility Profile) Mesa 22.3.6; llvmpipe (LLVM 15.0.6, 256 bits)"; empty for a spawner without GL.
    [[nodiscard]] const std::string& gl() const noexcept { return gl_; }

private:
    void start();
    void stop() noexcept;

    std::filesystem::path program_;
    std::string gl_choice_;  ///< "UMBRAL_GL=…"
    Descriptor control_;
    pid_t process_ = -1;
    std::vector<std::string> protections_;
    std::string gl_;
};

}
