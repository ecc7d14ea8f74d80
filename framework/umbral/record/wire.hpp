#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <umbral/record/recorder.hpp>

/// How a run hands its recording to the grader: one shared file that begins with a Header; tensors follow at
/// `tensors_offset`.
///
/// The run writes it, so every byte may be hostile: only grader/model/recording.cpp reads it, and it believes nothing.
namespace umbral::wire {

inline constexpr std::uint64_t magic = 0x31304C4152424D55U;  // "UMBRAL01" in memory
inline constexpr std::size_t tensors_offset = 8192;
inline constexpr std::size_t maximum_size = std::size_t{64} << 20U;
inline constexpr std::size_t maximum_name = 64;
inline constexpr std::size_t maximum_tensors = 256;

/// How far a run came. A run that ends before `finished` was stopped by something.
enum class Stage : std::uint32_t { started = 0, confined = 1, loaded = 2, running = 3, finished = 4 };

/// What the run itself could say about its end.
enum class Note : std::uint32_t {
    none = 0,
    uncaught_exception = 1,
    out_of_memory = 2,
    signal = 3,
    stack_overflow = 4,
    compile_error = 5,
    interface_mismatch = 6,
    driver_fault = 7,
    load_failure = 8
};

struct Header {
    std::uint64_t magic;
    std::uint32_t stage;            ///< a Stage
    std::uint32_t note;             ///< a Note
    std::uint32_t signal;           ///< the signal caught, if any
    std::uint32_t not_implemented;  ///< how often a stub was reached
    std::uint64_t tensors_size;     ///< bytes of the tensors, valid when finished
    std::uint64_t tensor_count;
    std::uint64_t library_base;   ///< where the student's library was loaded
    std::uint32_t refused_count;  ///< system calls refused by the sandbox
    std::uint32_t refused[32];    ///< their numbers, the first of them
    std::uint32_t frame_count;
    std::uint64_t frames[32];  ///< return addresses at a crash, innermost first, relative to library_base
    std::uint32_t asked;       ///< questions begun, in runs of student's code
    char function[64];         ///< what the last of them called, zero-terminated
    char text[4096];           ///< text of an exception or of a StudentError, zero-terminated
};
static_assert(sizeof(Header) <= tensors_offset && std::is_trivially_copyable_v<Header>);

/// Each tensor: this, then the name, the bytes and the presence flags, each padded to 8 bytes.
struct TensorHeader {
    std::uint32_t element;
    std::uint32_t rows;
    std::uint32_t columns;
    std::uint32_t components;
    std::uint32_t name_size;
    std::uint32_t has_present;
};

[[nodiscard]] constexpr std::size_t padded(std::size_t size) noexcept { return (size + 7U) & ~std::size_t{7}; }

/// Writes all tensors into `room`; returns the bytes used. Throws std::length_error if they do not fit or a name is too
/// long.
std::size_t write_tensors(const Recorder::Tensors& tensors, std::span<std::byte> room);

}
