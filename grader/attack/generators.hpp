#pragma once

#include <filesystem>
#include <string_view>

namespace umbral::grader::attack {

/// Is there a generator of this name?
[[nodiscard]] bool has_generator(std::string_view name);

/// Adds to a submission what git cannot hold: pipes, loops of links, folders without rights, huge files, names made of
/// bytes. Generators may rename the submission's own folder within the class. Throws std::runtime_error if the name is
/// unknown or the disk is full.
void generate(std::string_view name, const std::filesystem::path& submission);

}
