#include "store/kept_run.hpp"

#include <cstring>
#include <fstream>
#include <iterator>
#include <span>
#include <stdexcept>
#include <umbral/core/png.hpp>

#include "model/digest.hpp"

namespace umbral::grader {
namespace {

// A file is 64 digits, the SHA-256 of what follows; then the numbers and names below, in this machine's order of bytes.
// It is read on the machine that wrote it only, and believed only if the digest fits: what is damaged is run again.
constexpr std::uint64_t version = 1;
constexpr std::size_t digits = 64;

class Writer {
public:
    void number(std::uint64_t value) { bytes(std::as_bytes(std::span(&value, 1))); }
    void bytes(std::span<const std::byte> more)
    {
        text_.append(reinterpret_cast<const char*>(more.data()), more.size());
    }
    void field(std::span<const std::byte> more)
    {
        number(more.size());
        bytes(more);
    }
    [[nodiscard]] const std::string& text() const noexcept { return text_; }

private:
    std::string text_;
};

class Reader {
public:
    explicit Reader(std::string_view text) : text_(text) {}

    std::uint64_t number()
    {
        std::uint64_t value = 0;
        std::memcpy(&value, take(sizeof value).data(), sizeof value);
        return value;
    }
    std::string_view field() { return take(number()); }
    [[nodiscard]] bool at_end() const noexcept { return text_.empty(); }

private:
    std::string_view take(std::uint64_t size)
    {
        if (size > text_.size()) throw std::runtime_error("expected more bytes");
        const std::string_view taken = text_.substr(0, size);
        text_.remove_prefix(size);
        return taken;
    }

    std::string_view text_;
};

template <class Value>
std::vector<Value> values(std::string_view field)
{
    const auto* const first = reinterpret_cast<const Value*>(field.data());
    return std::vector<Value>(first, first + field.size());
}

Tensor read_tensor(Reader& reader)
{
    Tensor tensor;
    tensor.element = static_cast<Element>(reader.number());
    tensor.rows = static_cast<std::uint32_t>(reader.number());
    tensor.columns = static_cast<std::uint32_t>(reader.number());
    tensor.components = static_cast<std::uint32_t>(reader.number());
    tensor.bytes = values<std::byte>(reader.field());
    tensor.present = values<std::uint8_t>(reader.field());
    return tensor;
}

}

void keep_run(const std::filesystem::path& file, const KeptRun& run)
{
    Writer body;
    body.number(version);
    body.bytes(std::as_bytes(std::span(&run.cpu_seconds, 1)));
    body.number(run.tensors.size());
    for (const auto& [name, tensor] : run.tensors) {
        body.field(std::as_bytes(std::span(name)));
        for (const std::uint64_t number : {std::uint64_t(tensor.element), std::uint64_t{tensor.rows},
                                           std::uint64_t{tensor.columns}, std::uint64_t{tensor.components}})
            body.number(number);
        body.field(tensor.bytes);
        body.field(std::as_bytes(std::span(tensor.present)));
    }
    const std::string text = sha256_hex(std::string_view(body.text())) + body.text();
    write_file_atomically(file, std::as_bytes(std::span(text)));
}

std::optional<KeptRun> kept_run(const std::filesystem::path& file) noexcept
try {
    std::ifstream stream(file, std::ios::binary);
    if (!stream) return std::nullopt;
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    if (text.size() < digits) return std::nullopt;
    const std::string_view body = std::string_view(text).substr(digits);
    if (text.compare(0, digits, sha256_hex(body)) != 0) return std::nullopt;
    Reader reader(body);
    if (reader.number() != version) return std::nullopt;
    KeptRun run;
    const std::uint64_t seconds = reader.number();
    std::memcpy(&run.cpu_seconds, &seconds, sizeof seconds);
    for (std::uint64_t left = reader.number(); left > 0; --left) {
        const std::string name(reader.field());
        run.tensors[name] = read_tensor(reader);
    }
    if (!reader.at_end()) return std::nullopt;
    return run;
} catch (const std::exception&) {
    return std::nullopt;
}

}
