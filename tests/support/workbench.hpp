#pragma once

#include <filesystem>
#include <string>

#include "build/builder.hpp"
#include "manifest/units.hpp"
#include "run/spawner.hpp"
#include "support/temporary_folder.hpp"
#include "worker/worker.hpp"

namespace umbral::grader::test {

/// The built Umbral, with a cache of its own that vanishes with the object: builds of one test are never another's.
class Workbench {
public:
    Workbench();

    [[nodiscard]] const Toolchain& tools() const { return tools_; }
    /// The same with the units of tests/fixtures.
    [[nodiscard]] Toolchain fixture_tools() const;
    /// A fresh folder for the test's own files.
    [[nodiscard]] const std::filesystem::path& folder() const { return folder_.path(); }
    [[nodiscard]] Exercise exercise(const std::string& id) const { return load_exercise(tools_.exercises / id); }
    [[nodiscard]] Built build_sphere(const std::string& text) const
    {
        return build(tools_, exercise("raytracing/sphere"), {{"sphere.cpp", text}});
    }
    /// The library that g++ makes of such a file, whatever it holds: assembler too, which build_sphere() refuses. For
    /// tests of what stands behind that refusal. Throws std::runtime_error if it does not compile.
    [[nodiscard]] std::filesystem::path compile_sphere(const std::string& text) const;
    /// A run of one case of raytracing/sphere with a built library.
    [[nodiscard]] RunRequest sphere_run(const std::filesystem::path& library,
                                        const std::string& case_name = "head-on") const;
    [[nodiscard]] std::filesystem::path spawner() const { return tools_.programs / "umbral-spawner"; }

    /// Writes a file below folder(), with the directories it needs, and returns its path.
    std::filesystem::path write(const std::filesystem::path& name, const std::string& text) const;

private:
    umbral::test::TemporaryFolder folder_;
    Toolchain tools_;
};

/// The text of a file of the project: "reference/raytracing/sphere.cpp".
[[nodiscard]] std::string project_file(const std::string& path);

/// A sphere.cpp with the course's own formula: right but for hard cases. `before` comes in front of the function,
/// `first` as its first statements.
[[nodiscard]] std::string sphere_with(const std::string& before, const std::string& first);

}
