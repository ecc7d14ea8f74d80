#include <cstring>
#include <stdexcept>
#include <umbral/record/wire.hpp>

namespace umbral::wire {

std::size_t write_tensors(const Recorder::Tensors& tensors, std::span<std::byte> room)
{
    std::size_t used = 0;
    const auto put = [&](const void* data, std::size_t size) {
        if (padded(size) > room.size() - used)
            throw std::length_error("the case recorded more than " + std::to_string(room.size()) +
                                    " bytes: record fewer rows or smaller pictures");
        if (size != 0) std::memcpy(room.data() + used, data, size);
        used += padded(size);
    };
    if (tensors.size() > maximum_tensors)
        throw std::length_error("the case recorded under more than " + std::to_string(maximum_tensors) + " names");
    for (const auto& [name, tensor] : tensors) {
        if (name.size() > maximum_name)
            throw std::length_error("recording: the name '" + name + "' has more than " + std::to_string(maximum_name) +
                                    " characters");
        const TensorHeader header{static_cast<std::uint32_t>(tensor.element),
                                  tensor.rows,
                                  tensor.columns,
                                  tensor.components,
                                  static_cast<std::uint32_t>(name.size()),
                                  tensor.present.empty() ? 0U : 1U};
        put(&header, sizeof header);
        put(name.data(), name.size());
        put(tensor.bytes.data(), tensor.bytes.size());
        put(tensor.present.data(), tensor.present.size());
    }
    return used;
}

}
