#pragma once

#include <string>
#include <string_view>
#include <system_error>

namespace umbral::grader {

/// What the machine lacks, in words for whoever runs it, with what was tried and the system's own words: "the machine
/// has no process left (fork: Resource temporarily unavailable); …". `error` is an errno value.
[[nodiscard]] std::string machine_trouble(int error, std::string_view tried);

/// The same of a thrown error.
[[nodiscard]] std::string machine_trouble(const std::system_error& error);

}
