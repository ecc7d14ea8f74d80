#pragma once

#include <filesystem>
#include <string_view>

namespace umbral::grader::attack {

/// Generators of long texts, which only grow a source: see generators.hpp.
[[nodiscard]] bool has_text_generator(std::string_view name);
void generate_text(std::string_view name, const std::filesystem::path& submission);

}
