#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

/// What dlopen needs of the system calls that the sandbox refuses: opening this run's libraries, and asking for the
/// state of an open file. Neither call ever reaches the kernel with a path, so that no path, whether there is such a
/// file or not, can be told from another.
namespace umbral::grader::emulated_calls {

/// A library that was opened before the sandbox was entered; `path` must outlive the run.
void hand_out_once(const char* path, int descriptor) noexcept;

using Arguments = std::array<std::uint64_t, 4>;

/// The result of a trapped call, as the kernel gives it (-errno for an error); nothing if the call stays refused.
/// Async-signal-safe. An opened library's descriptor is given away once: the loader closes it.
[[nodiscard]] std::optional<std::int64_t> answer(std::uint32_t call, const Arguments& arguments) noexcept;

}
