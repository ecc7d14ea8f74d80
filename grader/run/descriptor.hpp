#pragma once

#include <unistd.h>

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace umbral::grader {

/// Owns a file descriptor.
class Descriptor {
public:
    Descriptor() = default;
    explicit Descriptor(int number) noexcept : number_(number) {}
    Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
    Descriptor& operator=(Descriptor&& other) noexcept
    {
        std::swap(number_, other.number_);
        return *this;
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() { reset(); }

    [[nodiscard]] int get() const noexcept { return number_; }
    explicit operator bool() const noexcept { return number_ >= 0; }
    /// Lets go of the number, which stays open.
    int release() noexcept { return std::exchange(number_, -1); }
    void reset() noexcept
    {
        if (number_ >= 0) close(std::exchange(number_, -1));
    }

private:
    int number_ = -1;
};

/// Two ends of a SOCK_SEQPACKET socket, close-on-exec. Throws std::system_error.
[[nodiscard]] std::pair<Descriptor, Descriptor> socket_pair();

/// A memory file of exactly `size` bytes that can neither grow nor shrink, so that mapping it never faults. Throws
/// std::system_error.
[[nodiscard]] Descriptor sealed_memory(const char* name, std::size_t size);

/// Sends one packet with descriptors. Throws std::system_error.
void send_packet(int socket, std::span<const std::byte> bytes, std::span<const int> descriptors);

struct Packet {
    bool closed = false;  ///< the other end is gone; nothing was received
    std::size_t size = 0;
    std::vector<Descriptor> descriptors;
};
/// Receives one packet into `room` (what does not fit is cut). Throws std::system_error.
[[nodiscard]] Packet receive_packet(int socket, std::span<std::byte> room);

/// The bytes of a plain struct.
template <class Plain>
[[nodiscard]] std::span<const std::byte> bytes_of(const Plain& plain)
{
    return std::as_bytes(std::span(&plain, 1));
}
template <class Plain>
[[nodiscard]] std::span<std::byte> writable_bytes_of(Plain& plain)
{
    return std::as_writable_bytes(std::span(&plain, 1));
}

}
