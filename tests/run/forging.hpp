#pragma once

#include <string>

namespace umbral::grader::test {

/// C++ that finds the run's own recording: every page that can be read is looked at for the magic number. The kernel
/// says which pages can be read: rt_sigprocmask gives EFAULT for the others.
inline const std::string find_recording = R"(
#include <umbral/record/wire.hpp>
#include <cstring>
namespace {
using umbral::wire::Header;

bool readable(std::uintptr_t page) { return raw(SYS_rt_sigprocmask, 99, page, 0, 8) != -EFAULT; }

/// The first page of [from, to) that begins with the magic number, or null.
Header* search(std::uintptr_t from, std::uintptr_t to)
{
    for (std::uintptr_t page = from; page < to; page += 4096)
        if (readable(page) && *reinterpret_cast<const std::uint64_t*>(page) == umbral::wire::magic)
            return reinterpret_cast<Header*>(page);
    return nullptr;
}

Header* find()
{
    // The recording is far longer than a stride, so that one of the pages asked lies in it, and what can be read around
    // that one is searched from its lower end on: the recording's magic number is at its beginning.
    const std::uintptr_t stride = 1U << 20U;
    const std::uintptr_t here = reinterpret_cast<std::uintptr_t>(&readable) & ~std::uintptr_t{4095};
    const std::uintptr_t reach = std::uintptr_t{4} << 30U;
    std::uintptr_t low = here;
    while (readable(low)) low -= stride;
    std::uintptr_t high = here;
    while (readable(high)) high += stride;
    if (Header* found = search(low, high)) return found;
    for (std::uintptr_t distance = 0; distance < reach; distance += stride) {
        if (readable(low - distance)) {
            const std::uintptr_t to = low - distance + stride;
            while (readable(low - distance)) distance += stride;
            if (Header* found = search(low - distance, to)) return found;
        }
    }
    for (std::uintptr_t distance = 0; distance < reach; distance += stride)
        if (readable(high + distance))
            if (Header* found = search(high + distance - stride, high + distance + stride)) return found;
    return nullptr;
}

[[noreturn]] void leave() { for (;;) raw(SYS_exit_group, 0); }

/// Puts a tensor behind those that are there.
void put(Header* h, const char* name, umbral::wire::TensorHeader t, std::size_t bytes, unsigned char fill)
{
    char* at = reinterpret_cast<char*>(h) + umbral::wire::tensors_offset + h->tensors_size;
    t.name_size = static_cast<std::uint32_t>(std::strlen(name));
    std::memcpy(at, &t, sizeof t);
    std::memcpy(at + sizeof t, name, t.name_size);
    char* data = at + sizeof t + umbral::wire::padded(t.name_size);
    std::memset(data, fill, bytes);
    char* end = data + umbral::wire::padded(bytes);
    const std::size_t cells = std::size_t{t.rows} * t.columns;
    if (t.has_present) { std::memset(end, fill ? 1 : 0, cells); end += umbral::wire::padded(cells); }
    h->tensors_size += static_cast<std::uint64_t>(end - at);
    ++h->tensor_count;
}
void finish(Header* h) { h->stage = 4; h->note = 0; leave(); }
}
)";

}
