#pragma once

#include <sys/types.h>

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <umbral/record/cost.hpp>
#include <umbral/record/questions.hpp>

#include "model/exercise.hpp"
#include "model/recording.hpp"
#include "model/verdict.hpp"
#include "run/descriptor.hpp"
#include "run/fresh_memory.hpp"

namespace umbral::grader {

/// One case to run: which driver, whose library, which random numbers.
struct RunRequest {
    std::filesystem::path driver;  ///< absolute
    std::filesystem::path
        solution;  ///< the student's (or another solution's) library, absolute; empty for a unit without C++
    std::map<std::string, std::string> sources;  ///< texts of files that are not C++, by name
    std::string case_name;
    std::uint64_t stream = 0;  ///< what the case's random numbers follow from
    Limits limits;
    WantedTensors wanted{};  ///< of what it records, all that is looked at; empty for everything
    CostLimit costs{};       ///< work on these counted costs only, to measure them from outside; without a table on all
    Inquiry inquiry{};       ///< what is to be told of its questions, of trusted solutions only; and its inputs' grain
    /// As `stream`, of the same case with other inputs: it runs beside, in turns with the first and with one that has
    /// nearly the first one's inputs, and what these record is thrown away (companion.hpp).
    std::optional<std::uint64_t> beside{};
    PassedOver passed_over{};                          ///< questions that the student's code is not asked
    FreshMemory fresh_memory = FreshMemory::nonsense;  ///< what memory holds that was never written
    unsigned mutant = 0;  ///< of a trusted library that holds mutants, the one to run; 0 for what all others are
    /// A library with functions that the solution calls, where the driver has them not; absolute, or empty for none.
    std::filesystem::path used{};
    std::vector<std::string> roots{};  ///< folders of this machine that no text of the run may show (run_text.hpp)
};

/// How a run ended, and what it left.
struct RunOutcome {
    Verdict verdict = Verdict::grader_fault;  ///< ok: it finished (right or wrong); else what stopped it
    std::string message;  ///< what stopped it, for the student; as the other texts printable, bounded and without roots
    Recording recording;  ///< complete if ok; else its notes
    std::string output;   ///< printed text
    std::vector<std::string> refused;  ///< names of system calls that the sandbox refused, each once
    double wall_seconds = 0;           ///< since it entered its sandbox
    double waited_seconds = 0;         ///< of these: ready to compute while others had the processors
    double cpu_seconds = 0;
    std::int64_t peak_memory_kib = 0;  ///< the most that it held at once, with our own part
    bool killed_from_outside = false;  ///< neither its own doing nor our limits ended it
};

/// A spawner process and the talk with it. Serves one run at a time; for parallel work, have one for each thread.
class Spawner {
public:
    /// Starts `program` with an empty environment but for what OpenGL's back ends need, and which of them is to draw:
    /// `gl_backend`
    /// ("osmesa" or "egl"), else what UMBRAL_GL holds. Throws std::runtime_error if it does not get ready.
    explicit Spawner(std::filesystem::path program, const std::string& gl_backend = {});
    Spawner(const Spawner&) = delete;
    Spawner& operator=(const Spawner&) = delete;
    ~Spawner();

    /// Runs one case. Never throws for what the student's code does; a spawner that died is started again once. Throws
    /// std::runtime_error that says what the machine lacks (processes, memory, open files); a later run starts afresh.
    [[nodiscard]] RunOutcome run(const RunRequest& request);

    /// Protections that were seen to work, as "landlock 4"; complete after the constructor.
    [[nodiscard]] const std::vector<std::string>& protections() const noexcept { return protections_; }
    /// What draws, as "OSMesa: 4.5 (Compatibility Profile) Mesa 22.3.6; llvmpipe (LLVM 15.0.6, 256 bits)"; empty for a
    /// spawner without GL.
    [[nodiscard]] const std::string& gl() const noexcept { return gl_; }

private:
    [[nodiscard]] RunOutcome run_once(const RunRequest& request);
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
