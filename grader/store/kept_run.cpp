#include "store/kept_run.hpp"

#include <cstring>
#include <fstream>
#include <iterator>
#include <span>
#include <string_view>
#include <umbral/core/png.hpp>
#include <umbral/record/wire.hpp>

#include "model/digest.hpp"
#include "model/recording.hpp"

namespace umbral::grader {
namespace {

// A file is 64 digits, the SHA-256 of what follows; the times that it took; and a recording as runs hand it over. It is
// read on the machine that wrote it only, and believed only if the digest fits: what is damaged is run again.
constexpr std::size_t digits = 64;

std::size_t size_of_tensors(const KeptRun& run)
{
    std::size_t size = 0;
    for (const auto& [name, tensor] : run.tensors)
        for (const std::size_t part :
             {sizeof(wire::TensorHeader), name.size(), tensor.bytes.size(), tensor.present.size()})
            size += wire::padded(part);
    return size;
}

}

void keep_run(const std::filesystem::path& file, const KeptRun& run)
{
    wire::Header header{};
    header.magic = wire::magic;
    header.stage = static_cast<std::uint32_t>(wire::Stage::finished);
    header.tensor_count = run.tensors.size();
    header.tensors_size = size_of_tensors(run);
    std::string body(sizeof run.times + wire::tensors_offset + header.tensors_size, '\0');
    std::memcpy(body.data(), &run.times, sizeof run.times);
    std::memcpy(body.data() + sizeof run.times, &header, sizeof header);
    (void)wire::write_tensors(run.tensors,
                              std::as_writable_bytes(std::span(body)).subspan(sizeof run.times + wire::tensors_offset));
    const std::string text = sha256_hex(std::string_view(body)) + body;
    write_file_atomically(file, std::as_bytes(std::span(text)));
}

std::optional<KeptRun> kept_run(const std::filesystem::path& file) noexcept
try {
    std::ifstream stream(file, std::ios::binary);
    if (!stream) return std::nullopt;
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    KeptRun run;
    if (text.size() < digits + sizeof run.times) return std::nullopt;
    const std::string_view body = std::string_view(text).substr(digits);
    if (text.compare(0, digits, sha256_hex(body)) != 0) return std::nullopt;
    std::memcpy(&run.times, body.data(), sizeof run.times);
    run.tensors = parse_recording(std::as_bytes(std::span(body.substr(sizeof run.times)))).tensors;
    return run;
} catch (const std::exception&) {
    return std::nullopt;
}

}
