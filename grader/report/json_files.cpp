#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <umbral/core/png.hpp>

#include "report/json_files.hpp"

namespace umbral::grader {
namespace {

void write_json(const std::filesystem::path& path, const nlohmann::json& json)
{
    const std::string text = json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
    write_file_atomically(path, std::as_bytes(std::span(text)));
}

}

void write_report_json(const std::filesystem::path& path, const SubmissionResult& result, const Fingerprint& fingerprint)
{
    write_json(path, to_json(result, fingerprint));
}

void write_class_json(const std::filesystem::path& path, const ClassResult& result) { write_json(path, to_json(result)); }

}
