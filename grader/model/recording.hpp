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

/// The names of tensors that are looked at, and how many cells each may have. Others are passed over, whatever they
/// hold.
using WantedTensors = std::map<std::string, std::size_t, std::less<>>;

/// A tensor that has more cells than it may.
struct Oversized {
    std::uint32_t rows = 0;
    std::uint32_t columns = 0;
    Tensor beginning{};  ///< of a table, as many rows as it may have; nothing of a picture
};

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
    std::uint32_t asked = 0;            ///< questions begun, in runs of student's code …
    std::string function{};             ///< … and what the last one called
    std::map<std::string, Tensor, std::less<>> tensors;
    std::map<std::string, Oversized, std::less<>> oversized{};
};

/// The recording is not one that a run can have written by itself: the student's code overwrote it.
class DamagedRecording : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Reads a recording that hostile code may have written. Copies what it returns; never reads outside `bytes`; never
/// allocates more than a small multiple of their size. Throws DamagedRecording with what was expected, what came and at
/// which offset. If names are `wanted`, only those tensors are copied and checked, as far as they have no more cells
/// than they may.
[[nodiscard]] Recording parse_recording(std::span<const std::byte> bytes, const WantedTensors& wanted = {});

}
