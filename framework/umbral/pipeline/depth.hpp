#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <umbral/core/grid.hpp>
#include <umbral/core/not_implemented.hpp>
#include <umbral/pipeline/rasterize.hpp>
#include <vector>

namespace umbral::pipeline {

/// How a fragment's depth must compare with the one stored in its pixel for the fragment to pass: "incoming less than
/// stored", and so on.
enum class DepthFunction : std::uint8_t { never, less, equal, less_equal, greater, not_equal, greater_equal, always };

/// What a depth buffer can hold of a depth in [0, 1]: 65536 or 16777216 equidistant values, the first 0 and the last 1;
/// or any float.
enum class DepthFormat : std::uint8_t { unorm16, unorm24, float32 };

/// The state of the depth test; the values here are those of OpenGL once the test is enabled.
struct DepthState {
    bool enabled = true;                           ///< if not, every fragment passes and the buffer keeps what it has
    DepthFunction function = DepthFunction::less;  ///< glDepthFunc
    bool writes = true;                            ///< glDepthMask: if not, the test is made, but nothing is stored
    DepthFormat format = DepthFormat::float32;     ///< of the depth buffer that it is used with
};

/// The colour of a triangle's pixels: that of its last vertex, or blended from all three by the fragment's weights
/// (glShadeModel).
enum class ShadeModel : std::uint8_t { flat, smooth };

/// A picture with depths, of equal size: what a scene leaves behind. Depths are values that the format has: what
/// `stored_depth` gives.
struct Layer {
    Grid<glm::vec3> colors;
    Grid<float> depths;
};

/// Whether a fragment of depth `incoming` passes against `stored`.
[[nodiscard]] bool depth_passes(DepthFunction function, float incoming, float stored);

/// What a depth buffer of this format keeps of a depth: clamped to [0, 1], and the nearest value k / (2^b - 1) for b
/// bits, as a float.
///
/// That float may be 2 ulp off, as when k is multiplied by 1 / (2^b - 1) in float, but all depths of one k give the
/// same one, and what is kept already stays as it is; with 24 bits only below 1/4, since 2 ulp are a step above that.
/// (Different k give different floats, with 24 bits too.) The tie at 1/2 goes up. Float keeps a depth in [0, 1] as it
/// is.
[[nodiscard]] float stored_depth(DepthFormat format, float depth);

/// Tests fragments in their order: removes those that fail, keeps the others in order, and stores the depths of those
/// that pass, unless the state forbids it. A fragment is compared as `stored_depth` of its depth, so that rounding
/// comes before comparing.
///
/// `Fragment::depth` itself stays as it was. Pixels lie within the buffer; depths are no NaN. A pixel may occur several
/// times: each fragment is compared with what those before it left. What remains is what an early depth test lets the
/// fragment shader see.
void test_depth(const DepthState& state, std::vector<Fragment>& fragments, Grid<float>& depths);

/// Tests the fragments of a triangle whose vertices have these colours, and writes the colour of those that pass;
/// depths as `test_depth` does. Course: Z-buffer, glDepthFunc, glShadeModel.
void draw_fragments(const DepthState& state, ShadeModel model, const std::array<glm::vec3, 3>& colors,
                    const std::vector<Fragment>& fragments, Layer& target);

/// Mixes two pictures by depth: colour and depth of `source` replace those of `target` in each pixel where they pass
/// `state`'s test; as if all of `source` had been drawn once more. Layers have equal sizes; throws
/// std::invalid_argument if not. Course: "the Z-buffer can be used to mix images".
void merge_layers(const DepthState& state, const Layer& source, Layer& target);

}
