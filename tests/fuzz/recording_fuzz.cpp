#include <algorithm>
#include <cstring>
#include <vector>

#include "fuzz.hpp"
#include "model/recording.hpp"
#include "text/printable.hpp"

// Recordings, as hostile code leaves them. Two parts are cut out, so that what is left is short enough to try millions
// of: of the header's text up to 255 bytes are there, after their number, and what lies between header and tensors is
// zero.
namespace {

using namespace umbral;
using namespace umbral::grader;

constexpr std::size_t before_text = offsetof(wire::Header, text);

std::vector<std::byte> recording_from(const std::uint8_t* data, std::size_t size)
{
    std::vector<std::uint8_t> bytes(wire::tensors_offset);
    const std::size_t head = std::min(size, before_text);
    std::copy_n(data, head, bytes.begin());
    if (size > before_text) {
        const std::uint8_t* rest = data + before_text + 1;
        std::size_t left = size - before_text - 1;
        const std::size_t text = std::min<std::size_t>(data[before_text], left);
        std::copy_n(rest, text, bytes.begin() + static_cast<std::ptrdiff_t>(before_text));
        bytes.insert(bytes.end(), rest + text, rest + left);
    }
    std::vector<std::byte> copy(bytes.size());
    std::memcpy(copy.data(), bytes.data(), bytes.size());
    return copy;
}

void check(const std::vector<std::byte>& bytes, const WantedTensors& wanted)
{
    (void)tests::reads<DamagedRecording>([&] {
        const Recording recording = parse_recording(bytes, wanted);
        tests::expect(printable(recording.text, 3 * recording.text.size() + 1) == recording.text,
                      "a text that cannot be printed");
        std::size_t sum = 0;
        for (const auto& [name, tensor] : recording.tensors) {
            tests::expect(printable(name, 3 * name.size()) == name, "a name that cannot be printed");
            tests::expect(tensor.bytes.size() == tensor.count() * size_of(tensor.element),
                          "values that are not as many as the shape says");
            tests::expect(tensor.present.empty() || tensor.present.size() == tensor.cells(),
                          "flags that are not as many as cells");
            if (!wanted.empty())
                tests::expect(wanted.contains(name) && tensor.cells() <= wanted.at(name),
                              "a tensor that nobody asked for");
            sum += tensor.bytes.size() + tensor.present.size();
        }
        tests::expect(sum <= bytes.size(), "more values than bytes");
    });
}

}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::vector<std::byte> bytes = recording_from(data, size);
    check(bytes, {});
    check(bytes, {{"t", 3}, {"matrix", 1}});
    return 0;
}
