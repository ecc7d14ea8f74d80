#pragma once

#include <filesystem>
#include <string>

#include "collect/handed.hpp"
#include "manifest/units.hpp"
#include "support/temporary_folder.hpp"

namespace umbral::grader::test {

/// A fresh folder for one submission, and what reading it needs.
class Desk {
public:
    [[nodiscard]] Exercise exercise(const std::string& id) const
    {
        return load_exercise(std::filesystem::path(UMBRAL_SOURCE_DIR) / "exercises" / id);
    }
    [[nodiscard]] ArchiveTools tools() const
    {
        return {std::filesystem::path(UMBRAL_BUILD_DIR) / "bin", folder_ / "scratch"};
    }
    /// The submission; made when the first file is written.
    [[nodiscard]] std::filesystem::path folder() const { return folder_ / "work"; }
    /// Beside the submission.
    [[nodiscard]] std::filesystem::path elsewhere() const { return folder_ / "elsewhere"; }
    void write(const std::string& path, std::string_view text) const { folder_.write("work/" + path, text); }

    /// What is read where no unit is asked for: all that is found.
    [[nodiscard]] SubmittedFiles submitted() const { return read_submission(folder(), {}, tools()); }
    [[nodiscard]] Handed collected(const std::string& unit = "raytracing/sphere") const
    {
        const Exercise asked = exercise(unit);
        return collect(read_submission(folder(), {&asked, 1}, tools()), asked);
    }

private:
    umbral::test::TemporaryFolder folder_;
};

}
