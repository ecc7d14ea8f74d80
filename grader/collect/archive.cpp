#include "collect/archive.hpp"

#include <fmt/format.h>

#include <charconv>
#include <fstream>
#include <optional>
#include <stdexcept>

#include "model/scratch.hpp"
#include "run/confine.hpp"

namespace umbral::grader {
namespace {

/// Takes pieces off the front of what the program printed.
class Pieces {
public:
    explicit Pieces(std::string_view text) : rest_(text) {}

    [[nodiscard]] bool at_end() const { return rest_.empty(); }
    /// The word before the next space or line feed; nothing if there is none within 16 bytes.
    std::optional<std::string_view> word()
    {
        const std::size_t end = rest_.substr(0, 16).find_first_of(" \n");
        if (end == std::string_view::npos) return std::nullopt;
        return take(end, 1);
    }
    std::optional<std::size_t> number(std::size_t most)
    {
        const auto text = word();
        std::size_t value = 0;
        if (!text || text->empty()) return std::nullopt;
        const auto [end, error] = std::from_chars(text->data(), text->data() + text->size(), value);
        if (error != std::errc() || end != text->data() + text->size() || value > most) return std::nullopt;
        return value;
    }
    std::optional<std::string_view> bytes(std::size_t count)
    {
        if (count > rest_.size()) return std::nullopt;
        return take(count, 0);
    }

private:
    std::string_view take(std::size_t count, std::size_t separator)
    {
        const std::string_view piece = rest_.substr(0, count);
        rest_.remove_prefix(count + separator);
        return piece;
    }

    std::string_view rest_;
};

/// One record: a word, the lengths of two texts, and the texts. False at the first thing that is not as it should be.
bool parse_record(Pieces& pieces, std::string_view word, Unpacked& unpacked)
{
    const auto first_size = pieces.number(caps::archive_path);
    const auto second_size = pieces.number(caps::archive_file);
    if (!first_size || !second_size) return false;
    const auto first = pieces.bytes(*first_size);
    const auto second = pieces.bytes(*second_size);
    if (!first || !second) return false;
    const std::string path = harmless_path(*first);
    if (word == "note") {
        if (unpacked.notes.size() < caps::listed) unpacked.notes.push_back(one_line(*second));
    } else if (path.empty()) {
        return false;
    } else if (word == "file") {
        if (unpacked.files.size() < caps::submission_files) unpacked.files.emplace_back(path, *second);
    } else if (word == "ignored") {
        if (unpacked.ignored.size() < caps::submission_ignored) unpacked.ignored.push_back({path, one_line(*second)});
    } else {
        return false;
    }
    return true;
}

}

Unpacked parse_unpacked(std::string_view output)
{
    Unpacked unpacked;
    Pieces pieces(output);
    while (const auto word = pieces.word()) {
        if (*word == "end") {
            if (pieces.at_end()) return unpacked;
            break;
        }
        if (!parse_record(pieces, *word, unpacked)) break;
    }
    unpacked.notes.emplace_back("it could not be read to its end");
    return unpacked;
}

Unpacked unpack(const ArchiveTools& tools, std::string_view archive, double seconds)
{
    const ScratchFolder scratch(tools.scratch);
    const std::filesystem::path copy = scratch.path() / "archive";
    std::ofstream stream(copy, std::ios::binary);
    stream << archive;
    if (!stream.flush())
        throw std::runtime_error(
            fmt::format("cannot copy an archive to {}: is the disk full?", tools.scratch.string()));

    ConfinedCommand command;
    command.confine = tools.programs / "umbral-confine";
    command.arguments = {(tools.programs / "umbral-unpack").string(), copy.string()};
    command.directory = scratch.path();
    command.read = {"/usr/lib/locale"};
    command.cpu_seconds = seconds;
    command.wall_seconds = 60;
    command.memory_mib = 1024;
    command.output_limit =
        caps::submission_bytes + caps::archive_file + caps::submission_files * (caps::archive_path + 64);
    const ConfinedResult result = run_confined(command);
    if (result.exit_status == confinement_failed)
        throw std::runtime_error(
            fmt::format("umbral-unpack cannot be run: {}", one_line(result.output, caps::message)));
    // However it ended, what it printed before counts.
    Unpacked unpacked = parse_unpacked(result.output);
    unpacked.cpu_seconds = result.cpu_seconds;
    if (result.stopped != ConfinedResult::Stopped::no)
        unpacked.notes.emplace_back("unpacking it takes too much time or memory");
    return unpacked;
}

}
