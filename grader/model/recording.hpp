#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include <umbral/record/tensor.hpp>
#include <umbral/record/wire.hpp>

namespace umbral::grader {

/// What a run recorded, after every byte of it was checked.
struct Recording {
    wire::Stage stage = wire::Stage::started;
    wire::Note note = wire::Note::none;
    unsigned signal = 0;
    unsigned not_implemented = 0;
    std::uint64_t refused_count = 0;
    std::vector<unsigned> refused;      ///< numbers of the system calls refused
    std::vector<std::uint64_t> frames;  ///< addresses in the student's library at a crash, innermost first
    std::string text;                   ///< printable, valid UTF-8
    std::map<std::string, Tensor, std::less<>> tensors;
};

/// The recording is not one that a run can have written by itself: the student's code overwrote it.
class DamagedRecording : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Reads a recording that hostile code may have written. Copies what it returns; never reads outside `bytes`; never allocates more
/// than a small multiple of their size. Throws DamagedRecording with what was expected, what came and at which offset.
[[nodiscard]] Recording parse_recording(std::span<const std::byte> bytes);

/// Text from a student's process made fit to print and store: invalid UTF-8 and control characters but \n and \t are replaced, and
/// what exceeds `limit` bytes is cut, saying so.
[[nodiscard]] std::string printable(std::string_view text, std::size_t limit);

}
