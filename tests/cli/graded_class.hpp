#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "program.hpp"
#include "support/temporary_folder.hpp"
#include "support/without_times.hpp"

namespace umbral::test {

namespace fs = std::filesystem;
using nlohmann::json;

inline json class_json(const fs::path& out) { return without_times(json::parse(read(out / "class.json"))); }

inline const json& submission(const json& all, const std::string& id)
{
    for (const json& one : all.at("submissions"))
        if (one.at("id") == id) return one;
    throw std::runtime_error("no submission " + id);
}

/// A class of four, of whom one is right, one mistaken, one does not compile, and one handed in nothing.
class GradedClass : public testing::Test {
protected:
    GradedClass()
    {
        hand_in("ana", read(UMBRAL_SOURCE "/reference/raytracing/sphere.cpp"));
        hand_in("bo", read(UMBRAL_SOURCE "/tests/class/carla-typical-mistakes/raytracing/sphere/sphere.cpp"));
        hand_in("cy", "this is no C++\n");
        folder.write("class/dan/README", "sorry");
        folder.write("secret", "a secret of more than 16 characters");
    }

    void hand_in(const std::string& id, const std::string& sphere) const
    {
        folder.write("class/" + id + "/sphere.cpp", sphere);
    }
    [[nodiscard]] std::string arguments(const std::string& out, const std::string& more = "") const
    {
        return "grade " + (folder / "class").string() + " --out " + (folder / out).string() + " --secret-file " +
               (folder / "secret").string() + " --unit sphere --jobs 2 " + more;
    }
    /// With a cache of its own: what others leave in the user's must not help.
    [[nodiscard]] std::string environment() const { return "UMBRAL_CACHE=" + (folder / "cache").string(); }
    [[nodiscard]] Printed grade(const std::string& out, const std::string& more = "") const
    {
        return umbral(arguments(out, more), environment());
    }

    TemporaryFolder folder;
};

}
