#pragma once

#include <cstddef>
#include <map>
#include <string>

namespace umbral::grader {

/// Where the files that debug information names lie. A path of theirs may go through links, and what `..` behind a link
/// leads to, its text does not say: a header that is read by such a path would be nobody's. What is not there keeps its
/// path, made plain; without a directory it is a student's own file. Each path is looked up once.
class RealPaths {
public:
    /// The path without links, `.` and `..`.
    [[nodiscard]] const std::string& of(const std::string& path);

    /// Other paths than any source leads to by its includes; hostile ones spell one in as many ways as they like.
    [[nodiscard]] bool too_many() const { return known_.size() > most; }

private:
    static constexpr std::size_t most = 4096;

    std::map<std::string, std::string> known_;
};

}
