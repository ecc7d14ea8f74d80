#include <span>
#include <umbral/core/png.hpp>

#include "report/html/pages.hpp"

namespace umbral::grader::html {

void write_page(const std::filesystem::path& path, std::string_view page) { write_file_atomically(path, std::as_bytes(std::span(page))); }

}
