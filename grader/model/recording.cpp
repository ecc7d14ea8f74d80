#include "model/recording.hpp"

#include "text/printable.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstring>

namespace umbral::grader {
namespace {

constexpr unsigned largest_signal = 64;
constexpr std::uint32_t maximum_components = 1024;

[[noreturn]] void damaged(std::size_t offset, const std::string& expected, const std::string& got)
{
    throw DamagedRecording(fmt::format(
        "recording, byte {}: expected {}, got {}; the program overwrote the grader's memory", offset, expected, got));
}

void require(bool holds, std::size_t offset, const char* expected, std::uint64_t got)
{
    if (!holds) damaged(offset, expected, std::to_string(got));
}

/// Walks over the tensors. Everything is copied before it is looked at: what is checked is what is used.
class Cursor {
public:
    Cursor(std::span<const std::byte> bytes, std::size_t begin, std::size_t size)
        : bytes_(bytes.subspan(begin, size)), begin_(begin)
    {
    }

    [[nodiscard]] std::size_t offset() const { return begin_ + used_; }
    [[nodiscard]] std::size_t left() const { return bytes_.size() - used_; }

    /// The next `size` bytes; the padding behind them is skipped.
    std::span<const std::byte> take(std::uint64_t size, const char* what)
    {
        if (size > left() || wire::padded(size) > left())
            damaged(offset(), fmt::format("{} of at most {} bytes", what, left()), std::to_string(size));
        const auto taken = bytes_.subspan(used_, size);
        used_ += wire::padded(size);
        return taken;
    }

private:
    std::span<const std::byte> bytes_;
    std::size_t begin_;
    std::size_t used_ = 0;
};

template <class Item>
std::vector<Item> copy(std::span<const std::byte> bytes)
{
    std::vector<Item> items(bytes.size() / sizeof(Item));
    if (!items.empty()) std::memcpy(items.data(), bytes.data(), bytes.size());
    return items;
}

wire::TensorHeader take_header(Cursor& cursor)
{
    const std::size_t offset = cursor.offset();
    wire::TensorHeader header{};
    std::memcpy(&header, cursor.take(sizeof header, "the header of a tensor").data(), sizeof header);
    require(size_of(static_cast<Element>(header.element)) != 0, offset, "an element type from 1 to 5", header.element);
    // Bounds of each number first, so that no product below can wrap around.
    require(header.rows <= wire::maximum_size, offset, "a number of rows that fits into the file", header.rows);
    require(header.columns <= wire::maximum_size, offset, "a number of columns that fits into the file",
            header.columns);
    require(header.components >= 1 && header.components <= maximum_components, offset, "1 to 1024 components",
            header.components);
    const std::uint64_t cells = std::uint64_t{header.rows} * header.columns;
    require(cells <= wire::maximum_size, offset, "a number of cells that fits into the file", cells);
    require(header.name_size >= 1 && header.name_size <= wire::maximum_name, offset, "a name of 1 to 64 bytes",
            header.name_size);
    require(header.has_present <= (cells > 0 ? 1U : 0U), offset, "flag 0, or 1 where there are cells",
            header.has_present);
    return header;
}

void check_presence(const Tensor& tensor, std::size_t offset)
{
    const std::size_t size = tensor.components * size_of(tensor.element);
    for (std::size_t cell = 0; cell < tensor.present.size(); ++cell) {
        require(tensor.present[cell] <= 1, offset, "presence flags of 0 or 1", tensor.present[cell]);
        const auto bytes = std::span(tensor.bytes).subspan(cell * size, size);
        if (tensor.present[cell] == 0 &&
            std::any_of(bytes.begin(), bytes.end(), [](std::byte byte) { return byte != std::byte{0}; }))
            damaged(offset, "bytes 0 where there is no value", "others in cell " + std::to_string(cell));
    }
}

/// Takes one tensor into the recording, or passes over it.
void take_tensor(Cursor& cursor, const WantedTensors& wanted, Recording& recording)
{
    const std::size_t offset = cursor.offset();
    const wire::TensorHeader header = take_header(cursor);
    const std::vector<char> letters = copy<char>(cursor.take(header.name_size, "the name of a tensor"));
    std::string name(letters.begin(), letters.end());
    if (printable(name, wire::maximum_name) != name)
        damaged(offset, "a printable name", fmt::format("'{}'", printable(name, wire::maximum_name)));

    Tensor tensor{static_cast<Element>(header.element), header.rows, header.columns, header.components, {}, {}};
    const auto values = cursor.take(std::uint64_t{tensor.count()} * size_of(tensor.element), "the values of a tensor");
    const auto flags = header.has_present == 1 ? cursor.take(tensor.cells(), "the presence flags of a tensor")
                                               : std::span<const std::byte>();
    const auto asked = wanted.find(name);
    if (!wanted.empty() && asked == wanted.end()) return;
    if (recording.tensors.contains(name) || recording.oversized.contains(name))
        damaged(offset, "a name not used before", fmt::format("'{}'", name));
    const bool oversized = !wanted.empty() && tensor.cells() > asked->second;
    if (oversized) tensor.rows = header.columns == 1 ? static_cast<std::uint32_t>(asked->second) : 0;
    tensor.bytes = copy<std::byte>(values.first(tensor.count() * size_of(tensor.element)));
    tensor.present = copy<std::uint8_t>(flags.first(std::min(flags.size(), tensor.cells())));
    check_presence(tensor, offset);
    if (oversized)
        recording.oversized.emplace(std::move(name), Oversized{header.rows, header.columns, std::move(tensor)});
    else
        recording.tensors.emplace(std::move(name), std::move(tensor));
}

void take_tensors(Recording& recording, const wire::Header& header, std::span<const std::byte> bytes,
                  const WantedTensors& wanted)
{
    require(header.tensors_size <= bytes.size() - wire::tensors_offset, offsetof(wire::Header, tensors_size),
            "a size within the file", header.tensors_size);
    require(header.tensor_count <= wire::maximum_tensors, offsetof(wire::Header, tensor_count), "at most 256 tensors",
            header.tensor_count);
    Cursor cursor(bytes, wire::tensors_offset, header.tensors_size);
    for (std::uint64_t i = 0; i < header.tensor_count; ++i) take_tensor(cursor, wanted, recording);
    require(cursor.left() == 0, cursor.offset(), "no bytes behind the last tensor", cursor.left());
}

}

Recording parse_recording(std::span<const std::byte> bytes, const WantedTensors& wanted)
{
    if (bytes.size() < wire::tensors_offset || bytes.size() > wire::maximum_size)
        damaged(0, fmt::format("{} to {} bytes", wire::tensors_offset, wire::maximum_size),
                std::to_string(bytes.size()));
    wire::Header header{};
    std::memcpy(&header, bytes.data(), sizeof header);
    require(header.magic == wire::magic, offsetof(wire::Header, magic), "\"UMBRAL01\"", header.magic);
    require(header.stage <= static_cast<std::uint32_t>(wire::Stage::finished), offsetof(wire::Header, stage),
            "a stage from 0 to 4", header.stage);
    require(header.note <= static_cast<std::uint32_t>(wire::Note::load_failure), offsetof(wire::Header, note),
            "a note from 0 to 8", header.note);
    require(header.signal <= largest_signal, offsetof(wire::Header, signal), "a signal from 0 to 64", header.signal);
    require(header.frame_count <= std::size(header.frames), offsetof(wire::Header, frame_count), "at most 32 frames",
            header.frame_count);
    const char* end = std::find(std::begin(header.text), std::end(header.text), '\0');
    if (end == std::end(header.text)) damaged(offsetof(wire::Header, text), "a zero behind the text", "none");

    const char* name_end = std::find(std::begin(header.function), std::end(header.function), '\0');
    if (name_end == std::end(header.function))
        damaged(offsetof(wire::Header, function), "a zero behind the name of a function", "none");

    Recording recording;
    recording.asked = header.asked;
    recording.function =
        printable({header.function, static_cast<std::size_t>(name_end - header.function)}, 3 * sizeof header.function);
    recording.stage = static_cast<wire::Stage>(header.stage);
    recording.note = static_cast<wire::Note>(header.note);
    recording.signal = header.signal;
    recording.not_implemented = header.not_implemented;
    recording.refused_count = header.refused_count;
    recording.refused.assign(header.refused,
                             header.refused + std::min<std::size_t>(header.refused_count, std::size(header.refused)));
    recording.frames.assign(header.frames, header.frames + header.frame_count);
    recording.text = printable({header.text, static_cast<std::size_t>(end - header.text)}, 3 * sizeof header.text);
    // Earlier than that the run was still writing them.
    if (recording.stage == wire::Stage::finished) take_tensors(recording, header, bytes, wanted);
    return recording;
}

}
