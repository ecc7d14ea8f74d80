#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <string_view>

#include "model/scratch.hpp"

namespace umbral::test {

/// A fresh folder for one test, removed with all it holds when it goes out of scope.
class TemporaryFolder : public grader::ScratchFolder {
public:
    TemporaryFolder() : ScratchFolder(std::filesystem::temp_directory_path()) {}

    [[nodiscard]] std::filesystem::path operator/(const std::filesystem::path& name) const { return path() / name; }
    /// How many files and folders it holds.
    [[nodiscard]] auto count() const { return std::distance(std::filesystem::directory_iterator(path()), {}); }
    /// Writes a file into it, with the folders above it.
    void write(const std::filesystem::path& name, std::string_view text) const
    {
        std::filesystem::create_directories((path() / name).parent_path());
        std::ofstream stream(path() / name, std::ios::binary);
        if (!(stream << text).flush()) throw std::runtime_error("cannot write " + (path() / name).string());
    }
};

}
