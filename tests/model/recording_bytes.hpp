#pragma once

#include <cstddef>
#include <cstring>
#include <umbral/record/recorder.hpp>
#include <umbral/record/wire.hpp>
#include <vector>

namespace umbral::grader::test {

inline Recorder observations()
{
    Recorder recorder;
    for (int i = 0; i < 5; ++i)
        recorder.append("t", i % 2 == 0 ? std::optional<float>(static_cast<float>(i) / 2) : std::nullopt);
    recorder.append("matrix", glm::mat4(2.0F));
    recorder.append("count", std::uint32_t{7});
    recorder.append("exact", 0.1);
    recorder.buffer("empty", Grid<float>());
    Grid<glm::u8vec4> picture(3, 2);
    picture.cells[4] = {1, 2, 3, 4};
    recorder.image("größe", picture);
    return recorder;
}

/// The file that a run leaves which ends well.
inline std::vector<std::byte> finished_run(const Recorder& recorder = observations())
{
    std::vector<std::byte> bytes(wire::tensors_offset + 4096);
    wire::Header header{};
    header.magic = wire::magic;
    header.stage = static_cast<std::uint32_t>(wire::Stage::finished);
    header.tensors_size = wire::write_tensors(recorder.tensors(), std::span(bytes).subspan(wire::tensors_offset));
    header.tensor_count = recorder.tensors().size();
    std::memcpy(bytes.data(), &header, sizeof header);
    return bytes;
}

}
